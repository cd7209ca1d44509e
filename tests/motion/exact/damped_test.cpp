// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "math/so3.h"
#include "motion/exact/exact.h"
#include "support/loads.h"
#include "support/residual.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

// -c L: the closed forms in rescaled time against the equations of motion
TEST(Damped, RescaledTimeIsTheMotion) {
  BodySpec rotator;
  rotator.points = {{1.0, {0, 0, 1}}, {1.0, {0, 0, -1}}};
  const std::pair<std::string, BodySpec> cases[] = {{"spherical", body_with({1, 1, 1})},
                                                    {"symmetric", body_with({1, 1, 1.7})},
                                                    {"asymmetric", body_with({1, 1.3, 1.7})},
                                                    {"symmetric", rotator}};
  for (const auto& [model, body] : cases) {
    SCOPED_TRACE(model);
    const bool is_rotator = !body.points.empty();
    MotionSpec spec = spun(is_rotator ? Vec3(2, 1, 0) : Vec3(2.0, 1.5, 3.0), 6.0);
    spec.torque = {load("damping")};
    spec.torque[0].c = 0.35;
    const Simulation exact = solved(body, spec);
    EXPECT_EQ(exact.report.model, model);
    EXPECT_EQ(exact.report.method, "exact");
    NumericsSpec numerics;
    numerics.model = "ode";
    numerics.tolerance = 1e-14;
    numerics.method = "dopri5";
    const Simulation integrated = solved(body, spec, numerics);
    const Vec3 L = exact.motion.at(0.0).L_S;
    for (const double t : {0.5, 3.0, 6.0}) {
      const Sample s = exact.motion.at(t);
      expect_residual("L", (s.L_S - std::exp(-0.35 * t) * L).norm() / L.norm(), 1e-14);
      expect_residual(
          "attitude", rotation_angle_between(s.q_SB, integrated.motion.at(t).q_SB), 1e-10);
      expect_residual("omega", (s.w_B - integrated.motion.at(t).w_B).norm(), 1e-10);
    }
  }
}

// of a sphere: it turns about L by |w| (1 - exp(-c t)) / c
TEST(Damped, ASphereSlowsDownAlongItsAxis) {
  const Problem p{free_body({2, 2, 2}), {exp_rotation({0.3, 0.1, -0.2}), {0.6, -0.8, 2.4}}};
  const Vec3 w = 0.5 * p.start.y;
  for (const double c : {0.35, 1e-12}) {
    const auto motion = damped(exact_spherical(p.model, p.start), c);
    for (const double t : {0.0, 0.5, 6.0}) {
      const double turned = -std::expm1(-c * t) / c;  // 1 - exp has no digits left for the small c
      const State wanted{p.start.q * exp_rotation(turned * w), std::exp(-c * t) * p.start.y};
      expect_residual("sphere", distance(motion->at(t), wanted), 1e-14);
    }
  }
}

// in the end it stands still, turned by a finite angle
TEST(Damped, ComesToRest) {
  const Problem p = hairer_vilmart();
  const double c = 0.5;
  const auto motion = damped(exact_asymmetric(p.model, p.start), c);
  const State end = motion->at(200.0);
  EXPECT_LE(end.y.norm(), 1e-40);
  const Quat wanted = exact_asymmetric(p.model, p.start)->at(1.0 / c).q;
  EXPECT_LE(rotation_angle_between(end.q, wanted), 1e-15);
}

}  // namespace
}  // namespace polhode::test
