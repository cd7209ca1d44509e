// SPDX-License-Identifier: MIT
// The keys of a spec as data: which keys a table may have, in which spellings. A visitor of the
// field lists makes it; the reader and the schema use it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/units.h"

namespace polhode {

// A spelling of a key: its name with the suffix of a unit.
struct Spelling {
  std::string text;  // "radius_cm"
  UnitSuffix unit;   // of its suffix
};

// All spellings of a key, the SI one first.
std::vector<Spelling> spellings_of(const std::string& name, const Doc& doc);

// Keys that exclude each other.
struct KeyGroup {
  std::vector<std::string> names;
  bool one_needed = false;  // true: exactly one must be given; false: at most one
};

struct Key;

// The maximum number of tables in a list, such as body.parts.
inline constexpr std::size_t kMostTables = 1000;

// The maximum number of names in a list, such as numerics.compare.
inline constexpr std::size_t kMostNames = 9;
// The maximum length of a text.
inline constexpr std::size_t kLongestText = 2000;  // bytes

// The keys of one table.
struct KeyList {
  std::vector<Key> keys;
  std::vector<KeyGroup> groups;

  // The key of that name; valid as long as this list. Aborts if there is none.
  const Key& find(const std::string& name) const;
  // All spellings of all keys.
  std::vector<std::string> all_spellings() const;
};

// One key.
struct Key {
  std::string name;
  Doc doc;
  bool required = false;
  bool many = false;  // a list: of tables if `inside` is set, else of values
  // The keys of the table, or of each table in the list; absent for values.
  std::optional<KeyList> inside;
};

// The type of a member without std::optional and std::vector; kMany: whether it is a std::vector.
template <class T>
struct Held {
  using type = T;
  static constexpr bool kMany = false;
};
template <class T>
struct Held<std::optional<T>> : Held<T> {};
template <class T>
struct Held<std::vector<T>> : Held<T> {
  static constexpr bool kMany = true;
};

class KeyLister;

// A struct with a fields() list; in a scene file it is a table.
template <class T>
concept IsSpec = requires(KeyLister& visitor, T& spec) {
  fields(visitor, spec);
};

// The visitor (base/fields.h) that makes a KeyList.
class KeyLister {
 public:
  template <class T>
  void field(const char* name, T&, const Doc& doc) {
    add<T>(name, doc, false);
  }
  template <class T>
  void required(const char* name, T&, const Doc& doc) {
    add<T>(name, doc, true);
  }
  template <class A, class B>
  void merged(const char* name, A& a, B& b, const Doc& doc) {
    KeyLister both;
    fields(both, a);
    fields(both, b);
    list_.keys.push_back({name, doc, false, false, both.list_});
  }
  void exactly_one_of(const std::vector<std::string>& names) {
    list_.groups.push_back({names, true});
  }
  void at_most_one_of(const std::vector<std::string>& names) {
    list_.groups.push_back({names, false});
  }
  const KeyList& list() const { return list_; }

 private:
  template <class T>
  void add(const char* name, const Doc& doc, bool required) {
    Key key{name, doc, required, Held<T>::kMany, std::nullopt};
    if constexpr (IsSpec<typename Held<T>::type>) {
      typename Held<T>::type spec;
      KeyLister inside;
      fields(inside, spec);
      key.inside = inside.list_;
    }
    list_.keys.push_back(key);
  }

  KeyList list_;
};

// The keys of all these specs in one list.
template <class... Specs>
KeyList make_key_list(Specs... specs) {
  KeyLister lister;
  (fields(lister, specs), ...);
  return lister.list();
}

// The keys of a table that is read into these specs; made once, valid until the program ends.
template <class... Specs>
const KeyList& keys_of() {
  static const KeyList list = make_key_list(Specs{}...);
  return list;
}

// The tables that have a key with this spelling, as users write them: "[body]", "body.parts[]". For
// hints in error messages. `root`: the keys of the whole scene.
std::vector<std::string> tables_with(const std::string& spelling, const KeyList& root);

}  // namespace polhode
