// SPDX-License-Identifier: MIT
// Makes the documents of a lecture, as text or bytes, from the deck and its products.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lecture/documents/figures.h"
#include "lecture/documents/pages.h"

namespace polhode {

// Makes formulas whole (whole_formula() in lecture/deck/formulas.h), replaces those that pandoc
// cannot read by a note and reports them in deck.problems, so that no output contains TeX that is
// not mathematics. `deck_text` is the text of the deck, for line numbers. Throws Error as
// write_document (lecture/deck/pandoc.h) does.
void settle_formulas(Deck& deck, const std::string& deck_text);

// Returns the Figure of a picture of the deck; called only while a document is made.
using FigureOf = std::function<Figure(const DeckPicture&)>;

// Each returns the contents of one document: index.html, slides.html, the HTML that is printed as
// handout.pdf, slides.tex. viewers: what viewer_blocks() (lecture/documents/turning.h) returns.
// All, and make_pptx(), throw what `figure_of` throws, Error as write_document does, and
// (environment) if the temporary folder cannot be written.
std::string make_page(const Deck& deck, const FigureOf& figure_of, const std::string& viewers = "");
std::string make_slides(const Deck& deck,
                        const FigureOf& figure_of,
                        const Reveal& reveal,
                        const std::string& viewers = "");
std::string make_handout_html(const Deck& deck, const FigureOf& figure_of);
std::string make_beamer(const Deck& deck, const FigureOf& figure_of);
// The bytes of slides.pptx. pandoc reads the posters and other pictures in `folder`/media.
std::string make_pptx(const Deck& deck,
                      const FigureOf& figure_of,
                      const std::filesystem::path& folder);

}  // namespace polhode
