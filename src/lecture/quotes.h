// SPDX-License-Identifier: MIT
// Numbers in the text of a deck: {inspect:scene.toml#key} becomes what `polhode inspect` says.
#pragma once

#include <functional>
#include <string>

#include "lecture/deck.h"

namespace polhode {

// {inspect:SCENE#KEY|%.3f,UNIT}; the part from | on may be missing.
struct Quote {
  std::string scene;
  std::string key;     // dotted path in the answer of inspect; units and "derived." may be left out
  std::string format;  // "%.4g" and the like; empty: %.4g
  std::string unit;    // in place of the key's own: deg, rpm, ms, cm, g …; "none" for no unit
};

// Throws Error (input) for what is between the braces.
Quote parse_quote(const std::string& words);

// A number and its unit as a reader wants them.
struct Quoted {
  std::string text;  // "1.26 rad/s", "4.2 × 10⁻³ kg m²"
  std::string tex;   // the same within a formula
};

// The value of the quote's key in the answer of inspect. Throws Error (input) for an unknown key,
// with the nearest one, and for a unit that the key cannot be told in.
Quoted quoted(const Json& inspection, const Quote& quote);

// The unit that ends a key of inspect, as text, and the key without it: "flip_time_s" to
// {"flip_time", "s"}.
std::pair<std::string, std::string> split_unit(const std::string& key);

// Puts numbers in place of all quotes of the deck, captions included. `inspect` answers for a scene
// or throws. What cannot be quoted becomes "[?]" and a problem with the deck's line.
void fill_quotes(Deck& deck,
                 const std::string& deck_text,
                 const std::function<const Json&(const std::string& scene)>& inspect);

// The scenes that quotes of the deck name.
std::set<std::string> quoted_scenes(const Deck& deck);

}  // namespace polhode
