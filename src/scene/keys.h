// SPDX-License-Identifier: MIT
// The keys of a spec as data: what may stand in which table, in which spellings. Made by a visitor
// of the field lists; the reader and the schema share it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/units.h"

namespace polhode {

// One way to write a key: its name with the suffix of one unit.
struct Spelling {
  std::string text;
  UnitSuffix unit;
};

// All ways to write a key, the SI one first.
std::vector<Spelling> spellings_of(const std::string& name, const Doc& doc);

// Keys that exclude each other.
struct KeyGroup {
  std::vector<std::string> names;
  bool one_needed = false;  // false: none of them is fine too
};

struct Key;

// The most tables in one list: parts, points.
inline constexpr std::size_t kMostTables = 1000;

// The most names in one list: methods that a film compares.
inline constexpr std::size_t kMostNames = 9;

// The keys of one table.
struct KeyList {
  std::vector<Key> keys;
  std::vector<KeyGroup> groups;

  const Key& find(const std::string& name) const;  // `name` must be there
  std::vector<std::string> all_spellings() const;
};

struct Key {
  std::string name;
  Doc doc;
  bool required = false;
  bool many = false;              // a list of tables
  std::optional<KeyList> inside;  // of a table or of each table in a list; absent for values
};

// What a member holds, without std::optional and std::vector around it.
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

// A struct with a fields() list, which a scene writes as a table.
template <class T>
concept IsSpec = requires(KeyLister& visitor, T& spec) {
  fields(visitor, spec);
};

// Gathers a KeyList.
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

template <class... Specs>
KeyList make_key_list(Specs... specs) {
  KeyLister lister;
  (fields(lister, specs), ...);
  return lister.list();
}

// The keys of a table that holds these specs; made once.
template <class... Specs>
const KeyList& keys_of() {
  static const KeyList list = make_key_list(Specs{}...);
  return list;
}

// The tables of a scene that have a key of this spelling, as a user names them: "[body]",
// "body.parts[]".
std::vector<std::string> tables_with(const std::string& spelling, const KeyList& root);

}  // namespace polhode
