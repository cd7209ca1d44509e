// SPDX-License-Identifier: MIT
// The documents of a lecture as text or bytes, from the deck and what was made for it.
#pragma once

#include <functional>
#include <string>

#include "lecture/figures.h"
#include "lecture/pages.h"

namespace polhode {

// Formulas that pandoc cannot read are taken out of the deck and told as problems, so that no
// output has TeX that is no mathematics.
void drop_bad_formulas(Deck& deck, const std::string& deck_text);

// `figure_of` gives a picture of the deck with what was made of it.
using FigureOf = std::function<Figure(const DeckPicture&)>;

std::string make_page(const Deck& deck, const FigureOf& figure_of);
std::string make_slides(const Deck& deck, const FigureOf& figure_of, const Reveal& reveal);
std::string make_handout_html(const Deck& deck, const FigureOf& figure_of);
std::string make_beamer(const Deck& deck, const FigureOf& figure_of);
// Reads the posters in `folder`/media. Throws Error (environment).
std::string make_pptx(const Deck& deck,
                      const FigureOf& figure_of,
                      const std::filesystem::path& folder);

}  // namespace polhode
