// SPDX-License-Identifier: MIT
// Describes the keys of a spec: a struct that a table of a scene file, or of a file of golden
// pictures (scene/golden_file.h), is read into. Each spec has one function
//
//   template <class Visitor> void fields(Visitor& v, BodySpec& spec);
//
// that calls
//
//   v.field(key, member, doc)         for a key that may be left out: the member keeps its default
//   v.required(key, member, doc)      for a key that must be given
//   v.merged(key, spec, spec, doc)    for a table whose keys belong to two specs
//   v.exactly_one_of({keys})          for keys of which exactly one must be given
//   v.at_most_one_of({keys})          for keys of which at most one may be given
//   fields(v, other_spec)             to have the keys of another spec in the same table
//
// A member is a value of a type that read_value() in scene/values.h takes, another spec (its key is
// a table), a std::optional of either, or a std::vector of specs (its key is a list of tables).
//
// Reading, printing, the JSON Schema and the errors for unknown keys are visitors of this one list
// (in scene/), so they cannot disagree.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/units.h"

namespace polhode {

// The allowed range of every component of a numeric value, in SI units. `high` is allowed itself,
// and so is `low` unless low_open. NaN and infinity are never allowed.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;  // true: strictly greater than low
};

inline constexpr Range kAny{};
inline constexpr Range kPositive{0.0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range kNonNegative{0.0, std::numeric_limits<double>::infinity(), false};

// The range restricted to the magnitudes allowed for the unit (magnitude_of in base/units.h).
// "Greater than 0" becomes "at least magnitude_of(unit).least".
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

// The same range in the unit of a suffix.
inline Range in_unit(const Range& range, const UnitSuffix& unit) {
  return {range.low / unit.factor, range.high / unit.factor, range.low_open};
}

// The description of one key: its meaning, unit and allowed values.
struct Doc {
  std::string text;                       // one phrase, for the schema and for errors
  Unit unit = Unit::none;                 // for numbers: SI unit, and which suffixes are allowed
  Range range = kAny;                     // for numbers: allowed values, in SI units
  std::vector<std::string> choices = {};  // for text: the allowed values (empty: any text)
  bool color = false;                     // for text: must be "#rrggbb"
  bool whole = false;                     // for numbers: must be one without a fraction, as 1e6
};

}  // namespace polhode
