// SPDX-License-Identifier: MIT
// Parts that add up to the angular velocity.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "frame/compose.h"
#include "frame/composers.h"
#include "support/motions.h"
#include "support/show_only.h"

namespace polhode {
namespace {

// lines of dashes lead from the tips of two arrows to a corner, and from there to the tip of omega
TEST(Sums, LeadToTheTipOfOmega) {
  for (const char* parts : {"euler_rates", "omega_components"}) {
    SCOPED_TRACE(parts);
    ShowSpec show = test::show_only(parts);
    show["sum"] = true;
    const Composer picture = test::composer(test::prolate_body(), test::wobbling(), show);
    for (const double t : {0.4, 1.7, 3.2}) {
      const Sample now = picture.scenery().motion.at(t);
      const Glyphs glyphs = picture.glyphs_at(now);
      ASSERT_EQ(glyphs.lines.size(), 3U);
      EXPECT_LT((glyphs.lines[0].to - glyphs.lines[1].to).norm(), 1e-12);
      EXPECT_LT((glyphs.lines[1].to - glyphs.lines[2].from).norm(), 1e-12);
      EXPECT_LT((glyphs.lines[2].to - omega_tip(picture.scenery(), now)).norm(), 1e-12);
      const bool of_angles = std::string(parts) == "euler_rates";
      EXPECT_LT((glyphs.lines[0].from - glyphs.arrows[0].tip).norm(), 1e-12);
      EXPECT_LT((glyphs.lines[1].from - glyphs.arrows[of_angles ? 2 : 1].tip).norm(), 1e-12);
      // no dash leaves the lines, and together they are about half as long
      double length = 0.0, dashes = 0.0;
      for (const LineGlyph& line : glyphs.lines)
        length += (line.to - line.from).norm();
      for (const RodGlyph& dash : glyphs.rods) {
        dashes += (dash.to - dash.from).norm();
        const auto on = [&](const LineGlyph& line) {
          return std::abs((dash.from - line.from).norm() + (dash.to - dash.from).norm() +
                          (line.to - dash.to).norm() - (line.to - line.from).norm()) < 1e-12;
        };
        EXPECT_TRUE(std::any_of(glyphs.lines.begin(), glyphs.lines.end(), on));
      }
      EXPECT_NEAR(dashes / length, 0.5, 0.1);
    }
  }
}

}  // namespace
}  // namespace polhode
