// SPDX-License-Identifier: MIT
#include "motion/ensemble.h"

#include <gtest/gtest.h>

#include "math/so3.h"
#include "motion/deviation.h"
#include "support/expect_error.h"
#include "support/motions.h"
#include "support/tops.h"

namespace polhode {
namespace {

MotionSpec spec_with(double tilt, double momentum) {
  MotionSpec spec = test::wobbling();
  spec.ensemble = EnsembleSpec{300, tilt, momentum};
  return spec;
}

// all lie in the balls, and fill them: half of the points beyond 0.79 of the radius
TEST(Ensemble, StartsFillTheBalls) {
  const MotionSpec spec = spec_with(0.1, 0.02);
  const BodyModel model = make_model(test::brick_body(), spec);
  const State start = start_state(model, spec);
  const std::vector<MotionSpec> members = ensemble_of(model, spec);
  ASSERT_EQ(members.size(), 300U);
  int far = 0;
  Vec3 mean = Vec3::Zero();
  for (const MotionSpec& member : members) {
    const State s = start_state(model, member);
    const double turned = rotation_angle_between(s.q, start.q);
    const Vec3 change = s.q * s.y - start.q * start.y;
    EXPECT_LE(turned, 0.1 + 1e-12);
    EXPECT_LE(change.norm(), 0.02 * start.y.norm() + 1e-12);
    far += turned > 0.0794 ? 1 : 0;
    mean += change / (0.02 * start.y.norm()) / 300.0;
    EXPECT_EQ(member.duration, spec.duration);
    EXPECT_FALSE(member.ensemble);
  }
  EXPECT_NEAR(far, 150, 35);
  EXPECT_LT(mean.norm(), 0.1);
}

// turned alone, a free body keeps its momentum in space, and the other way round
TEST(Ensemble, EachBallIsForItself) {
  const BodyModel model = make_model(test::brick_body(), test::wobbling());
  const State start = start_state(model, test::wobbling());
  for (const MotionSpec& member : ensemble_of(model, spec_with(0.1, 0.0))) {
    const State s = start_state(model, member);
    EXPECT_LT((s.q * s.y - start.q * start.y).norm(), 1e-12);
  }
  for (const MotionSpec& member : ensemble_of(model, spec_with(0.0, 0.1)))
    EXPECT_LT(rotation_angle_between(start_state(model, member).q, start.q), 1e-12);
}

// no body whose mass lies on a line has momentum along it
TEST(Ensemble, BodiesOfOneLineTakeWhatIsAcrossIt) {
  BodySpec rotator;
  rotator.moments = Vec3(2.0, 2.0, 0.0);
  MotionSpec spec = spec_with(0.1, 0.1);
  spec.spin = {};
  spec.spin.body = Vec3(1.0, 0.5, 0.0);
  const BodyModel model = make_model(rotator, spec);
  for (const MotionSpec& member : ensemble_of(model, spec))
    EXPECT_LT(std::abs(start_state(model, member).y.z()), 1e-12);
}

// The scalar core is the judge: each member by itself, which is integrated by another method and
// knows of no other. Neither is off by more than the accuracy.
TEST(Ensemble, TogetherMotionsAreWhatTheyAreAlone) {
  constexpr double kAccuracy = 1e-7;
  const BodyModel model = test::heavy_asymmetric().model;
  MotionSpec spec;
  spec.hold = "pivot";
  spec.duration = 6.0;
  spec.spin.body = Vec3(1.0, 0.4, 2.0);
  spec.ensemble = EnsembleSpec{21, 0.05, 0.02};
  const std::vector<MotionSpec> members = ensemble_of(model, spec);
  const std::vector<Simulation> together = simulate_ensemble(model, members, {}, kAccuracy, 2);
  ASSERT_EQ(together.size(), members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Simulation alone = simulate(model, members[i], {}, kAccuracy);
    EXPECT_TRUE(together[i].report.reliability.doubts.empty());
    EXPECT_LE(together[i].report.error_estimate_rad.value(), kAccuracy);
    double apart = 0.0;
    for (const double t : scattered_times(spec.duration, 100, 3)) {
      apart = std::max(apart,
                       deviation(model, together[i].motion.state_at(t), alone.motion.state_at(t)));
    }
    EXPECT_LE(apart, 2.0 * kAccuracy);
    // the same bits as alone from where the first one ended
    NumericsSpec numerics;
    numerics.method = together[i].report.method;
    const SimulationReport* neighbour = i < 8 ? nullptr : &together[0].report;
    const Simulation again = simulate(model, members[i], numerics, kAccuracy, {}, neighbour);
    EXPECT_EQ(again.report.tolerance, together[i].report.tolerance);
    EXPECT_EQ(again.report.error_estimate_rad, together[i].report.error_estimate_rad);
    EXPECT_EQ(again.motion.state_at(5.5).y, together[i].motion.state_at(5.5).y);
  }
}

// runs that are too coarse for a chaotic motion are no closer to each other than coarser ones, but
// round-off is not why
TEST(Ensemble, ChaosIsNotTakenForRoundOff) {
  MotionSpec spec;
  spec.hold = "pivot";
  spec.duration = 16.0;
  spec.attitude.zxz = Vec3(20, 100, 30) * kPi / 180.0;
  spec.spin.body = Vec3(6, 12, -4);
  BodySpec body;
  SolidSpec& solid = body.solid.emplace();
  solid.kind = "box";
  solid.size = Vec3(0.24, 0.115, 0.07);
  solid.density = 1800.0;
  body.pivot = Vec3(0.12, 0.0575, 0.035);
  NumericsSpec numerics;
  numerics.method = "dop853";
  EXPECT_LE(simulate(make_model(body, spec), spec, numerics, 1e-4).report.error_estimate_rad, 1e-4);
}

TEST(Ensemble, NeedsSomethingThatDiffers) {
  const MotionSpec spec = spec_with(0.0, 0.0);
  const BodyModel model = make_model(test::brick_body(), spec);
  test::expect_input_error([&] { ensemble_of(model, spec); }, "motion.ensemble", "begin alike");
  EXPECT_TRUE(ensemble_of(model, test::wobbling()).empty());
}

}  // namespace
}  // namespace polhode
