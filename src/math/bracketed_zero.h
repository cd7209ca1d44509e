// SPDX-License-Identifier: MIT
// Where a function of one number is zero between two places at which its signs differ.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {

// Two places, low < high, and the values of a function there, of different signs; zero counts as
// the sign of at_high.
struct Bracket {
  double low, high;
  double at_low, at_high;
};

// A part of the bracket with a zero of `function`, no wider than `width`, or than a few roundings
// of its ends; a single place if the function is zero there. Illinois's variant of the rule of
// false position (Dowell and Jarratt, BIT 11 (1971) 168), with halvings where that is slow; no
// value is taken nearer to an end than half the width, so that a zero beside an end is enclosed as
// soon as one far from both.
template <class Function>
Bracket narrowed(Bracket bracket, double width, const Function& function) {
  constexpr int kSlow = 3;  // steps in a row that have not halved it
  auto& [low, high, at_low, at_high] = bracket;
  const double rounding = std::numeric_limits<double>::epsilon() * std::max(-low, high);
  const double least = std::max(0.5 * width, 2.0 * rounding);
  double f_low = at_low, f_high = at_high;  // that of an end that stays is halved
  int side = 0, slow = 0;
  while (high - low > 2.0 * least) {
    const double before = high - low;
    double middle = (low * f_high - high * f_low) / (f_high - f_low);
    if (slow >= kSlow) middle = 0.5 * (low + high);
    if (!(middle > low + least)) middle = low + least;
    if (!(middle < high - least)) middle = high - least;
    const double found = function(middle);
    if (found != 0.0 && (found > 0.0) == (at_low > 0.0)) {
      low = middle;
      at_low = f_low = found;
      if (side == 1) f_high *= 0.5;
      side = 1;
    } else {
      high = middle;
      at_high = f_high = found;
      if (side == -1) f_low *= 0.5;
      side = -1;
      if (found == 0.0) return {middle, middle, 0.0, 0.0};
    }
    slow = high - low > 0.5 * before ? slow + 1 : 0;
  }
  return bracket;
}

}  // namespace polhode
