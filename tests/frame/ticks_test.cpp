// SPDX-License-Identifier: MIT
#include "frame/ticks.h"

#include <cmath>

#include <gtest/gtest.h>

namespace polhode {
namespace {

// every letter takes the same room along the axis
auto letters_of(double width) {
  return [width](const std::string& text) {
    return width * static_cast<double>(text.size());
  };
}

// ranges as curves have them: around 0, far from 0, tiny, huge
std::vector<std::pair<double, double>> ranges() {
  std::vector<std::pair<double, double>> list;
  for (const double size : {1e-15, 3.7e-4, 0.012, 0.9, 1.0, 7.3, 42.0, 360.0, 1e4, 8.6e6}) {
    list.insert(list.end(),
                {{0.0, size},
                 {-size, size},
                 {-0.31 * size, 1.7 * size},
                 {-size, -0.2 * size},
                 {0.999 * size, 1.001 * size},
                 {size, 1.37 * size}});
  }
  return list;
}

TEST(Ticks, AreFewRoundAndNeverTouch) {
  for (const auto& [low, high] : ranges()) {
    for (const double letter : {2.0, 7.0, 19.0, 40.0, 90.0}) {
      for (const double length : {40.0, 150.0, 590.0, 2000.0}) {
        const double gap = 0.9 * letter;
        const Ticks ticks = choose_ticks(low, high, length, letters_of(letter), gap);
        SCOPED_TRACE(testing::Message() << low << ".." << high << " " << letter << " " << length);
        ASSERT_EQ(ticks.values.size(), ticks.labels.size());
        EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(kMostTicks));
        double free_from = -1e9;
        for (std::size_t i = 0; i < ticks.values.size(); ++i) {
          const double at = (ticks.values[i] - low) / (high - low) * length;
          EXPECT_GE(at, -1e-6 * length);
          EXPECT_LE(at, length * (1.0 + 1e-6));
          const double half = 0.5 * letters_of(letter)(ticks.labels[i]);
          EXPECT_GE(at - half, free_from - 1e-6);
          free_from = at + half + gap;
        }
        if (ticks.values.size() < 2) continue;
        const double step = ticks.values[1] - ticks.values[0];
        const double digit = step / std::pow(10.0, std::floor(std::log10(step * (1.0 + 1e-9))));
        EXPECT_TRUE(std::abs(digit - 1.0) < 1e-6 || std::abs(digit - 2.0) < 1e-6 ||
                    std::abs(digit - 5.0) < 1e-6)
            << step;
      }
    }
  }
}

// no two labels of one axis are the same, and each is its value
TEST(Ticks, LabelsAreTheirValues) {
  for (const auto& [low, high] : ranges()) {
    const Ticks ticks = choose_ticks(low, high, 800.0, letters_of(10.0), 5.0);
    ASSERT_GE(ticks.values.size(), 2U) << low << ".." << high;
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
      std::string text = ticks.labels[i];
      if (text.rfind("\u2212", 0) == 0) text = "-" + text.substr(3);
      EXPECT_NEAR(std::stod(text) * std::pow(10.0, ticks.exponent),
                  ticks.values[i],
                  1e-9 * std::max(std::abs(low), std::abs(high)))
          << text;
    }
  }
}

TEST(Ticks, AreAsManyAsFit) {
  const auto count = [](double length) {
    return choose_ticks(0.0, 1.2, length, letters_of(10.0), 10.0).values.size();
  };
  EXPECT_EQ(count(2000.0), 7U);
  EXPECT_EQ(count(100.0), 3U);
  EXPECT_EQ(count(60.0), 2U);
  EXPECT_LE(count(20.0), 1U);
  EXPECT_EQ(choose_ticks(30.0, 42.0, 1000.0, letters_of(10.0), 10.0).labels,
            (std::vector<std::string>{"30", "32", "34", "36", "38", "40", "42"}));
  EXPECT_EQ(choose_ticks(-0.1, 0.3, 1000.0, letters_of(10.0), 10.0).labels,
            (std::vector<std::string>{"\u22120.1", "0.0", "0.1", "0.2", "0.3"}));
}

TEST(Ticks, NumbersHaveATrueMinusAndNoNegativeZero) {
  EXPECT_EQ(number_text(-53.24, 0, 1), "\u221253.2");
  EXPECT_EQ(number_text(-0.04, 0, 1), "0.0");
  EXPECT_EQ(number_text(0.000123, -6, 0), "123");
  EXPECT_EQ(number_text(2.5e6, 6, 2), "2.50");
}

TEST(Ticks, UnitsHaveThePowerOfTenOfTheLabels) {
  EXPECT_EQ(scaled_unit(0, "J"), "J");
  EXPECT_EQ(scaled_unit(-3, "J"), "10\u207b\u00b3 J");
  EXPECT_EQ(scaled_unit(-15, ""), "10\u207b\u00b9\u2075");
  EXPECT_EQ(scaled_unit(0, ""), "");
}

}  // namespace
}  // namespace polhode
