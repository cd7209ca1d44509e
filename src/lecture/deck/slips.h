// SPDX-License-Identifier: MIT
// Slips of the pen in a deck: marks that pandoc shows as they stand, with the words that they were
// to hide.
#pragma once

#include <functional>
#include <string>

#include "base/error.h"
#include "base/json.h"
#include "lecture/deck/line_finder.h"

namespace polhode {

// The letters of a mark, such as "{.notes}", without its signs.
std::string letters_of(std::string mark);

// Tells of each slip once, in the order of the deck.
class SlipFinder {
 public:
  // Calls `tell` with a line of the deck, 0 if that is unknown, and an Error (input) without a
  // place. `lines` must outlive this.
  using Tell = std::function<void(int line, const Error& error)>;
  SlipFinder(LineFinder& lines, Tell tell);

  // Looks at one node of pandoc's tree, not at those within it; call it for all. In lines of words:
  // boxes that are none, misspelt quotes of numbers, pictures without an end, classes of nothing.
  // In each word: HTML and LaTeX. In footnotes: boxes of notes. Elsewhere the class for the
  // speaker's words (.notes) on what is no box.
  void look_at(const Json& node, bool in_header);

 private:
  void look_at_words(const Json& inlines);
  void look_for_notes(const Json& inlines);
  void look_for_boxes(const Json& footnote);
  void look_at_word(const std::string& words, bool in_header);
  void look_at_classes(const Json& node);
  int line_of_mark(const Json& inlines, std::size_t from);

  LineFinder& lines_;
  Tell tell_;
  bool mark_told_ = false;  // of a box that is none
  bool html_told_ = false;
  int marked_words_ = 0;  // words like HTML and LaTeX
};

}  // namespace polhode
