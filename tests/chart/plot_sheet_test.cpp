// SPDX-License-Identifier: MIT
#include "chart/plot_sheet.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace polhode {
namespace {

PlotSheet sheet() {
  PlotSheet sheet;
  sheet.title = "a 'quoted' title";
  sheet.across = {"x, m", -1.0, 1.0};
  sheet.up = {"y, J"};
  sheet.curves = {{"first, one", "#D55E00", 2.0, {{-1.0, 0.5}, {0.0, NAN}, {1.0, 1.0 / 3.0}}},
                  {"", "#A0A0A0", 1.0, {{0.0, 0.0}, {1.0, 1.0}}},
                  {"first, one", "#D55E00", 2.0, {{2.0, 3.0}}},
                  {"nowhere", "#D55E00", 2.0, {{0.0, NAN}, {1.0, NAN}}}};
  sheet.marks = {{"rest", Vec2(0.25, 0.5), false}};
  return sheet;
}

TEST(PlotSheet, ATableHasEveryPoint) {
  EXPECT_EQ(sheet_csv(sheet()),
            "curve,x,y\n"
            "\"first, one\",-1,0.5\n\"first, one\",0,nan\n"
            "\"first, one\",1,0.33333333333333331\n"
            "other 1,0,0\nother 1,1,1\n\"first, one 2\",2,3\n"
            "rest,0.25,0.5\n");
}

// the numbers of an axis that goes up, as SVG has them
std::vector<std::string> numbers_of(double low, double high) {
  PlotSheet sheet;
  sheet.across = {"x", 0.0, 1.0};
  sheet.up.label = "y";
  sheet.curves = {{"", "#000000", 1.0, {{0.0, low}, {0.5, high}, {1.0, low}}}};
  const std::string svg = draw_sheet(sheet, PlotFormat::svg);
  // "1.5×10" and "-5" are two parts of one text
  std::vector<std::string> numbers;
  for (std::size_t at = svg.find("<text>"); at != std::string::npos;
       at = svg.find("<text>", at + 1)) {
    const std::string text = svg.substr(at, svg.find("</text>", at) - at);
    std::string number;
    for (std::size_t i = text.find("<tspan"); i != std::string::npos;
         i = text.find("<tspan", i + 1)) {
      const std::size_t from = text.find('>', i) + 1;
      number += text.substr(from, text.find('<', from) - from);
    }
    if (number.find_first_of("0123456789") != std::string::npos) numbers.push_back(number);
  }
  numbers.erase(std::find(numbers.begin(), numbers.end(), " 0"), numbers.end());  // those across
  return numbers;
}

TEST(PlotSheet, NumbersOfAnAxisDiffer) {
  for (const auto& [low, high] : std::vector<std::pair<double, double>>{{75.0, 75.0002},
                                                                        {100.0, 100.001},
                                                                        {1e6, 1e6 + 0.001},
                                                                        {1.834e-5, 1.8341e-5},
                                                                        {-0.00756451, -0.0075645},
                                                                        {28.0, 44.0}}) {
    const std::vector<std::string> numbers = numbers_of(low, high);
    EXPECT_GE(numbers.size(), 3U) << low;
    EXPECT_EQ(std::set<std::string>(numbers.begin(), numbers.end()).size(), numbers.size()) << low;
  }
}

TEST(PlotSheet, RoundOffIsNoMotion) {
  for (const double value : {30.0, 1.834e-5}) {
    const std::vector<std::string> numbers = numbers_of(value, value * (1.0 + 1e-15));
    EXPECT_EQ(std::set<std::string>(numbers.begin(), numbers.end()).size(), numbers.size());
    EXPECT_GE(numbers.size(), 3U);
  }
  EXPECT_EQ(numbers_of(30.0, 30.0 + 1e-14).front(), " 29.97");
}

TEST(PlotSheet, APictureHasTitleNamesAndColours) {
  const std::string svg = draw_sheet(sheet(), PlotFormat::svg);
  for (const char* words : {"title", "first, one", "x, m", "y, J", "rest"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  EXPECT_TRUE(draw_sheet(sheet(), PlotFormat::pdf).starts_with("%PDF-"));
}

}  // namespace
}  // namespace polhode
