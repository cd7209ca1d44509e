// SPDX-License-Identifier: MIT
// Viewers in pages: what a film shows, to be turned by hand (html/pages/turn.js).
#pragma once

#include <optional>
#include <string>

#include "lecture/documents/documents.h"

namespace polhode {

// three.js as found on this machine (MIT licence).
struct Three {
  std::string version;  // "0.170.0"; "of unknown version" if its package.json is missing
  std::string js;       // contents of build/three.cjs, safe inside a <script> element
  std::string licence;  // its LICENSE file; empty if missing
};
// Looks for three.js in the folder named by POLHODE_THREE, then in polhode/three in the data
// folders of the user and of the system, as find_reveal() (lecture/documents/pages.h) does. Throws
// Error (input) if one of its files cannot be read.
std::optional<Three> find_three();

// Whether the deck has a picture that is to be turned.
bool has_viewers(const Deck& deck);

// The blocks of data for the viewers of a deck, as HTML: for each its model and its viewer_data()
// (export/viewer_data.h),
// and three.js, and `core` (find_page_core() in lecture/documents/sliders.h), if it is there and a
// viewer has sliders; none of which runs by itself. `folder`: that of the documents. Empty without
// viewers. Throws Error (input) if a file of a product cannot be read.
std::string viewer_blocks(const Deck& deck,
                          const FigureOf& figure_of,
                          const std::filesystem::path& folder,
                          const Three& three,
                          const std::optional<std::string>& core = {});

}  // namespace polhode
