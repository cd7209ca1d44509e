// SPDX-License-Identifier: MIT
#include "chart/plot_sheet.h"

#include <cmath>

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

TEST(PlotSheet, APictureHasTitleNamesAndColours) {
  const std::string svg = draw_sheet(sheet(), PlotFormat::svg);
  for (const char* words : {"title", "first, one", "x, m", "y, J", "rest"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  EXPECT_TRUE(draw_sheet(sheet(), PlotFormat::pdf).starts_with("%PDF-"));
}

}  // namespace
}  // namespace polhode
