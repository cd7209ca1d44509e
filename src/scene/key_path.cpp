// SPDX-License-Identifier: MIT
#include "scene/key_path.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/name_list.h"
#include "base/one_line.h"
#include "base/units.h"
#include "scene/toml_text.h"

namespace polhode {
namespace {

// "motion.spin.body[2]" to its parts "motion", "spin", "body" and 2
struct PathPart {
  std::string key;
  long index = -1;  // in the list of the part before; -1: a key
};
std::vector<PathPart> parts_of(const std::string& path) {
  constexpr std::size_t kMost = 100;  // trees are walked by functions that call themselves
  constexpr std::size_t kShown = 60;
  const Error no_key =
      input_error("'{}' is not a key; write motion.spin.body[2] or the like", cut(path, kShown));
  std::vector<PathPart> parts;
  for (std::size_t i = 0; i < path.size();) {
    if (parts.size() == kMost)
      throw input_error("'{}' has more than {} parts", cut(path, kShown), kMost);
    if (path[i] == '[') {
      const std::size_t end = path.find(']', i);
      const std::string inside = path.substr(i + 1, end == std::string::npos ? end : end - i - 1);
      const bool digits = !inside.empty() && inside.size() < 6 &&
                          (inside == "0" || inside.front() != '0') &&
                          inside.find_first_not_of("0123456789") == std::string::npos;
      if (end == std::string::npos || !digits) throw no_key;
      parts.push_back({"", std::stol(inside)});
      i = end + 1;
    } else {
      if (path[i] == '.' && i > 0) ++i;
      const std::size_t end = std::min(path.find_first_of(".[", i), path.size());
      const bool bare =
          std::all_of(path.begin() + static_cast<std::ptrdiff_t>(i),
                      path.begin() + static_cast<std::ptrdiff_t>(end),
                      [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
      if (end == i || !bare) throw no_key;
      parts.push_back({path.substr(i, end - i), -1});
      i = end;
    }
  }
  return parts;
}

// the node inside `node` that a part names; null if it is not there
const toml::node* inside(const toml::node& node, const PathPart& part) {
  if (part.index < 0) {
    const toml::table* table = node.as_table();
    return table == nullptr ? nullptr : table->get(part.key);
  }
  const toml::array* array = node.as_array();
  return array == nullptr ? nullptr : array->get(static_cast<std::size_t>(part.index));
}

// a table with one more key, or another value of it in whatever spelling it has
template <class Value>
void assign(toml::table& table, const std::string& key, const Value& value) {
  std::vector<std::string> others;
  for (const auto& [other, node] : table) {
    if (other.str() != key && without_suffix(std::string(other.str())) == without_suffix(key))
      others.emplace_back(other.str());
  }
  for (const std::string& other : others)
    table.erase(other);
  table.insert_or_assign(key, value);
}

// Puts a value of that kind, such as "number", at a path; `fits` tells whether it may stand where
// this node is, or null where there is none yet. A key that is not there is made, for the strict
// reader to judge; a place in a list is not.
template <class Value, class Fits>
void replace(toml::table& tree,
             const std::string& path,
             const char* kind,
             const Value& value,
             const Fits& fits) {
  const std::vector<PathPart> parts = parts_of(path);
  if (parts.empty()) throw input_error("'' is not a key");
  toml::node* node = &tree;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PathPart& part = parts[i];
    const bool last = i + 1 == parts.size();
    auto* next = const_cast<toml::node*>(inside(*node, part));
    toml::table* table = node->as_table();
    if (part.index >= 0) {
      if (next == nullptr || (last && !fits(next)))
        throw input_error("the scene has no {} at '{}'", kind, path);
      if (last) {
        toml::array& array = *node->as_array();
        array.replace(array.begin() + part.index, value);
        return;
      }
    } else if (table == nullptr || (last && !fits(next))) {
      throw input_error("the scene has no {} at '{}'", kind, path);
    } else if (last) {
      assign(*table, part.key, value);
      return;
    } else if (next == nullptr) {
      next = &table->insert_or_assign(part.key, toml::table{}).first->second;
    }
    node = next;
  }
}

}  // namespace

std::string without_suffix(const std::string& key) {
  for (const std::string& suffix : all_suffixes()) {
    if (key.size() > suffix.size() && key.ends_with(suffix)) {
      return key.substr(0, key.size() - suffix.size());
    }
  }
  return key;
}

std::string without_suffixes(const std::string& path) {
  std::string out;
  for (std::size_t i = 0; i < path.size();) {
    const std::size_t end = std::min(path.find_first_of(".[]", i), path.size());
    out += without_suffix(path.substr(i, end - i));
    if (end < path.size()) out += path[end];
    i = end + 1;
  }
  return out;
}

namespace {

// an integer of more digits than TOML has
bool is_long_number(std::string_view text) {
  constexpr std::size_t kMostDigits = 18;
  return text.find_first_not_of("+-_0123456789") == std::string_view::npos &&
         std::count_if(text.begin(), text.end(), [](unsigned char c) {
           return std::isdigit(c) != 0;
         }) > static_cast<std::ptrdiff_t>(kMostDigits);
}

// A list of words without quotes, which shells take away: [omega, energy].
std::optional<toml::array> list_of_words(std::string_view text) {
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return {};
  toml::array list;
  for (const std::string& word : split_names(text.substr(1, text.size() - 2))) {
    const bool is_word = !word.empty() &&
                         std::isalpha(static_cast<unsigned char>(word.front())) != 0 &&
                         std::all_of(word.begin(), word.end(), [](unsigned char c) {
                           return std::isalnum(c) != 0 || c == '_';
                         });
    if (!is_word) return {};
    list.push_back(word);
  }
  return list;
}

}  // namespace

const toml::node* node_at(const toml::table& tree, const std::string& path) {
  const toml::node* node = &tree;
  for (const PathPart& part : parts_of(path)) {
    node = inside(*node, part);
    if (node == nullptr) return nullptr;
  }
  return node;
}

void replace_number(toml::table& tree, const std::string& path, double value) {
  replace(tree, path, "number", value, [](const toml::node* node) {
    return node == nullptr || node->is_number();
  });
}

void replace_node(toml::table& tree, const std::string& path, const toml::node& value) {
  value.visit([&](const auto& node) {
    replace(tree, path, "value", node, [](const toml::node*) { return true; });
  });
}

void replace_value(toml::table& tree, const std::string& path, const std::string& value) {
  toml::table parsed;
  try {
    parsed = parse_toml("value = " + value, "");
  } catch (const Error& error) {
    if (const std::optional<toml::array> words = list_of_words(value)) {
      replace_node(tree, path, *words);
      return;
    }
    // what begins as a text, list or table was meant as one
    if (value.empty() || std::string_view("\"'[{").find(value.front()) != std::string_view::npos) {
      const bool is_table = value.starts_with('{');
      throw input_error(
          "{}{}", error.message(), is_table ? "; words in braces need quotes, as in the file" : "");
    }
    if (is_long_number(value))
      throw input_error("'{}' is beyond what an integer holds; write 1e20 or the like", value);
    replace_node(tree, path, toml::value<std::string>(value));
    return;
  }
  if (parsed.size() != 1) throw input_error("'{}' is more than one value", value);
  replace_node(tree, path, *parsed.get("value"));
}

}  // namespace polhode
