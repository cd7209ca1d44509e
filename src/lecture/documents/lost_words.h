// SPDX-License-Identifier: MIT
// Reads documents back and looks for the words of the deck in them: pandoc leaves out without a
// word what a document has no place for.
#pragma once

#include <string>
#include <vector>

#include "lecture/deck/deck.h"

namespace polhode {

enum class DocumentForm { html, latex, office };

// Words of the deck (text, code, captions, title, authors and date; not descriptions of pictures)
// that stand less often in a document than in the deck, in the order of the deck; then, in words,
// how many formulas and which links to the web it lacks. At most `most` of all. A word is a run of
// letters, digits and symbols; in LaTeX words of Latin letters alone are looked for. `document` are
// the bytes of the file. Throws Error (environment) if these are no such document.
std::vector<std::string> lost_words(const Deck& deck,
                                    const std::string& document,
                                    DocumentForm form,
                                    std::size_t most);

}  // namespace polhode
