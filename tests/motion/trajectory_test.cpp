// SPDX-License-Identifier: MIT
#include "motion/trajectory.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/simulate.h"
#include "support/loads.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

TEST(DriftWatch, RecordsTheWorstAndKeepsNaN) {
  const Problem p = hairer_vilmart();
  DriftWatch watch(p.model, p.start);
  watch.look_at(p.start);
  EXPECT_EQ(watch.worst().energy.value(), 0.0);
  State off = p.start;
  off.y *= 1.01;
  watch.look_at(off);
  EXPECT_NEAR(watch.worst().energy.value(), 0.0201, 1e-15);
  EXPECT_NEAR(watch.worst().momentum.value(), 0.01, 1e-15);
  watch.look_at(p.start);
  EXPECT_NEAR(watch.worst().momentum.value(), 0.01, 1e-15);
  off.y[0] = std::nan("");
  watch.look_at(off);
  watch.look_at(p.start);
  EXPECT_TRUE(std::isnan(watch.worst().energy.value()));
}

TEST(DriftWatch, OnAPivotOnlyTheVerticalMomentumCounts) {
  const Problem p = heavy_asymmetric();
  DriftWatch watch(p.model, p.start);
  // a turn about the vertical changes L in space but nothing that is conserved
  State turned = p.start;
  turned.q = exp_rotation(0.8 * p.model.up_S) * p.start.q;
  watch.look_at(turned);
  EXPECT_LE(watch.worst().momentum.value(), 1e-15);
  EXPECT_LE(watch.worst().energy.value(), 1e-15);
}

// heavier than an absolute number: of energy in its own size, with its sign; of L by its change
TEST(DriftWatch, IsRelativeToTheStartAndSigned) {
  Problem p = hairer_vilmart();
  for (const double scale : {1.0, 1e-6}) {
    p.start.y = scale * Vec3(1.8, 0.4, -0.9);
    const DriftWatch watch(p.model, p.start);
    State slower = p.start;
    slower.y *= 0.9;
    EXPECT_NEAR(watch.of(slower).energy.value(), 0.81 - 1.0, 1e-14);
    EXPECT_NEAR(watch.of(slower).momentum.value(), 0.1, 1e-14);
    // |L| alone does not tell: its direction in space counts
    State turned = p.start;
    turned.q = exp_rotation(0.2 * p.start.y.unitOrthogonal());
    EXPECT_NEAR(watch.of(turned).momentum.value(), 2.0 * std::sin(0.1), 1e-14);
    EXPECT_EQ(watch.of(turned).energy.value(), 0.0);
  }
}

// at rest there is nothing to be relative to
TEST(DriftWatch, OfABodyAtRestIsAbsolute) {
  const BodyModel model = free_body({1, 2, 2.5});
  State pushed;
  pushed.y = Vec3(0, 0.3, 0);
  const DriftWatch watch(model, State());
  EXPECT_DOUBLE_EQ(watch.of(pushed).momentum.value(), 0.3);
  EXPECT_DOUBLE_EQ(watch.of(pushed).energy.value(), 0.3 * 0.3 / 2.0 / 2.0);
}

TEST(DriftWatch, SaysNothingOfWhatLoadsChange) {
  MotionSpec spec = spun({1, 0, 2});
  spec.torque = {load("damping")};
  spec.torque[0].c = 0.3;
  DriftWatch watch(make_model(body_with({1, 1.3, 1.6}), spec), State());
  watch.look_at(State());
  EXPECT_FALSE(watch.worst().energy.has_value());
  EXPECT_FALSE(watch.worst().momentum.has_value());
}

}  // namespace
}  // namespace polhode::test
