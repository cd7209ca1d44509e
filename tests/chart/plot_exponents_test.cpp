// SPDX-License-Identifier: MIT
#include "chart/plot_exponents.h"

#include <gtest/gtest.h>

namespace polhode::test {
namespace {

ExponentMap small_map() {
  ExponentMap map;
  map.title = "a map";
  map.x = {"motion.spin.body[1]", 1.0, 4.0, 3};
  map.y = {"body.mass", -1.0, 1.0, 2};
  map.cells = {{SectionVerdict::regular, 0.01, 7},
               {SectionVerdict::chaotic, 1.5, 7},
               {SectionVerdict::undecided, 0.05, 6},
               {SectionVerdict::chaotic, 0.6, 7},
               {SectionVerdict::regular, 0.02, 7},
               {SectionVerdict::regular, 0.0, 7}};
  return map;
}

// chaotic cells have their exponents; what has none lies in two bands below zero
TEST(PlotExponents, EachVerdictHasItsPlaceInTheColours) {
  const std::string script = exponents_script(small_map());
  EXPECT_NE(script.find("$cells << EOD\n-0.1875"), std::string::npos) << script;
  EXPECT_NE(script.find(" 1.5 -0.0625"), std::string::npos) << script;
  EXPECT_NE(script.find("'regular' -0.1875"), std::string::npos) << script;
  EXPECT_NE(script.find("'undecided' -0.0625"), std::string::npos) << script;
  EXPECT_NE(script.find("motion.spin.body[1]"), std::string::npos) << script;
}

TEST(PlotExponents, AMapWithoutChaosIsDrawnToo) {
  ExponentMap map = small_map();
  for (ExponentCell& cell : map.cells)
    cell.verdict = SectionVerdict::regular;
  EXPECT_GT(plot_exponents(map, PlotFormat::png).size(), 1000u);
  EXPECT_EQ(exponents_script(map).find("Lyapunov"), std::string::npos);
}

TEST(PlotExponents, TableHasARowForEachCell) {
  EXPECT_EQ(exponents_csv(small_map()),
            "x,y,verdict,exponent_per_s,crossings\n"
            "1,-1,regular,0.01,7\n2,-1,chaotic,1.5,7\n4,-1,undecided,0.05,6\n"
            "1,1,chaotic,0.6,7\n2,1,regular,0.02,7\n4,1,regular,0,7\n");
}

}  // namespace
}  // namespace polhode::test
