// SPDX-License-Identifier: MIT
// Replaces quotes in a deck, such as {inspect:scene.toml#key}, by the number that `polhode inspect`
// gives.
#pragma once

#include <functional>
#include <string>

#include "lecture/deck.h"

namespace polhode {

// A quote: {inspect:SCENE#KEY|%.3f,UNIT}. The part from | on is optional.
struct Quote {
  std::string scene;
  std::string key;     // dotted path in inspection(); units and "derived." may be omitted
  std::string format;  // such as "%.3f"; empty: "%.4g"
  // unit to convert to: deg, rpm, ms, cm, g …; "none": no unit; empty: the key's own
  std::string unit;
};

// Parses the text between the braces. Throws Error (input), without a place, if it is not a quote.
Quote parse_quote(const std::string& words);

// A number with its unit, formatted.
struct Quoted {
  std::string text;  // "1.26 rad/s", "4.2 × 10⁻³ kg m²"
  std::string tex;   // the same for formulas
};

// The formatted value of the quote's key. Throws Error (input), without a place, for an unknown key
// (suggesting the nearest) and for a unit that it cannot be converted to.
Quoted quoted(const Json& inspection, const Quote& quote);

// Splits a key of inspect into name and unit: "flip_time_s" into {"flip_time", "s"}.
std::pair<std::string, std::string> split_unit(const std::string& key);

// Replaces all quotes of the deck, also in captions. `inspect` returns inspection() of a scene or
// throws. A quote that fails becomes "[?]" and an entry of deck.problems with its line. Throws
// Error (interrupted).
void fill_quotes(Deck& deck,
                 const std::string& deck_text,
                 const std::function<const Json&(const std::string& scene)>& inspect);

// The names of the scenes in all quotes of the deck.
std::set<std::string> quoted_scenes(const Deck& deck);

}  // namespace polhode
