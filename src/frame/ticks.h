// SPDX-License-Identifier: MIT
// Chooses the ticks of an axis: few round numbers whose labels do not touch.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace polhode {

// The ticks of an axis, from low to high: multiples of one step, which is 1, 2 or 5 times a power
// of ten. Labels are the values divided by 10^exponent, all with the same number of decimals.
struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;
  int exponent = 0;  // 0, or a multiple of 3 for values that are very large or small
  int decimals = 0;  // of the labels
};

// The ticks of an axis from low to high (finite, low < high) that is `length` pixels long: as many
// as fit, at most kMostTicks. `room` says how many pixels a label takes along the axis, centred at
// its tick; at least `gap` pixels remain free between two labels. Where two do not fit there is
// one, or none.
Ticks choose_ticks(double low,
                   double high,
                   double length,
                   const std::function<double(const std::string&)>& room,
                   double gap);
inline constexpr int kMostTicks = 7;

// The value divided by 10^exponent, with a true minus sign.
std::string number_text(double value, int exponent, int decimals);

// "10⁻³ J", "J", "10⁻³": a unit with the power of ten of the labels; empty for no unit and
// exponent 0.
std::string scaled_unit(int exponent, const std::string& unit);

// "10⁻³".
std::string power_of_ten(int exponent);

}  // namespace polhode
