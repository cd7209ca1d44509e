// SPDX-License-Identifier: MIT
// Bodies on a table for tests.
#pragma once

#include "base/units.h"
#include "motion/simulate.h"

namespace polhode::test {

constexpr double kG = 9.80665;  // m/s^2

// a solid that a radius (m) and a mass (kg) describe
inline BodySpec round_body(const char* kind, double radius, double mass) {
  BodySpec body;
  body.solid = SolidSpec{};
  body.solid->kind = kind;
  body.solid->radius = radius;
  body.solid->mass = mass;
  return body;
}
inline BodySpec ball_body(double radius = 0.028, double mass = 0.17) {
  return round_body("sphere", radius, mass);
}
inline BodySpec disc_body(double radius = 0.0375, double mass = 0.4) {
  return round_body("disc", radius, mass);
}

inline BodySpec ellipsoid_body(const Vec3& semi_axes, double mass) {
  BodySpec body;
  body.solid = SolidSpec{};
  body.solid->kind = "ellipsoid";
  body.solid->semi_axes = semi_axes;
  body.solid->mass = mass;
  return body;
}

// a sphere of 2 cm whose centre is e radii above the centre of mass, with I1 : I3 as given
inline BodySpec tippe_top_body(double e = 0.25, double ratio = 1.1) {
  constexpr double kAlong = 7.2e-6;  // kg m^2
  BodySpec body;
  body.moments = Vec3(ratio * kAlong, ratio * kAlong, kAlong);
  body.mass = 0.02;
  body.look = SolidSpec{};
  body.look->kind = "sphere";
  body.look->radius = 0.02;
  body.look->at = Vec3(0, 0, 0.02 * e);
  return body;
}

// an ellipsoid whose inertia axes are turned by `turn` (rad) about z against its shape
inline BodySpec rattleback_body(double turn = 0.03) {
  const Mat3 R = Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
  BodySpec body;
  body.tensor = R * Vec3(2e-5, 1.6e-4, 1.7e-4).asDiagonal() * R.transpose();
  body.mass = 0.1;
  body.center_of_mass = Vec3(0, 0, -0.003);
  body.look = SolidSpec{};
  body.look->kind = "ellipsoid";
  body.look->semi_axes = Vec3(0.1, 0.02, 0.015);
  return body;
}

inline FrictionSpec rolling() {
  FrictionSpec friction;
  friction.kind = "rolling";
  return friction;
}
inline FrictionSpec coulomb(double mu) {
  FrictionSpec friction;
  friction.mu = mu;
  return friction;
}
inline FrictionSpec viscous(double c) {
  FrictionSpec friction;
  friction.kind = "viscous";
  friction.c = c;
  return friction;
}

inline MotionSpec on_table(double duration, const std::optional<FrictionSpec>& friction) {
  MotionSpec motion;
  motion.hold = "table";
  motion.duration = duration;
  motion.friction = friction;
  return motion;
}

inline Simulation simulated(const BodySpec& body, const MotionSpec& spec, double accuracy = 1e-9) {
  return simulate(make_model(body, spec), spec, NumericsSpec{}, accuracy);
}

// with a given tolerance, without estimates
inline Integration integrated(const BodySpec& body, const MotionSpec& spec, double tolerance) {
  const BodyModel model = with_needed_degrees(make_model(body, spec));
  return integrate_with(
      find_stepper("dop853"), model, start_state(model, spec), spec.duration, tolerance);
}

}  // namespace polhode::test
