// SPDX-License-Identifier: MIT
#include "lecture/deck/deck_marks.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "base/error.h"
#include "base/utf8.h"
#include "lecture/deck/pandoc.h"
#include "lecture/deck/tree.h"

namespace polhode {
namespace {

// the two planes of private characters
constexpr unsigned long kFirstPlane = 0xf0000, kSecondPlane = 0x100000;
constexpr std::size_t kInPlane = 0xfffe;

unsigned long private_character(std::size_t i) {
  return i < kInPlane ? kFirstPlane + i : kSecondPlane + i - kInPlane;
}

// in the four bytes of UTF-8
std::string bytes_of(unsigned long character) {
  std::string bytes = {static_cast<char>(0xf0 | (character >> 18))};
  for (const int shift : {12, 6, 0})
    bytes += static_cast<char>(0x80 | ((character >> shift) & 0x3f));
  return bytes;
}

void add_private_characters(std::set<unsigned long>& found, const Json& tree) {
  if (tree.is_string()) {
    const std::string& text = tree.get_ref<const std::string&>();
    for (std::size_t i = 0; i < text.size(); i += std::max<std::size_t>(1, utf8_length(text, i)))
      if (character_at(text, i) >= kFirstPlane) found.insert(character_at(text, i));
  }
  if (!tree.is_structured()) return;
  for (const Json& child : tree)
    add_private_characters(found, child);
}

// What is defined once stands in the tree as often as it is used. Whether there may be such a
// thing.
bool has_repeats(const Json& tree) {
  std::set<std::string> seen;
  bool found = false;
  for_each_node(tree, [&](const Json& node) {
    const std::string type = node["t"];
    if (type == "Note") found = !seen.insert(node["c"].dump()).second || found;
    if (type == "Link" || type == "Image")
      found = !seen.insert(node["c"][2][0].get<std::string>()).second || found;
  });
  return found;
}

// The deck with a character of its own at the beginning of each footnote (of the first plane) and
// of each place to which a reference leads (of the second).
std::string with_marked_definitions(const std::string& text) {
  static const std::regex definition(
      R"(^[\s>]{0,40}(([-*+:]|\(?[0-9A-Za-z]{1,9}[.)])\s{1,9}){0,3}\[(\^?)[^\]]{1,80}\]:\s{0,20}<?)");
  constexpr int kCaret = 3;
  std::string all;
  std::size_t notes = 0, places = 0;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::smatch found;
    if (line.size() <= kLongestSearched && std::regex_search(line, found, definition)) {
      const auto end = static_cast<std::size_t>(found.length());
      if (found.length(kCaret) > 0 && notes < kInPlane) {
        line.insert(end, bytes_of(private_character(notes++)) + " ");
      } else if (found.length(kCaret) == 0 && places < kInPlane) {
        line.insert(end, bytes_of(private_character(kInPlane + places++)) + "/");
      }
    }
    all += line + "\n";
  }
  return all;
}

}  // namespace

std::vector<bool> are_read(const std::string& text, const std::vector<Spot>& spots) {
  std::vector<bool> read(spots.size(), true);
  const std::size_t marked = std::min(spots.size(), 2 * kInPlane);
  std::string with_marks;
  std::size_t from = 0;
  for (std::size_t i = 0; i < marked; ++i) {
    with_marks.append(text, from, spots[i].at - from);
    for (std::size_t k = 0; k < spots[i].word.size(); ++k)
      if (!is_continuation(spots[i].word, k)) with_marks += bytes_of(private_character(i));
    from = spots[i].at + spots[i].word.size();
  }
  with_marks.append(text, from);
  std::set<unsigned long> found;
  try {
    add_private_characters(found, read_markdown(with_marks));
  } catch (const Error& error) {
    if (error.fault() != Fault::input) throw;
    return read;
  }
  for (std::size_t i = 0; i < marked; ++i)
    read[i] = found.contains(private_character(i));
  return read;
}

std::optional<Json> tree_with_marks(const std::string& text, const Json& tree) {
  if (text.find("]:") == std::string::npos || !has_repeats(tree)) return std::nullopt;
  try {
    return read_markdown(with_marked_definitions(text));
  } catch (const Error& error) {
    if (error.fault() != Fault::input) throw;
    return std::nullopt;  // too much for pandoc with them
  }
}

std::optional<unsigned long> mark_of(const Json& part, Definition kind) {
  const unsigned long first = kind == Definition::footnote ? kFirstPlane : kSecondPlane;
  std::set<unsigned long> marks;
  add_private_characters(marks, part);
  const auto mark = marks.lower_bound(first);
  if (mark == marks.end() || *mark >= first + kInPlane) return std::nullopt;
  return *mark;
}

}  // namespace polhode
