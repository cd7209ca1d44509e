// SPDX-License-Identifier: MIT
// Lists with numbers, which PowerPoint counts by itself.
#pragma once

#include "base/json.h"

namespace polhode {

// Gives the lists of slides (blocks of pandoc's tree) the numbers of the deck: between two that
// PowerPoint would count as one, since they follow each other in a box of text, stands an empty
// line. What it cannot count becomes paragraphs with their numbers as words: lists in notes for
// the speaker, which begin again at each item, lists with an item that does not begin with words,
// and those that begin or are nested beyond what its files hold.
void settle_numbers_of_lists(Json& blocks);

}  // namespace polhode
