// SPDX-License-Identifier: MIT
#include "frame/chevron.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"

namespace polhode {
namespace {

// all around, in wide and in upright rectangles: inside, at an edge, on the ray from the middle
TEST(Chevron, StandsAtTheEdgeAndInside) {
  constexpr double kLength = 20.0;
  for (const TextRoom& frame : {TextRoom{10, 20, 650, 300}, TextRoom{0, 0, 120, 700}}) {
    for (int k = 0; k < 72; ++k) {
      const double angle = 2.0 * kPi * k / 72;
      const Vec2 way(std::cos(angle), std::sin(angle));
      const Chevron chevron = chevron_in(frame, way, kLength);
      const TextRoom room = chevron.room();
      const double least = std::min({room.left - frame.left,
                                     room.top - frame.top,
                                     frame.right - room.right,
                                     frame.bottom - room.bottom});
      EXPECT_GE(least, -1e-9) << k;
      EXPECT_LE(least, kLength + 1e-9) << k;
      const Vec2 from_middle = chevron.tip - frame.center();
      EXPECT_NEAR((from_middle.normalized() - way).norm(), 0.0, 1e-9) << k;
    }
  }
}

TEST(Chevron, PointsAlongItsWay) {
  const Chevron chevron{{100, 50}, {0, -1}, 10};
  EXPECT_EQ(chevron.left_end().y(), 60.0);
  EXPECT_EQ(chevron.right_end().y(), 60.0);
  EXPECT_EQ(std::abs(chevron.left_end().x() - chevron.right_end().x()), 20.0);
}

// its colour at the tip, and clear where nothing is
TEST(Chevron, IsDrawnWhereItIs) {
  const Chevron chevron{{100.5, 50.5}, {1, 0}, 20};
  TextStyle style;
  style.color = {10, 200, 30};
  style.halo = 2.0;
  const Stamp stamp = stamp_of(chevron, style);
  const auto pixel = [&](int x, int y) {
    const auto at =
        static_cast<std::size_t>(4 * ((y - stamp.y) * stamp.sprite->width + x - stamp.x));
    return std::array{stamp.sprite->pixels[at + 1], stamp.sprite->pixels[at + 3]};
  };
  EXPECT_EQ(pixel(100, 50), (std::array<std::uint8_t, 2>{200, 255}));
  EXPECT_EQ(pixel(84, 50)[1], 0) << "between its ends";
}

}  // namespace
}  // namespace polhode
