// SPDX-License-Identifier: MIT
// Ready motions for tests: a body, held and started as a scene would.
#pragma once

#include "base/units.h"
#include "motion/simulate.h"

namespace polhode::test {

inline BodySpec body_of(const SolidSpec& solid) {
  BodySpec body;
  body.solid = solid;
  return body;
}

inline BodySpec ellipsoid_body(const Vec3& semi_axes) {
  SolidSpec solid;
  solid.kind = "ellipsoid";
  solid.semi_axes = semi_axes;
  solid.mass = 1.0;
  return body_of(solid);
}

inline BodySpec prolate_body() {
  return ellipsoid_body({0.1, 0.1, 0.2});
}
inline BodySpec oblate_body() {
  return ellipsoid_body({0.15, 0.15, 0.06});
}

// no two moments alike
inline BodySpec brick_body() {
  SolidSpec solid;
  solid.kind = "box";
  solid.size = Vec3(0.3, 0.2, 0.06);
  solid.mass = 1.0;
  return body_of(solid);
}

// tilted by 40 degrees, spinning and wobbling
inline MotionSpec wobbling() {
  MotionSpec motion;
  motion.duration = 4.0;
  motion.attitude.zxz = Vec3(0.3, 40.0 * kPi / 180.0, 0.2);
  motion.spin.body = Vec3(1.1, 0.4, 2.0);
  return motion;
}

inline Motion moving(const BodySpec& body, const MotionSpec& spec) {
  const BodyModel model = make_model(body, spec);
  return simulate(model, spec, NumericsSpec{}, 1e-6).motion;
}

// a cone on its apex, released from rest tilt with a spin
inline BodySpec cone_body() {
  SolidSpec solid;
  solid.kind = "cone";
  solid.radius = 0.03;
  solid.height = 0.05;
  solid.mass = 0.1;
  return body_of(solid);
}

inline MotionSpec spinning_on_pivot() {
  MotionSpec motion;
  motion.hold = "pivot";
  motion.duration = 2.0;
  motion.attitude.zxz = Vec3(0.0, 0.5, 0.0);
  motion.spin.rates = Vec3(0.0, 0.0, 400.0);
  return motion;
}

}  // namespace polhode::test
