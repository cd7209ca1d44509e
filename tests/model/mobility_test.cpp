// SPDX-License-Identifier: MIT
#include "model/mobility.h"

#include <gtest/gtest.h>

namespace polhode::test {
namespace {

// How the slip changes where `push` acts, and friction of `strength` against the slip, on a point
// that friction accelerates `uneven` times as much along x as along y.
struct Slope {
  Vec3 push;
  double strength, uneven;
  mutable int calls = 0;

  Vec3 operator()(const Vec3& way) const {
    ++calls;
    return push - strength * Vec3(uneven * way.x(), way.y(), 0.0);
  }
};

double off_its_rate(const Slope& rate, const Vec3& way) {
  const Vec3 change = rate(way);
  return way.cross(change).norm() / rate.strength;
}

// the plain iteration takes up to 25 calls
TEST(Mobility, SlowSlipsHaveTheirDirectionInFewTurns) {
  for (const double surplus : {0.3, 0.01, 1e-4}) {
    for (const double uneven : {1.0, 3.0, 30.0}) {
      for (const double turned : {0.0, 0.02, 0.5}) {
        const Vec3 along(0.6, 0.8, 0.0);
        const double strength = 1.7;
        // rate(along) is surplus * along
        const Slope rate{
            surplus * along + strength * Vec3(uneven * 0.6, 0.8, 0.0), strength, uneven};
        const Vec3 start = Eigen::AngleAxisd(turned, Vec3::UnitZ()) * along;
        const double friction = 0.5 * strength * (1.0 + uneven);
        const Vec3 way = creep_direction(start, friction, rate);
        EXPECT_LT((way - along).norm(), 1e-9) << surplus << ", " << uneven << ", " << turned;
        EXPECT_LE(rate.calls, 9) << surplus << ", " << uneven << ", " << turned;
        EXPECT_LT(off_its_rate(rate, way), 1e-12);
        EXPECT_NEAR(way.norm(), 1.0, 1e-14);
      }
    }
  }
}

// where friction turns the direction about, or nothing is a number, an answer comes none the less
TEST(Mobility, WhatHasNoDirectionEnds) {
  const auto nothing = [](const Vec3&) {
    return Vec3(NAN, NAN, NAN);
  };
  EXPECT_EQ(creep_direction(Vec3::UnitX(), 1.0, nothing), Vec3(Vec3::UnitX()));
  const auto about = [](const Vec3& way) {
    return Vec3(-5.0 * way.x(), -5.0 * way.y(), 0.0);
  };
  EXPECT_NEAR(creep_direction(Vec3::UnitX(), 1.0, about).norm(), 1.0, 1e-14);
}

}  // namespace
}  // namespace polhode::test
