// SPDX-License-Identifier: MIT
// Turns a picture of the deck into the blocks of each kind of document.
#pragma once

#include <string>
#include <vector>

#include "lecture/deck/deck.h"

namespace polhode {

// A picture of the deck with the facts of its product, or the reason why there are none.
struct Figure {
  const DeckPicture* picture = nullptr;  // not owned, never null; lives as long as the deck
  // Of its product (lecture/products.h); null if it failed. Those of an inspect picture also have
  // "table", an array with its number_table().
  Json facts;
  std::string failure;       // why there are no facts
  std::string address = {};  // of its viewer on the web, for the handout; empty: none
};

// Lists of blocks of pandoc's tree, a function for each document; for a figure without facts, a
// paragraph with `failure`. File names are relative to the
// folder of the documents: media/FILE.
Json page_blocks(const Figure& figure);     // index.html
Json slide_blocks(const Figure& figure);    // slides.html
Json handout_blocks(const Figure& figure);  // handout.pdf
Json office_blocks(const Figure& figure);   // .pptx: a poster with a link to its film
Json beamer_blocks(const Figure& figure);   // LaTeX: a poster

// Where the viewer of a picture of the kind `turn` is, relative to the folder of the documents.
std::string viewer_link(const DeckPicture& picture);

// A table (a block) of values of `inspection`, the result of inspection() (app/commands/inspect.h)
// of the scene that the deck calls `scene`: those in `keys` (as in Quote::key in
// lecture/deck/quotes.h, separated by spaces); if `keys` is empty, the kind, the mass, the
// principal moments and all derived values. Throws Error (input), without a place, as quoted()
// does.
Json number_table(const Json& inspection, const std::string& scene, const std::string& keys);

}  // namespace polhode
