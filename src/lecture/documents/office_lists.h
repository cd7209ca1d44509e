// SPDX-License-Identifier: MIT
// Lists with numbers, which PowerPoint counts by itself.
#pragma once

#include "base/json.h"

namespace polhode {

// Slides (blocks of pandoc's tree) whose lists have the numbers of the deck: between two that
// PowerPoint would count as one, since they follow each other in a box of text, stands an empty
// line. Lists in notes for the speaker, whose numbers would begin again at each item, and those
// that begin beyond what PowerPoint counts from become paragraphs with their numbers as words.
Json with_numbers_of_lists(const Json& blocks);

}  // namespace polhode
