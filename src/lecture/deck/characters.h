// SPDX-License-Identifier: MIT
// The characters of a deck, for fonts that may lack some.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lecture/deck/deck.h"

namespace polhode {

// Calls `visit` with each character of a text in UTF-8.
void for_each_character(const std::string& text,
                        const std::function<void(const std::string&)>& visit);

// Calls `visit` with the texts of a tree that are set as they are: words, code, formulas.
void for_each_set_text(const Json& tree, const std::function<void(const std::string&)>& visit);

// All characters that are set in such texts of the deck, each once.
std::vector<std::string> characters_of(const Deck& deck);

// A character for people whose own fonts may lack it: "μ (U+03BC)".
std::string with_code_point(const std::string& character);

}  // namespace polhode
