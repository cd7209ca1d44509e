// SPDX-License-Identifier: MIT
#include "chart/section.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "math/so3.h"
#include "motion/stepper_table.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

// vertical and momentum in the body at a point of the surface
struct Reduced {
  Vec3 gamma, y;
};
Reduced reduced(const SectionSurface& surface, const Vec2& point) {
  const std::optional<State> state = surface.state_at(point.x(), point.y());
  EXPECT_TRUE(state);
  if (!state) return {};
  return {up_in_body(surface.model(), state->q), state->y};
}

State asymmetric_start() {
  return {Quat(Eigen::AngleAxisd(1.1, Vec3(0.5, 0.3, 0.8).normalized())), Vec3(0.9, 0.2, 1.1)};
}

// starts lie on the surface, with its energy and its vertical momentum
TEST(Section, StartsLieOnTheSurface) {
  const BodyModel model =
      heavy_body({0.6, 0.8, 1.0}, {0.3, -0.5, 0.7}, Vec3(0.2, 0.3, 1).normalized());
  const SectionSurface surface(model, asymmetric_start());
  const std::vector<Vec2> starts = surface.spread(100);
  ASSERT_EQ(starts.size(), 100U);
  for (const Vec2& at : starts) {
    const State state = surface.state_at(at.x(), at.y()).value();
    const Vec3 gamma = up_in_body(model, state.q);
    EXPECT_NEAR(energy(model, state), surface.energy(), 1e-12);
    EXPECT_NEAR(state.y.dot(gamma), surface.vertical_momentum(), 1e-12);
    EXPECT_NEAR(surface.vertical_F(state).x(), 0.0, 1e-15);
    EXPECT_GT(surface.vertical_F(state).y(), 0.0);
    EXPECT_LT((surface.point_of(state) - at).norm(), 1e-12);
    // it crosses in the right direction: a little later it is beyond
    State later = state;
    find_stepper("taylor16").make(model, 1.0)->step(0.0, 1e-4, later);
    EXPECT_GE(surface.vertical_F(later).x(), -1e-8);
  }
}

// a symmetric top keeps L_3: all crossings of a motion have it
TEST(Section, CrossingsOfASymmetricTopLieOnACurve) {
  const BodyModel model = heavy_body({0.5, 0.5, 1.0}, Vec3(0, 0, 0.8));
  const SectionSurface surface(model, asymmetric_start());
  for (const Vec2& at : surface.spread(8)) {
    const State start = surface.state_at(at.x(), at.y()).value();
    const SectionOrbit orbit = trace_section(surface, start, 100);
    ASSERT_EQ(orbit.points.size(), 100U);
    EXPECT_EQ(orbit.verdict, SectionVerdict::regular) << orbit.growth;
    EXPECT_LT(orbit.energy_drift, 1e-9);
    for (const Vec2& point : orbit.points)
      EXPECT_NEAR(reduced(surface, point).y.z(), start.y.z(), 1e-8);
  }
}

// Kovalevskaya's integral, and no chaos
TEST(Section, CrossingsOfKovalevskayasTopLieOnCurves) {
  const double nu = 0.9;  // m g l / I3
  const BodyModel model = heavy_body({2.0, 2.0, 1.0}, Vec3(nu, 0, 0));
  const SectionSurface surface(model, asymmetric_start());
  const auto integral = [&](const Reduced& s) {
    const Vec3 w = angular_velocity(model, s.y);
    return std::pow(w.x() * w.x() - w.y() * w.y() - nu * s.gamma.x(), 2) +
           std::pow(2 * w.x() * w.y() - nu * s.gamma.y(), 2);
  };
  for (const Vec2& at : surface.spread(8)) {
    const State start = surface.state_at(at.x(), at.y()).value();
    const double wanted = integral(reduced(surface, at));
    const SectionOrbit orbit = trace_section(surface, start, 100);
    ASSERT_GT(orbit.points.size(), 20U);
    EXPECT_EQ(orbit.verdict, SectionVerdict::regular) << orbit.growth;
    for (const Vec2& point : orbit.points)
      EXPECT_NEAR(integral(reduced(surface, point)), wanted, 1e-7 * (1.0 + wanted));
  }
}

// a body without symmetry has chaotic motions and regular ones on the same surface
TEST(Section, OthersHaveChaos) {
  const BodyModel model = heavy_body({0.6, 0.8, 1.0}, {0.5, -0.4, 0.3});
  const SectionSurface surface(model, {Quat::Identity(), Vec3(0.4, 0.1, 0.9)});
  int chaotic = 0;
  for (const Vec2& at : surface.spread(12)) {
    const State start = surface.state_at(at.x(), at.y()).value();
    chaotic += trace_section(surface, start, 300).verdict == SectionVerdict::chaotic ? 1 : 0;
  }
  EXPECT_GT(chaotic, 3);
}

// the first crossings of another integration, with steps of Taylor series and bisection
std::vector<Vec2> crossings_by_taylor(const SectionSurface& surface,
                                      const State& start,
                                      std::size_t count,
                                      double step) {
  const std::unique_ptr<Stepper> taylor =
      find_stepper("taylor16").make(surface.model(), start.y.norm());
  std::vector<Vec2> crossings;
  State s = start;
  for (int k = 0; crossings.size() < count && k < 1'000'000; ++k) {
    const double t = k * step;
    State next = s;
    taylor->step(t, step, next);
    if (surface.vertical_F(s).x() < 0.0 && surface.vertical_F(next).x() >= 0.0) {
      double low = 0.0, high = step;
      State at = s;
      for (int i = 0; i < 60; ++i) {
        at = s;
        taylor->step(t, 0.5 * (low + high), at);
        (surface.vertical_F(at).x() < 0.0 ? low : high) = 0.5 * (low + high);
      }
      EXPECT_NEAR(surface.vertical_F(at).x(), 0.0, 1e-13);
      if (surface.vertical_F(at).y() > 0.0) crossings.push_back(surface.point_of(at));
    }
    s = next;
  }
  return crossings;
}

TEST(Section, CrossingsAreThoseOfAnotherIntegration) {
  const BodyModel model = heavy_body({0.6, 0.8, 1.0}, {0.5, -0.4, 0.3});
  const State start{Quat::Identity(), Vec3(0.4, 0.1, 0.9)};
  const SectionSurface surface(model, start);
  const SectionOrbit orbit = trace_section(surface, start, 4);
  const std::vector<Vec2> wanted = crossings_by_taylor(surface, start, 4, 0.02);
  ASSERT_EQ(orbit.points.size(), 4U);
  ASSERT_EQ(wanted.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT((orbit.points[i] - wanted[i]).norm(), 1e-9) << i;
}

// Kovalevskaya's top, which passes the surface and comes back within one step of the integration
// before its 26th crossing
TEST(Section, CrossingsThatGrazeTheSurfaceCount) {
  const BodyModel model = heavy_body({2.0, 2.0, 1.0}, {2.152912793863892, 0.0, 0.0});
  const State start{
      from_zxz_angles(Vec3(350.4377618686723, 42.961142599483566, 102.11094473695223) * kPi /
                      180.0),
      model.moments.cwiseProduct(
          Vec3(-2.350615774003687, -0.7153828331357193, -1.8225544441394572))};
  const SectionSurface surface(model, start);
  const std::size_t count = 30;
  const SectionOrbit orbit = trace_section(surface, start, static_cast<int>(count));
  const std::vector<Vec2> wanted = crossings_by_taylor(surface, start, count, 0.01);
  ASSERT_EQ(orbit.points.size(), count);
  ASSERT_EQ(wanted.size(), count);
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_LT((orbit.points[i] - wanted[i]).norm(), 1e-6) << i;
}

// a sleeping top, a pendulum that swings in a plane and a body at rest stay on the surface
TEST(Section, MotionsThatLieOnTheSurfaceEnd) {
  const BodyModel top = heavy_body({0.6, 0.6, 1.0}, {0.0, 0.0, 0.7}, Vec3::UnitZ());
  const BodyModel box = heavy_body({0.6, 0.8, 1.0}, {0.0, -0.5, 0.0}, Vec3::UnitZ());
  const Quat tilted(Eigen::AngleAxisd(1.0, Vec3::UnitX()));
  for (const auto& [model, start] : {std::pair{top, State{Quat::Identity(), {0.0, 0.0, 5.0}}},
                                     {top, State{Quat::Identity(), {0.0, 0.0, 0.0}}},
                                     {box, State{tilted, {0.0, 0.0, 0.0}}}}) {
    const SectionSurface surface(model, start);
    EXPECT_TRUE(trace_section(surface, start, 5).points.empty());
  }
}

TEST(Section, OthersHaveNone) {
  EXPECT_EQ(why_not_section(free_body({1, 2, 3})).value().key, "motion.hold");
  EXPECT_FALSE(why_not_section(heavy_asymmetric().model).has_value());
  BodyModel tiny = heavy_asymmetric().model;
  tiny.chi_P *= 1e-20;  // as of a grain
  EXPECT_FALSE(why_not_section(tiny).has_value());
}

TEST(Section, NamesTheKeyOfWhatItCannotTake) {
  BodyModel model = heavy_asymmetric().model;
  model.loads.gimbals.emplace();
  EXPECT_EQ(why_not_section(model).value().key, "motion.gimbals");
  model.loads.gimbals.reset();
  Load frame;
  frame.kind = Load::Kind::frame;
  model.loads.turning = {frame};
  EXPECT_EQ(why_not_section(model).value().key, "motion.frame_rotation");
  model.loads.turning = {Load{}};
  EXPECT_EQ(why_not_section(model).value().key, "motion.torque");
}

}  // namespace
}  // namespace polhode::test
