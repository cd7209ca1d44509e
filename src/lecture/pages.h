// SPDX-License-Identifier: MIT
// Whole pages around what pandoc makes of a deck: its style and its scripts are in them.
#pragma once

#include <optional>
#include <string>

#include "lecture/deck.h"

namespace polhode {

// reveal.js as it was found on this machine (MIT licence).
struct Reveal {
  std::string version;
  std::string css;
  std::string js;
  std::string licence;  // its LICENSE file, with the copyright notice; empty if there is none
};
// Where install-dependencies puts it, or POLHODE_REVEAL; none if it is in neither.
std::optional<Reveal> find_reveal();

// The font of formulas, as a style sheet with the font inside it; empty when it is not installed,
// and browsers take their own.
std::string formula_font_css();

// The words that head a deck.
struct DeckWords {
  std::string title, subtitle, author, date, description, licence, lang = "en";
};
DeckWords words_of(const Deck& deck);

// Bodies are pandoc's HTML. The pages load nothing from elsewhere and run no script but their own.
std::string lecture_page(const DeckWords& words,
                         const std::string& body,
                         const std::string& contents);
std::string slides_page(const DeckWords& words, const std::string& body, const Reveal& reveal);
std::string handout_page(const DeckWords& words, const std::string& body);

// The program that prints the handout: chromium, or what POLHODE_CHROMIUM names; empty if there is
// none.
std::string find_printer();
// The bytes of a PDF of an HTML file. Throws Error (environment).
std::string print_page(const std::string& printer, const std::filesystem::path& html);

}  // namespace polhode
