// SPDX-License-Identifier: MIT
#include "model/figure_axis.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

// its centre of mass is the origin
Vec3 axis_of(const Vec3& moments, bool on_pivot, const Vec3& pivot) {
  BodySpec spec;
  spec.moments = moments;
  spec.mass = 1.0;
  spec.pivot = pivot;
  return figure_axis_B(make_model(spec, on_pivot, on_pivot ? Vec3(0, 0, -9.81) : Vec3::Zero()));
}

TEST(FigureAxis, IsThatOfSymmetryTowardsTheCentreOfMass) {
  EXPECT_EQ(axis_of({1, 2, 2}, false, Vec3::Zero()), Vec3::UnitX());
  EXPECT_EQ(axis_of({2, 2, 1}, true, {0, 0, -0.5}), Vec3::UnitZ());
  EXPECT_EQ(axis_of({2, 2, 1}, true, {0, 0, 0.5}), Vec3(-Vec3::UnitZ())) << "it hangs";
}

TEST(FigureAxis, OfOthersLeadsFromThePivotToTheCentreOfMass) {
  EXPECT_EQ(axis_of({1, 1.5, 2}, false, Vec3::Zero()), Vec3::UnitZ());
  EXPECT_EQ(axis_of({1, 1.5, 2}, true, Vec3::Zero()), Vec3::UnitZ()) << "held at the centre";
  EXPECT_LT((axis_of({1, 1.5, 2}, true, {0.3, 0, 0.4}) - Vec3(-0.6, 0, -0.8)).norm(), 1e-15);
}

}  // namespace
}  // namespace polhode
