// SPDX-License-Identifier: MIT
// Decks from text in memory.
#pragma once

#include <string>

#include "lecture/deck/deck.h"

namespace polhode::test {

inline Deck deck_of(const std::string& text) {
  return parse_deck(text, "deck.md", {".", false});
}

// the first problem of a deck; "none" if there is none
inline std::string problem_of(const std::string& text) {
  const Deck deck = deck_of(text);
  return deck.problems.empty() ? "none" : deck.problems.front().what();
}

}  // namespace polhode::test
