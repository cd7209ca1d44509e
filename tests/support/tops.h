// SPDX-License-Identifier: MIT
// The bodies that the tests of model and motion share, most of them published test problems.
#pragma once

#include <algorithm>
#include <cmath>

#include "math/so3.h"
#include "model/body_model.h"

namespace polhode::test {

// A body with these moments about the centre of mass and nothing that turns it.
inline BodyModel free_body(const Vec3& moments) {
  BodySpec spec;
  spec.moments = moments;
  spec.mathematical = true;
  return make_model(spec, false, Vec3::Zero());
}

// A body on a pivot with these moments about it, and chi = m g (centre of mass - pivot) in J.
inline BodyModel heavy_body(const Vec3& moments,
                            const Vec3& chi,
                            const Vec3& up_S = Vec3::UnitZ()) {
  BodySpec spec;
  spec.moments = moments;
  spec.mathematical = true;
  spec.about = "pivot";
  spec.center_of_mass = chi;
  return make_model(spec, true, -up_S);
}

struct Problem {
  BodyModel model;
  State start;
};

// Hairer and Vilmart, J. Phys. A 39 (2006) 13225: the asymmetric body.
inline Problem hairer_vilmart() {
  return {free_body({0.6, 0.8, 1.0}), {Quat::Identity(), {1.8, 0.4, -0.9}}};
}

// Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.5.3: a heavy symmetric top.
inline Problem gni_heavy_top() {
  return {heavy_body({0.5, 0.5, 1.0}, Vec3::UnitZ()), {Quat(0.4, 0.2, 0.4, 0.8), {0.2, 1.0, 0.4}}};
}

// A heavy body without symmetry, for what must hold for every body.
inline Problem heavy_asymmetric() {
  return {heavy_body({0.6, 0.8, 1.0}, {0.3, -0.5, 0.7}),
          {exp_rotation({0.4, 1.1, -0.3}), {1.0, 0.4, -0.9}}};
}

// The same with its angular momentum up: the third axis then stays away from the vertical if it
// stays away from L, and angles about it exist.
inline Problem upright(Problem p) {
  p.start.q = turn_between(p.start.y, Vec3::UnitZ());
  return p;
}

// Attitude difference in rad and relative difference of y, as one length; NaN if one of them is.
inline double distance(const State& a, const State& b) {
  return std::hypot(rotation_angle_between(a.q, b.q),
                    (a.y - b.y).norm() / std::max(b.y.norm(), 1e-300));
}

// to the last bit
inline bool same_bits(const State& a, const State& b) {
  return a.q.coeffs() == b.q.coeffs() && a.y == b.y;
}

}  // namespace polhode::test
