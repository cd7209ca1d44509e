// SPDX-License-Identifier: MIT
// What slides of LaTeX need otherwise than the other documents: characters, formulas and code that
// pdflatex can set.
#pragma once

#include <string>
#include <vector>

#include "lecture/deck/deck.h"

namespace polhode {

// The blocks of the deck for slides: where words and one picture share one, they stand side by
// side.
Json latex_slides(const Deck& deck);

// Pictures alone are no higher than leaves room for captions below them.
void leave_room_for_captions(Json& blocks);

// A document of pandoc as pdflatex can set it, with the packages that its formulas need.
Json for_latex(Json tree);

// The characters of the deck that pdflatex does not have, each with its code point: "中 (U+4E2D)".
std::vector<std::string> characters_without_latex(const Deck& deck);

}  // namespace polhode
