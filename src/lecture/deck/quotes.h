// SPDX-License-Identifier: MIT
// Replaces quotes in a deck, such as {inspect:scene.toml#key}, by the value that `polhode
// inspect` gives.
#pragma once

#include <functional>
#include <string>

#include "lecture/deck/deck.h"

namespace polhode {

// A quote: {inspect:SCENE#KEY|%.3f,UNIT}. The part from | on is optional.
struct Quote {
  std::string scene;
  // dotted path in inspection() (app/commands/inspect.h), with the number of an entry of a list:
  // "principal_moments.0"; units and "derived." may be omitted
  std::string key;
  // "%", perhaps "." and one or two digits, then e, f or g: "%.3f"; empty (for numbers "%.4g") if
  // the quote gives none
  std::string format;
  // unit to convert to, such as "rpm" (docs/lecture.md lists them); "none": the number without its
  // unit; empty: the key's own unit
  std::string unit;
};

// Parses a quote with its braces; `words` must begin with "{inspect:" and end with "}". Throws
// Error (input), without a place, if the rest is not as in Quote.
Quote parse_quote(const std::string& words);

// A value with its unit, formatted: a number, a list of numbers "(1, 2, 3)", yes or no, or text.
struct Quoted {
  std::string text;  // "1.26 rad/s", "4.2 × 10⁻³ kg m²"
  std::string tex;   // in TeX, for use inside a formula
};

// The formatted value of the quote's key in `inspection`, the result of inspection(). quote.format
// must be as parse_quote() checks it. Throws Error
// (input), without a place, for an unknown key (suggesting the nearest), for a key that names a
// group of values or has none (null), for a format of what is no number, and for a unit that the
// value cannot be converted to.
Quoted quoted(const Json& inspection, const Quote& quote);

// Splits a key of inspect into name and unit: "flip_time_s" into {"flip_time", "s"}. The unit is as
// readers see it ("kg m²"), and empty if there is none.
std::pair<std::string, std::string> split_unit(const std::string& key);

// Replaces all quotes in text and formulas of the deck, also in captions and metadata, by
// Quoted::text, in formulas by Quoted::tex. Those in code stay. `deck_text` is the text of the
// deck, for line numbers. `inspect` returns inspection() of a scene, valid until its next call, or
// throws Error. A quote that fails becomes "[?]" (in TeX inside formulas) and an entry of
// deck.problems with its line; only Error (interrupted) is thrown on.
void fill_quotes(Deck& deck,
                 const std::string& deck_text,
                 const std::function<const Json&(const std::string& scene)>& inspect);

// The names of the scenes in the quotes that fill_quotes() replaces, as the deck spells them.
std::set<std::string> quoted_scenes(const Deck& deck);

}  // namespace polhode
