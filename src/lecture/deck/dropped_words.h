// SPDX-License-Identifier: MIT
// Looks for the words of a deck in what pandoc has read of it: it drops some without a word.
#pragma once

#include <string>
#include <vector>

#include "base/json.h"

namespace polhode {

// A word of a deck and its line, from 1.
struct DroppedWord {
  std::string word;
  int line = 0;
};
// Words that stand less often in pandoc's tree of a deck than in its text without headers: of
// footnotes and references that nothing uses, of cells beyond the columns of a table. At most
// `most` different ones, each as often as it lacks, in the order of the text. tree: as
// read_markdown() (lecture/deck/pandoc.h) returns it; if there are such words, the deck is read
// once more, to find where.
std::vector<DroppedWord> dropped_words(const std::string& text, const Json& tree, std::size_t most);

}  // namespace polhode
