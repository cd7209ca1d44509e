// SPDX-License-Identifier: MIT
// Viewers in pages: what a film shows, to be turned by hand (html/pages/turn.js).
#pragma once

#include <optional>
#include <string>

#include "film/solved_scene.h"
#include "lecture/documents.h"

namespace polhode {

// three.js as found on this machine (MIT licence).
struct Three {
  std::string version;  // "0.170.0"; "of unknown version" if its package.json is missing
  std::string js;       // contents of build/three.cjs, safe inside a <script> element
  std::string licence;  // its LICENSE file; empty if missing
};
// Looks for three.js in the folder named by POLHODE_THREE, then in polhode/three in the data
// folders of the user and of the system, as find_reveal() (lecture/pages.h) does. Throws Error
// (input) if one of its files cannot be read.
std::optional<Three> find_three();

// Whether the deck has a picture that is to be turned.
bool has_viewers(const Deck& deck);

// What a viewer shows beside the model: its times ("from", "to", s of motion; "scale", s of motion
// per s of film; "fps"), the stops of the story ("pauses": "at", s of motion, and "caption") and
// its words ("captions", likewise), "series" of |Omega| (rad/s), |L| (kg m^2/s) and energy (J) at
// equal steps from "from" to "to", the curves of show.plots ("plots"; values at equal steps from 0
// to "to"), and what elements are ("elements"). Throws Error (check_failed) as Motion::at does.
Json viewer_data(const Solved& solved, double from, double to);

// The blocks of data for the viewers of a deck, as HTML: for each its model and its viewer_data(),
// and three.js, none of which runs by itself. `folder`: that of the documents. Empty without
// viewers. Throws Error (input) if a file of a product cannot be read.
std::string viewer_blocks(const Deck& deck,
                          const FigureOf& figure_of,
                          const std::filesystem::path& folder,
                          const Three& three);

}  // namespace polhode
