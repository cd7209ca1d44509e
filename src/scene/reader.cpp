// SPDX-License-Identifier: MIT
#include "scene/reader.h"

#include <algorithm>

#include <fmt/ranges.h>

#include "base/nearest.h"
#include "base/one_line.h"
#include "scene/other_words.h"
#include "scene/toml_text.h"

namespace polhode {
namespace {

// dotted paths stay readable: quotes around what TOML would quote, long keys cut
std::string inside_path(const std::string& path, std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           c == '-';
  });
  const std::string name = bare ? cut(key, 60) : fmt::format("\"{}\"", cut(key, 60));
  return path.empty() ? name : path + "." + name;
}

int line_of(const toml::key& key) {
  return static_cast<int>(key.source().begin.line);
}

Place place_of(const Place& table, const toml::key& key) {
  return {table.file, line_of(key), inside_path(table.key, key.str())};
}

// the key as the file has it, with its place
const toml::key* written_key(const toml::table& table, const std::string& spelling) {
  const auto entry = table.find(spelling);
  return entry == table.end() ? nullptr : &entry->first;
}

// the keys of the table that are a spelling of this one
std::vector<const toml::key*> written_spellings(const toml::table& table, const Key& key) {
  std::vector<const toml::key*> written;
  for (const Spelling& spelling : spellings_of(key.name, key.doc)) {
    if (const toml::key* found = written_key(table, spelling.text)) written.push_back(found);
  }
  return written;
}

// whether the texts differ in one letter only
bool is_one_letter_off(std::string_view a, std::string_view b) {
  if (a.size() != b.size() || a.size() < 2) return false;
  int different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    different += a[i] != b[i] ? 1 : 0;
  return different == 1;
}

// How a key can be written, if `name` is that key with a unit that it does not have; else "". A
// unit of its own that is misspelt by a letter is left to the nearest name.
std::string units_instead(const std::string& name, const KeyList& keys) {
  for (const Key& key : keys.keys) {
    if (key.doc.unit == Unit::none || !name.starts_with(key.name + "_")) continue;
    std::vector<std::string> ways;
    for (const Spelling& spelling : spellings_of(key.name, key.doc)) {
      if (is_one_letter_off(spelling.text, name) && name.size() > key.name.size() + 2) return "";
      ways.push_back(fmt::format("'{}' in {}", spelling.text, spelling.unit.symbol));
    }
    return fmt::format(" (did you mean {}?)", fmt::join(ways, ", "));
  }
  return "";
}

// whether both begin with the same word and an underscore
bool share_first_word(const std::string& a, const std::string& b) {
  const std::size_t end = a.find('_');
  return end != std::string::npos && b.starts_with(a.substr(0, end + 1));
}

void refuse_unknown(const Place& place,
                    const std::string& name,
                    const KeyList& keys,
                    const KeyList& root) {
  const std::string near = nearest_name(name, keys.all_spellings());
  const std::vector<std::string> elsewhere = tables_with(name, root);
  const std::string other_units = units_instead(name, keys);
  // "time_scal" is no time
  const std::string instead = share_first_word(name, near) ? "" : instead_hint(name);
  std::string message = "unknown key";
  if (!elsewhere.empty()) {
    message += fmt::format(" here; '{}' is a key of {}", name, fmt::join(elsewhere, " and "));
    if (!instead.empty()) {
      message += instead;
    } else if (!near.empty()) {
      message += fmt::format(" (or did you mean '{}'?)", near);
    }
  } else if (!other_units.empty()) {
    message += other_units;
  } else if (!instead.empty()) {
    message += instead;
  } else if (!near.empty()) {
    message += fmt::format(" (did you mean '{}'?)", near);
  } else {
    // nothing is near: all names, without their suffixes
    std::vector<std::string> names;
    for (const Key& key : keys.keys)
      names.push_back(key.name);
    message += fmt::format(" (known: {})", fmt::join(names, ", "));
  }
  throw Error(Fault::input, message, place);
}

void check_unknown(const toml::table& table,
                   const Place& place,
                   const KeyList& keys,
                   const KeyList& root) {
  // the tree is sorted by name; the user reads by line
  const std::vector<std::string> known = keys.all_spellings();
  const toml::key* first = nullptr;
  for (const auto& [key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    if (first == nullptr || line_of(key) < line_of(*first)) first = &key;
  }
  if (first != nullptr) {
    refuse_unknown(place_of(place, *first), std::string(first->str()), keys, root);
  }
}

void check_spellings(const toml::table& table, const Place& place, const KeyList& keys) {
  for (const Key& key : keys.keys) {
    const std::vector<const toml::key*> written = written_spellings(table, key);
    if (written.size() < 2) continue;
    throw input_error("give only one of {} and {}", written[0]->str(), written[1]->str())
        .at(place_of(place, *written[1]));
  }
}

void check_group(const toml::table& table,
                 const Place& place,
                 const KeyList& keys,
                 const KeyGroup& group) {
  std::vector<std::string> found;
  Place where = place;
  for (const std::string& name : group.names) {
    for (const toml::key* key : written_spellings(table, keys.find(name))) {
      found.emplace_back(key->str());
      where.line = std::max(where.line, line_of(*key));
    }
  }
  if (found.size() > 1 || (found.empty() && group.one_needed)) {
    throw input_error("give {} one of {}; found {}",
                      group.one_needed ? "exactly" : "at most",
                      fmt::join(group.names, ", "),
                      found.empty() ? "none" : fmt::format("{}", fmt::join(found, " and ")))
        .at(where);
  }
}

void check_required(const toml::table& table, const Place& place, const KeyList& keys) {
  for (const Key& key : keys.keys) {
    if (!key.required || !written_spellings(table, key).empty()) continue;
    const std::string choices =
        key.doc.choices.empty() ? "" : fmt::format(": {}", fmt::join(key.doc.choices, ", "));
    throw input_error(
        "this {} is missing ({}{})", key.inside ? "table" : "key", key.doc.text, choices)
        .at({place.file, place.line, inside_path(place.key, key.name)});
  }
}

}  // namespace

void refuse_no_table(const Found& found) {
  const std::string& key = found.place.key;
  refuse_type(found, "a table", instead_hint(key.substr(key.rfind('.') + 1)));
}

void check_keys(const toml::table& table,
                const Place& place,
                const KeyList& keys,
                const KeyList& root) {
  check_unknown(table, place, keys, root);
  check_spellings(table, place, keys);
  for (const KeyGroup& group : keys.groups)
    check_group(table, place, keys, group);
  check_required(table, place, keys);
}

void refuse_no_flag(const Found& found, const std::string& name, const KeyList& root) {
  std::vector<std::string> elsewhere = tables_with(name, root);
  const std::string own = found.place.key.substr(0, found.place.key.rfind('.'));
  std::erase(elsewhere, "[" + own + "]");
  // 1 means true, and a table of that name is not meant
  const bool is_table = std::any_of(root.keys.begin(), root.keys.end(), [&](const Key& key) {
    return key.name == name && key.inside;
  });
  const bool hint = !elsewhere.empty() && !is_table && !found.node.is_number();
  refuse_type(
      found,
      "true or false",
      hint ? fmt::format("; '{}' is also a key of {}", name, fmt::join(elsewhere, " and ")) : "");
}

std::optional<Found> find_key(const toml::table& table,
                              const Place& place,
                              const std::string& name,
                              const Doc& doc) {
  for (const Spelling& spelling : spellings_of(name, doc)) {
    const auto entry = table.find(spelling.text);
    if (entry == table.end()) continue;
    return Found{entry->second, place_of(place, entry->first), spelling.unit};
  }
  return std::nullopt;
}

}  // namespace polhode
