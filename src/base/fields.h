// SPDX-License-Identifier: MIT
// How a spec struct tells the world its keys. Each spec has one function
//
//   template <class Visitor> void fields(Visitor& v, BodySpec& spec);
//
// that calls v.field(key, member, doc) or v.required(key, member, doc) for each key,
// v.exactly_one_of({keys}) or v.at_most_one_of({keys}) for keys that exclude each other, and
// v.merged(key, spec, spec,
// doc) for two specs that share one table. Reading, printing, the JSON Schema and the errors for
// unknown keys are visitors of that one list (scene/), so they cannot disagree.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/units.h"

namespace polhode {

// What every component of a numeric value must satisfy; NaN and infinity never do.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;  // true: strictly greater than low
};

inline constexpr Range kAny{};
inline constexpr Range kPositive{0.0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range kNonNegative{0.0, std::numeric_limits<double>::infinity(), false};

// The range cut down to the magnitudes of the unit.
inline Range within_magnitude(const Range& range, Unit unit) {
  const Magnitude magnitude = magnitude_of(unit);
  Range cut = range;
  cut.high = std::min(range.high, magnitude.most);
  cut.low = std::max(range.low, -magnitude.most);
  if (cut.low_open && cut.low == 0.0) {
    cut.low = magnitude.least;
    cut.low_open = false;
  }
  return cut;
}

// The description of one key: what it means, its unit, what values it takes.
struct Doc {
  std::string text;                       // one phrase for a reader and for the schema
  Unit unit = Unit::none;                 // which suffixes the key may carry
  Range range = kAny;                     // for numbers
  std::vector<std::string> choices = {};  // for names: the only ones allowed (empty: any text)
  bool color = false;                     // for text: must be "#rrggbb"
};

}  // namespace polhode
