// SPDX-License-Identifier: MIT
// Gives pandoc a deck once more with marks in it, to see what it does with each part. Marks are
// characters that mean nothing to anybody and that pandoc keeps: those of private use beyond the
// first plane (Unicode 15, section 23.5).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"

namespace polhode {

// Bytes of the longest line that is searched for what marks something: that takes a microsecond for
// each.
inline constexpr std::size_t kLongestSearched = 2000;

// A word at a place in the text of a deck, bytes from its start.
struct Spot {
  std::size_t at = 0;
  std::string_view word;
};
// Whether pandoc reads the word at each of these spots, which are in the order of the text. Each
// has a mark in its place, repeated so that columns stay where they are. Spots beyond the number of
// marks (131068) count as read, as do all if pandoc cannot read the deck with them.
std::vector<bool> are_read(const std::string& text, const std::vector<Spot>& spots);

// What a deck defines once, and pandoc's tree has as often as it is used: the words of a footnote,
// and the place to which a reference leads.
enum class Definition { footnote, place };
// The tree of a deck (as read_markdown() in lecture/deck/pandoc.h returns it) with a mark at the
// beginning of each definition. None if nothing in its `tree` is used more than once, or if pandoc
// cannot read the deck with marks.
std::optional<Json> tree_with_marks(const std::string& text, const Json& tree);
// The mark of a definition in that part of a tree; none if it has none.
std::optional<unsigned long> mark_of(const Json& part, Definition kind);

}  // namespace polhode
