// SPDX-License-Identifier: MIT
// Wraps pandoc's HTML into complete pages with embedded styles and scripts, and prints them.
#pragma once

#include <optional>
#include <string>

#include "lecture/deck.h"

namespace polhode {

// reveal.js as found on this machine (MIT licence).
struct Reveal {
  std::string version;
  std::string css;
  std::string js;
  std::string licence;  // its LICENSE file with the copyright notice; empty if missing
};
// Looks for reveal.js in the folder named by POLHODE_REVEAL, then in the data folders of the user
// and of the system. Empty if there is none.
std::optional<Reveal> find_reveal();

// A style sheet that contains the font for formulas; empty if it is not installed. Browsers then
// use their own.
std::string formula_font_css();

// The texts at the head of a deck.
struct DeckWords {
  std::string title, subtitle, author, date, description, licence, lang = "en";
};
// From the deck's metadata.
DeckWords words_of(const Deck& deck);

// Complete HTML pages. body and contents are pandoc's HTML. The pages load nothing from the network
// and run only their own scripts.
std::string lecture_page(const DeckWords& words,
                         const std::string& body,
                         const std::string& contents);
std::string slides_page(const DeckWords& words, const std::string& body, const Reveal& reveal);
std::string handout_page(const DeckWords& words, const std::string& body);

// The program that prints the handout: the one named by POLHODE_CHROMIUM, or chromium; empty if
// there is none.
std::string find_printer();
// Prints an HTML file and returns the bytes of the PDF. Throws Error (environment) if that fails,
// (interrupted).
std::string print_page(const std::string& printer, const std::filesystem::path& html);

}  // namespace polhode
