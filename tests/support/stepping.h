// SPDX-License-Identifier: MIT
// One method on one problem, for the tests of single methods.
#pragma once

#include <cmath>
#include <memory>

#include "math/so3.h"
#include "motion/stepper.h"
#include "motion/stepper_table.h"
#include "support/tops.h"

namespace polhode::test {

// for walks whose states nobody looks at
inline constexpr auto kLookAway = [](auto, const State&) {
};

inline std::unique_ptr<Stepper> stepper(const char* method, const Problem& p) {
  return find_stepper(method).make(p.model, p.start.y.norm());
}

// The state after n steps of length h.
inline State after(const char* method, const Problem& p, double h, long n) {
  const std::unique_ptr<Stepper> by = stepper(method, p);
  State s = p.start;
  for (long i = 0; i < n; ++i)
    by->step(static_cast<double>(i) * h, h, s);
  return s;
}

inline double energy(const Problem& p, const State& s) {
  return energy(p.model, s);
}

// How much energy is gained, relative.
inline double relative_energy(const Problem& p, const State& s) {
  return energy(p, s) / energy(p, p.start) - 1.0;
}

// I = (1, 1, 2) turns its transverse momentum at Omega = 2: times what a deviation of 1e-6 has
// grown in n steps that turn it by `turn` rad each.
inline double transverse_growth(const char* method, double turn, long n) {
  const Problem p{free_body({1, 1, 2}), {Quat::Identity(), {1e-6, 0, 4}}};
  return after(method, p, 0.5 * turn, n).y.head<2>().norm() / 1e-6;
}

// A sphere turns uniformly: dq/dt = i w/2 q in the plane of 1 and its axis, so one step multiplies
// q by the method's stability function at i h w / 2. This is the angle of one step of length 1 at
// w = `turn` rad/s, from the direction of q in that plane.
inline double turn_of_sphere(const char* method, double turn) {
  const Vec3 axis = Vec3(1, -2, 2) / 3.0;
  const Problem p{free_body({2, 2, 2}), {Quat::Identity(), 2.0 * turn * axis}};
  const Quat q = after(method, p, 1.0, 1).q;
  return 2.0 * std::atan2(q.vec().dot(axis), q.w());
}

// The tumbling box of MuJoCo's tests, half-sizes .1 .2 .3 m, 1 kg, turning at (1, 2, 3) rad/s.
inline Problem mujoco_box() {
  BodySpec spec;
  spec.solid.emplace();
  spec.solid->kind = "box";
  spec.solid->mass = 1.0;
  spec.solid->size = Vec3(0.2, 0.4, 0.6);
  Problem p{make_model(spec, false, Vec3::Zero()), {}};
  p.start.y = p.model.moments.cwiseProduct(Vec3(1, 2, 3));
  return p;
}

}  // namespace polhode::test
