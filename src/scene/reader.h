// SPDX-License-Identifier: MIT
// The visitor that fills a spec from a TOML table. Unknown keys are errors.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "scene/keys.h"
#include "scene/values.h"

namespace polhode {

// Checks the keys of a table against `keys`. Throws Error (input), with file, line and key, for an
// unknown key, two spellings of one key, keys that exclude each other, and missing keys. `place` is
// the place of the table; `root` is the list of the whole scene, for hints.
void check_keys(const toml::table& table,
                const Place& place,
                const KeyList& keys,
                const KeyList& root);

// Throws Error (input) for a value that is no table; the message says what else the word of its key
// may be.
[[noreturn]] void refuse_no_table(const Found& found);

// The value of a key in any of its spellings, which refers to the table; absent if the key is.
std::optional<Found> find_key(const toml::table& table,
                              const Place& place,
                              const std::string& name,
                              const Doc& doc);

// Throws Error (input) for a value of the key `name` that is neither true nor false; the message
// says which other tables have a key of that name, which may have been meant.
void refuse_no_flag(const Found& found, const std::string& name, const KeyList& root);

// Fills specs from one table whose keys have been checked. Members whose keys are absent keep their
// values. Throws Error (input) as read_value and check_keys do, and for too many tables in a list.
class Reader {
 public:
  // `place` is the place of the table. The table and `root` must outlive the reader.
  Reader(const toml::table& table, const Place& place, const KeyList& root)
      : table_(table), place_(place), root_(root) {}

  template <class T>
  void field(const char* name, T& member, const Doc& doc) {
    if (const std::optional<Found> found = find_key(table_, place_, name, doc)) {
      if constexpr (std::is_same_v<typename Held<T>::type, bool>) {
        if (!found->node.is_boolean()) refuse_no_flag(*found, name, root_);
      }
      read(*found, doc, member);
    }
  }
  template <class T>
  void required(const char* name, T& member, const Doc& doc) {
    field(name, member, doc);
  }
  template <class A, class B>
  void merged(const char* name, A& a, B& b, const Doc& doc) {
    if (const std::optional<Found> found = find_key(table_, place_, name, doc)) {
      read_tables(*found, a, b);
    }
  }
  // These do nothing, because check_keys() has checked that.
  void exactly_one_of(const std::vector<std::string>&) {}
  void at_most_one_of(const std::vector<std::string>&) {}

  // Checks the keys of a table against the lists of all specs, and reads it into them.
  template <class... Specs>
  void read_tables(const Found& found, Specs&... specs) {
    const toml::table* table = found.node.as_table();
    if (table == nullptr) refuse_no_table(found);
    check_keys(*table, found.place, keys_of<Specs...>(), root_);
    Reader inside(*table, found.place, root_);
    (fields(inside, specs), ...);
  }

 private:
  template <class T>
  void read(const Found& found, const Doc& doc, T& member) {
    if constexpr (IsSpec<T>) {
      read_tables(found, member);
    } else {
      read_value(found, doc, member);
    }
  }
  template <class T>
  void read(const Found& found, const Doc& doc, std::optional<T>& member) {
    read(found, doc, member.emplace());
  }
  template <class Spec>
  requires IsSpec<Spec>
  void read(const Found& found, const Doc&, std::vector<Spec>& member) {
    const toml::array& array = array_of(found, 0, "a list of tables, such as [{ ... }, { ... }]");
    if (array.size() > kMostTables) {
      refuse(found,
             fmt::format("has {} tables; at most {} are allowed", array.size(), kMostTables));
    }
    member.resize(array.size());
    for (std::size_t i = 0; i < array.size(); ++i)
      read_tables(element_of(found, array, i), member[i]);
  }

  const toml::table& table_;
  Place place_;
  const KeyList& root_;
};

}  // namespace polhode
