// SPDX-License-Identifier: MIT
// Hamilton's principle (notes, eqs. 7, 20, 23 to 25, corrected): along the motions found the
// action, the integral of T - U, is stationary under every variation that leaves both ends where
// they are.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "base/units.h"
#include "math/so3.h"
#include "motion/simulate.h"
#include "support/motions.h"
#include "support/particles.h"
#include "support/residual.h"

namespace polhode {
namespace {

using test::expect_effect;
using test::expect_residual;

// A variation: turns (about body axes) and shifts that vanish at both ends, with their rates.
struct Variation {
  Vec3 turn[3], shift[3];
  double duration;

  static Variation random(std::uint64_t seed, double duration) {
    test::Dice dice(seed);
    Variation v;
    v.duration = duration;
    for (int k = 0; k < 3; ++k) {
      v.turn[k] = dice.vector();
      v.shift[k] = dice.vector();
    }
    return v;
  }
  Vec3 sum(const Vec3* terms, double t) const {
    Vec3 total = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      total += std::sin((k + 1) * kPi * t / duration) * terms[k];
    return total;
  }
  Vec3 rate(const Vec3* terms, double t) const {
    Vec3 total = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      const double w = (k + 1) * kPi / duration;
      total += w * std::cos(w * t) * terms[k];
    }
    return total;
  }
};

// the angular velocity that d/dt exp(v) adds in body axes: the right Jacobian of SO(3)
Vec3 right_jacobian(const Vec3& v, const Vec3& v_rate) {
  const double a = v.norm();
  if (a < 1e-12) return v_rate;
  return v_rate - (1 - std::cos(a)) / (a * a) * v.cross(v_rate) +
         (a - std::sin(a)) / (a * a * a) * v.cross(v.cross(v_rate));
}

// T - U of the motion varied by eps, at time t; `clock` runs the motion faster (1: as found)
double lagrangian(const Motion& motion, const Variation& v, double eps, double t, double clock) {
  const BodyModel& m = motion.model();
  const Sample s = motion.at(clock * t);
  const Vec3 turn = eps * v.sum(v.turn, t);
  const Mat3 R_PB = m.R_BP.transpose();
  const Quat q = s.q_SB * Quat(m.R_BP) * exp_rotation(turn);
  const Vec3 w_P = exp_rotation(turn).conjugate() * (clock * (R_PB * s.w_B)) +
                   right_jacobian(turn, eps * v.rate(v.turn, t));
  const double kinetic = 0.5 * w_P.dot(m.moments.cwiseProduct(w_P));
  const Vec3 place =
      m.on_pivot ? Vec3(Vec3::Zero()) : Vec3(s.reference_S + eps * v.sum(v.shift, t));
  const double potential = m.chi_P.dot(up_in_body(m, q)) + potential_of(m.loads.turning, q, place);
  if (m.on_pivot) return kinetic - potential;
  const Vec3 velocity = clock * s.reference_velocity_S + eps * v.rate(v.shift, t);
  return kinetic + 0.5 * m.body.mass * velocity.squaredNorm() - potential -
         potential_of_place(m, place);
}

// dS/d eps by central differences, the integral by Simpson's rule; relative to the size of T + |U|
double first_variation(const Motion& motion, const Variation& v, double clock = 1.0) {
  constexpr int kPieces = 4000;
  constexpr double kEps = 1e-4;
  double sum = 0.0;
  for (int i = 0; i <= kPieces; ++i) {
    const double t = v.duration * i / kPieces;
    const double weight = i == 0 || i == kPieces ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum +=
        weight * (lagrangian(motion, v, kEps, t, clock) - lagrangian(motion, v, -kEps, t, clock));
  }
  return std::abs(sum / 3.0 / kPieces / (2.0 * kEps)) / (1.0 + std::abs(motion.at(0.0).energy));
}

MotionSpec spun() {
  MotionSpec spec;
  spec.duration = 3.0;
  spec.attitude.zxz = Vec3(0.3, 0.9, -0.4);
  spec.spin.body = Vec3(0.7, -0.5, 1.6);
  return spec;
}

void is_stationary(const BodySpec& body, const MotionSpec& spec) {
  const Motion motion = simulate(make_model(body, spec), spec, {}, 1e-11).motion;
  double wrong = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Variation v = Variation::random(seed, 2.0);
    // central differences leave eps^2
    expect_residual("first variation", first_variation(motion, v), 2e-7);
    wrong = std::max(wrong, first_variation(motion, v, 1.05));
  }
  // the same path at another pace is no motion
  expect_effect("first variation of a wrong path", wrong, 1e-3);
}

TEST(Action, IsStationaryForFreeBodies) {
  BodySpec body;
  body.moments = Vec3(1.0, 1.4, 1.9);
  MotionSpec spec = spun();
  spec.gravity = Vec3(0.1, -0.3, -2.0);
  spec.velocity = Vec3(0.4, 0.2, 1.0);
  is_stationary(body, spec);
}

TEST(Action, IsStationaryForHeavyTops) {
  for (const Vec3& center : {Vec3(0, 0, 0.6), Vec3(0.3, -0.2, 0.4)}) {
    BodySpec body;
    body.moments = Vec3(1.3, 1.3, 0.9);
    body.about = "pivot";
    body.center_of_mass = center;
    MotionSpec spec = spun();
    spec.hold = "pivot";
    spec.gravity = Vec3(0, 0, -3.0);
    is_stationary(body, spec);
  }
}

// U depends on place and attitude (notes, errata row 23)
TEST(Action, IsStationaryForABodyOnASpring) {
  BodySpec body;
  body.moments = Vec3(1.0, 1.4, 1.9);
  MotionSpec spec = spun();
  spec.position = Vec3(0.5, 0.2, -0.4);
  spec.torque.resize(1);
  spec.torque[0].kind = "spring";
  spec.torque[0].k = 3.0;
  spec.torque[0].length = 0.2;
  spec.torque[0].at = Vec3(0.3, 0.5, 0.1);
  is_stationary(body, spec);
}

}  // namespace
}  // namespace polhode
