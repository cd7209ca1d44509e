// SPDX-License-Identifier: MIT
// A picture of the deck as each kind of document shows it.
#pragma once

#include <string>
#include <vector>

#include "lecture/deck.h"

namespace polhode {

// A picture with what was made of it; no facts at all when that failed.
struct Figure {
  const DeckPicture* picture = nullptr;
  std::vector<Json> facts;  // of its products, one per film that is compared
  std::string failure;      // why there are none
};

// Blocks for pandoc. Files are named as seen from the folder of the documents: media/FILE.
Json page_blocks(const Figure& figure);     // index.html
Json slide_blocks(const Figure& figure);    // slides.html
Json handout_blocks(const Figure& figure);  // what is printed
Json office_blocks(const Figure& figure);   // .pptx: a poster that links to its film
Json beamer_blocks(const Figure& figure);   // LaTeX: a poster

// The table of the numbers of inspect; only `keys` (with spaces between) unless that is empty.
// Throws Error (input) for an unknown key.
Json number_table(const Json& inspection, const std::string& keys);

}  // namespace polhode
