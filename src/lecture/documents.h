// SPDX-License-Identifier: MIT
// Makes the documents of a lecture, as text or bytes, from the deck and its products.
#pragma once

#include <functional>
#include <string>

#include "lecture/figures.h"
#include "lecture/pages.h"

namespace polhode {

// Removes formulas that pandoc cannot read and reports them in deck.problems, so that no output
// contains TeX that is not mathematics. Throws Error as write_document does.
void drop_bad_formulas(Deck& deck, const std::string& deck_text);

// Returns a picture of the deck with its products.
using FigureOf = std::function<Figure(const DeckPicture&)>;

// All throw Error (environment) as write_document does.
std::string make_page(const Deck& deck, const FigureOf& figure_of);
std::string make_slides(const Deck& deck, const FigureOf& figure_of, const Reveal& reveal);
std::string make_handout_html(const Deck& deck, const FigureOf& figure_of);
std::string make_beamer(const Deck& deck, const FigureOf& figure_of);
// Reads the posters in `folder`/media.
std::string make_pptx(const Deck& deck,
                      const FigureOf& figure_of,
                      const std::filesystem::path& folder);

}  // namespace polhode
