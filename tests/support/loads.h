// SPDX-License-Identifier: MIT
// Bodies, starts and loads for tests of torques and forces.
#pragma once

#include <string>

#include "motion/simulate.h"

namespace polhode::test {

inline LoadSpec load(const std::string& kind) {
  LoadSpec spec;
  spec.kind = kind;
  return spec;
}

// 1 kg with these moments
inline BodySpec body_with(const Vec3& moments) {
  BodySpec body;
  body.moments = moments;
  return body;
}

inline Simulation solved(const BodySpec& body,
                         const MotionSpec& spec,
                         const NumericsSpec& numerics = {}) {
  return simulate(make_model(body, spec), spec, numerics, 1e-11);
}

inline MotionSpec spun(const Vec3& spin_B, double duration = 4.0) {
  MotionSpec spec;
  spec.duration = duration;
  spec.attitude.zxz = Vec3(0.3, 0.7, -0.2);
  spec.spin.body = spin_B;
  return spec;
}

}  // namespace polhode::test
