// SPDX-License-Identifier: MIT
#include "frame/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace polhode {
namespace {

constexpr std::array<double, 3> kSteps = {1.0, 2.0, 5.0};

// numbers from 0.01 to 9999 are written as they are
int exponent_of(double low, double high) {
  const double size = std::max(std::abs(low), std::abs(high));
  if (size <= 0.0 || (size >= 0.01 && size < 1e4)) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(size) / 3.0));
}

// the multiples of digit * 10^power in the range
std::vector<double> multiples(double low, double high, double digit, int power) {
  // dividing by a power that is a whole number gives 0.3, not 0.30000000000000004
  const double scale = std::pow(10.0, std::abs(power));
  const auto value = [&](double k) {
    return power < 0 ? k * digit / scale : k * digit * scale;
  };
  const double step = value(1.0);
  const double slack = 1e-9 * (high - low);
  std::vector<double> list;
  for (double k = std::ceil((low - slack) / step); value(k) <= high + slack; k += 1.0) {
    list.push_back(value(k) == 0.0 ? 0.0 : value(k));
    if (list.size() > kMostTicks) break;
  }
  return list;
}

}  // namespace

Ticks choose_ticks(double low,
                   double high,
                   double length,
                   const std::function<double(const std::string&)>& room,
                   double gap) {
  const double range = high - low;
  const int finest = static_cast<int>(std::floor(std::log10(range / kMostTicks))) - 1;
  const int coarsest =
      static_cast<int>(std::ceil(std::log10(std::max({range, std::abs(low), std::abs(high)}))));
  for (int power = finest; power <= coarsest; ++power) {
    for (const double digit : kSteps) {
      Ticks ticks;
      ticks.values = multiples(low, high, digit, power);
      if (ticks.values.size() > kMostTicks) continue;
      ticks.exponent = exponent_of(low, high);
      ticks.decimals = std::max(0, ticks.exponent - power);
      bool fits = true;
      double taken_to = 0.0;  // px along the axis
      for (const double value : ticks.values) {
        ticks.labels.push_back(number_text(value, ticks.exponent, ticks.decimals));
        const double half = 0.5 * room(ticks.labels.back());
        const double at = (value - low) / range * length;
        fits = fits && (ticks.labels.size() == 1 || at - half >= taken_to + gap);
        taken_to = at + half;
      }
      if (fits) return ticks;
    }
  }
  return {};
}

std::string number_text(double value, int exponent, int decimals) {
  const double scale = std::pow(10.0, std::abs(exponent));
  const double shown = exponent < 0 ? value * scale : value / scale;
  std::string text = fmt::format("{:.{}f}", std::abs(shown), decimals);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return shown < 0.0 && !zero ? "\u2212" + text : text;
}

std::string power_of_ten(int exponent) {
  static const std::array<const char*, 10> digits = {"\u2070",
                                                     "\u00b9",
                                                     "\u00b2",
                                                     "\u00b3",
                                                     "\u2074",
                                                     "\u2075",
                                                     "\u2076",
                                                     "\u2077",
                                                     "\u2078",
                                                     "\u2079"};
  std::string text = exponent < 0 ? "10\u207b" : "10";
  for (const char c : std::to_string(std::abs(exponent)))
    text += digits[static_cast<std::size_t>(c - '0')];
  return text;
}

std::string scaled_unit(int exponent, const std::string& unit) {
  if (exponent == 0) return unit;
  return unit.empty() ? power_of_ten(exponent) : power_of_ten(exponent) + " " + unit;
}

}  // namespace polhode
