// SPDX-License-Identifier: MIT
// Wraps pandoc's HTML into complete pages with embedded styles and scripts, and prints them.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "base/system/child_process.h"
#include "lecture/deck/deck.h"

namespace polhode {

// reveal.js as found on this machine (MIT licence).
struct Reveal {
  std::string version;  // "5.1.0"; "of unknown version" if its package.json is missing
  std::string css;      // contents of dist/reveal.css
  std::string js;       // contents of dist/reveal.js, safe inside a <script> element
  std::string licence;  // its LICENSE file with the copyright notice; empty if missing
};
// The first folder of find_script_folder() (lecture/documents/script_folder.h), with POLHODE_REVEAL
// and the name reveal.js, that has dist/reveal.js and dist/reveal.css; absent if there is none.
// Throws Error (input) if one of its files cannot be read.
std::optional<Reveal> find_reveal();

// A style sheet that contains the font for formulas (Latin Modern Math, found by fc-match); empty
// if it is not installed. Browsers then use their own. Throws Error (interrupted).
std::string formula_font_css();

// The texts at the head of a deck, plain text. Empty: not given.
struct DeckWords {
  std::string title, subtitle, author, date, description, licence, lang = "en";
  std::string address;  // of the folder of the documents on the web, with a slash at its end
  // as HTML, by their names in the header, those of them that have more than words: links, formulas
  std::map<std::string, std::string> marked_up;
};
// From the deck's metadata, with nothing marked up; without a title, the file name of the deck is
// the title.
DeckWords words_of(const Deck& deck);

// Whether a language, by its tag, is written from right to left: Arabic, Hebrew, Persian and
// others, or any in their letters (az-Arab).
bool is_written_from_the_right(const std::string& lang);

// Complete HTML pages. `body` is pandoc's HTML of the text, `contents` that of its table of
// contents; `viewers` what viewer_blocks() (lecture/documents/turning.h) returns. The pages load
// nothing from the network and run only their own scripts. Throw Error (interrupted).
std::string lecture_page(const DeckWords& words,
                         const std::string& body,
                         const std::string& contents,
                         const std::string& viewers = "");
std::string slides_page(const DeckWords& words,
                        const std::string& body,
                        const Reveal& reveal,
                        const std::string& viewers = "");
std::string handout_page(const DeckWords& words, const std::string& body);

// The program that prints the handout.
struct Printer {
  std::string program;  // its name or path; empty if none runs
  ProgramFound found;   // its version, or why none runs
};
// The one named by POLHODE_CHROMIUM, else chromium, chromium-browser or google-chrome, if it runs.
// Throws Error (interrupted).
Printer find_printer();
// Prints an HTML file with that program and returns the bytes of the PDF. Throws Error
// (environment) if that fails, gives no PDF or the temporary folder cannot be made, (interrupted).
std::string print_page(const std::string& printer, const std::filesystem::path& html);

}  // namespace polhode
