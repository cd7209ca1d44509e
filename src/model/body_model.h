// SPDX-License-Identifier: MIT
// The body as the equations of motion need it: principal moments about the reference point,
// gravity, right-hand side and invariants. Frames and letters: math/notation.h.
#pragma once

#include <string>
#include <vector>

#include "math/notation.h"
#include "model/body_spec.h"
#include "model/loads.h"
#include "model/mass_properties.h"

namespace polhode {

// What kind of top the three moments make.
struct TopKind {
  enum class Shape { spherical, prolate, oblate, asymmetric };
  Shape shape = Shape::asymmetric;
  int axis = 2;          // index (0..2 in P) of the symmetry axis; of prolate and oblate tops only
  bool planar = false;   // the largest moment is the sum of the others
  bool rotator = false;  // one moment is zero: all mass on a line

  bool symmetric() const { return shape == Shape::prolate || shape == Shape::oblate; }
  // "spherical", "symmetric prolate", "symmetric oblate" or "asymmetric", then "planar" or
  // "rotator"
  std::string name() const;
};

// Two moments closer than this, relative to the largest, are equal.
inline constexpr double kEqualMoments = 1e-12;

struct BodyModel {
  MassProperties body;                  // in B, tensor about the centre of mass
  bool on_pivot = false;                // one point of the body is fixed
  Vec3 pivot_B = Vec3::Zero();          // that point, m
  Vec3 gravity_S = Vec3::Zero();        // m/s^2
  Mat3 R_BP = Mat3::Identity();         // principal axes as columns, in B; closest to the axes of B
  Vec3 moments = Vec3::Ones();          // about the reference point, kg m^2, along P
  Vec3 inverse_moments = Vec3::Ones();  // 1/moments; 0 where a rotator has none
  TopKind kind;
  Vec3 up_S = Vec3::UnitZ();      // unit vector against gravity
  Vec3 chi_P = Vec3::Zero();      // m |g| (centre of mass - pivot), J; 0 for a free body
  Loads loads;                    // what acts besides gravity
  bool with_translation = false;  // states carry place and momentum of the centre of mass too

  // The fixed point, or the centre of mass, in B.
  const Vec3& reference_B() const { return on_pivot ? pivot_B : body.center; }
};

// Attitude and angular momentum about the reference point. q maps P to S, y is in P. With six
// degrees of freedom (BodyModel::with_translation) also place and momentum of the centre of mass.
struct State {
  Quat q = Quat::Identity();
  Vec3 y = Vec3::Zero();
  Vec3 place_S = Vec3::Zero();            // m
  Vec3 linear_momentum_S = Vec3::Zero();  // momentum m v, kg m/s
};

// Mass properties of a [body] table. Throws Error (input) with the key at fault.
MassProperties mass_properties(const BodySpec& spec);

// Everything a motion needs to know of a body. Throws Error (input): moments that no body has,
// a body without extent, and all that mass_properties refuses.
BodyModel make_model(const BodySpec& spec,
                     bool on_pivot,
                     const Vec3& gravity_S,
                     const std::vector<LoadSpec>& loads = {});

// The triangle inequality in all three permutations (a theorem: I1 + I2 - I3 = 2 sum m x3^2),
// within round-off. Returns "" or what is wrong.
std::string impossible_moments(const Vec3& moments);

TopKind classify(const Vec3& moments);

// w_P = I^-1 y
inline Vec3 angular_velocity(const BodyModel& m, const Vec3& y) {
  return m.inverse_moments.cwiseProduct(y);
}

// A symmetric body whose centre of mass is on its axis through the reference point, or at it.
bool center_on_symmetry_axis(const BodyModel& model);

// Up, seen from the body: gamma = Q^T up.
inline Vec3 up_in_body(const BodyModel& m, const Quat& q) {
  return q.conjugate() * m.up_S;
}

// dy/dt = y x w + gamma x chi
inline Vec3 momentum_rate(const BodyModel& m, const Vec3& y, const Vec3& gamma) {
  return y.cross(angular_velocity(m, y)) + gamma.cross(m.chi_P);
}

// dq/dt = q o (0, w) / 2
inline Quat attitude_rate(const Quat& q, const Vec3& w_P) {
  return Quat(0.5 * (q * Quat(0.0, w_P.x(), w_P.y(), w_P.z())).coeffs());
}

// Torque about the reference point in P at time t: that of the loads, and with gravity's.
Vec3 torque_of_loads(const BodyModel& m, double t, const State& s);
Vec3 torque(const BodyModel& m, double t, const State& s);

// The force on the centre of mass in S at time t, N.
Vec3 force(const BodyModel& m, double t, const State& s);

// Energy of rotation plus potential about the reference point, J: y.w/2 + chi.gamma, and the
// potential of loads. With six degrees of freedom also the energy of the centre of mass.
double energy(const BodyModel& m, const State& s);

// Potential of gravity and of constant forces on the centre of mass of a free body, J.
double potential_of_place(const BodyModel& m, const Vec3& center_S);

// Does the motion keep its energy, and its angular momentum (the vertical part on a pivot)?
bool keeps_energy(const BodyModel& m);
bool keeps_momentum(const BodyModel& m);

// Angular momentum about the reference point in S, kg m^2/s.
inline Vec3 momentum_in_space(const State& s) {
  return s.q * s.y;
}

}  // namespace polhode
