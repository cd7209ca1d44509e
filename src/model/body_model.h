// SPDX-License-Identifier: MIT
// The body as the equations of motion use it: principal moments about the reference point, gravity,
// loads, right-hand side and invariants. Frames: math/notation.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "math/notation.h"
#include "model/body_spec.h"
#include "model/friction.h"
#include "model/loads.h"
#include "model/mass_properties.h"

namespace polhode {

// The kind of top, from the three principal moments.
struct TopKind {
  enum class Shape { spherical, prolate, oblate, asymmetric };
  Shape shape = Shape::asymmetric;
  int axis = 2;          // index (0..2 in P) of the symmetry axis; for prolate and oblate tops only
  bool planar = false;   // flat: the largest moment is the sum of the others; false for a rotator
  bool rotator = false;  // one moment is zero: all mass lies on a line

  bool symmetric() const { return shape == Shape::prolate || shape == Shape::oblate; }
  // "spherical", "symmetric prolate", "symmetric oblate" or "asymmetric", followed by " planar" or
  // " rotator" if that applies.
  std::string name() const;
};

// Moments that differ by at most this, relative to the largest, count as equal, and a moment of at
// most this as zero.
inline constexpr double kEqualMoments = 1e-12;
// The same where so small a difference moves the body: round-off of what moments come from.
inline constexpr double kSameMoments = 0x1p-48;

// Made by make_model(); a value that is not changed afterwards, so any thread may read it.
struct BodyModel {
  MassProperties body;                  // in B, tensor about the centre of mass
  bool on_pivot = false;                // one point of the body is fixed
  Vec3 pivot_B = Vec3::Zero();          // that point, m
  Vec3 gravity_S = Vec3::Zero();        // m/s^2
  Mat3 R_BP = Mat3::Identity();         // principal axes as columns, in B; ordered and signed to be
                                        // closest to the axes of B
  Vec3 moments = Vec3::Ones();          // about the reference point, kg m^2, along P
  Vec3 inverse_moments = Vec3::Ones();  // 1/moments, 1/(kg m^2); 0 for the zero moment of a rotator
  TopKind kind;
  double left_out = 0.0;          // what elements of the tensor differ by, at most, from those of a
                                  // body with moments that are equal, kg m^2; 0 if none count so
  double torque_left_out = 0.0;   // what lever arms that count as none turn it by, at most, N m
  double moments_off = 0.0;       // how far round-off may have moved each moment, kg m^2,
  double lever_off = 0.0;         // and the centre of mass from the point of reference, m
  Vec3 up_S = Vec3::UnitZ();      // unit vector against gravity; +Z without gravity
  Vec3 chi_P = Vec3::Zero();      // mass |g| (centre of mass - pivot), J; 0 for a free body
  Loads loads;                    // torques and forces besides gravity
  std::optional<Table> table;     // what the body moves on; absent: it is free or on a pivot
  bool with_translation = false;  // six degrees of freedom, not three; make_model() leaves it
                                  // unset, see with_needed_degrees() in motion/solution_method.h

  // The fixed point or, for a free body, the centre of mass; in B, m.
  const Vec3& reference_B() const { return on_pivot ? pivot_B : body.center; }
};

// The state that steppers advance. Place and linear momentum are used with six degrees of freedom
// only (BodyModel::with_translation), the rings with gimbals only (Loads::gimbals); what changes q
// or y there changes them too.
struct State {
  Quat q = Quat::Identity();    // attitude: rotates P to S
  Vec3 y = Vec3::Zero();        // angular momentum about the reference point, in P, kg m^2/s
  Vec3 place_S = Vec3::Zero();  // centre of mass, m
  Vec3 linear_momentum_S = Vec3::Zero();  // mass times velocity of the centre of mass, kg m/s
  GimbalPose rings = {};                  // q and y as angles and rates: near gimbal lock these do
                          // not follow from those but with round-off over sin(theta)
};

// Mass properties of a [body] table, in B. Throws Error (input) naming body.mass,
// body.center_of_mass or body.about if it is given without moments or tensor; body.moments or
// body.tensor for a tensor that is not symmetric or, about the pivot, too small; and as
// mass_properties (model/solids.h) does for body.solid and body.parts[i].
MassProperties mass_properties(const BodySpec& spec);

// The model of a body in the given gravity (in S, m/s^2). Throws Error (input) as mass_properties
// and make_loads do; naming the key that gives the mass distribution (body.moments, tensor, points,
// solid or parts) for a body without extent and for moments that no body can have (with
// BodySpec::mathematical they may break the triangle inequality); and naming motion.torque[i].KEY
// for a torque about the line of a rotator. `finely`: moments that differ by kSameMoments of the
// largest count as equal, not by kEqualMoments, and lever arms as none that are round-off, not by
// kNoArm (model/loads.h).
BodyModel make_model(const BodySpec& spec,
                     bool on_pivot,
                     const Vec3& gravity_S,
                     const std::vector<LoadSpec>& loads = {},
                     bool finely = false);

// The same body, if round-off has moved its moments by moments_off, and its centre of mass by
// lever_off along where it is. It keeps its kind.
BodyModel moved_by_rounding(BodyModel model);

// Checks the triangle inequality of the principal moments (kg m^2), which follows from I1 + I2 - I3
// = 2 sum m x3^2, in all three permutations and within 1e-9. Returns "" or the reason why no body
// has them.
std::string impossible_moments(const Vec3& moments);

// The kind of top that has these principal moments (kg m^2).
TopKind classify(const Vec3& moments, double equal = kEqualMoments);

// w_P = I^-1 y, rad/s.
inline Vec3 angular_velocity(const BodyModel& m, const Vec3& y) {
  return m.inverse_moments.cwiseProduct(y);
}

// Whether the body is symmetric and chi_P is along the symmetry axis or zero: gravity has no torque
// about that axis.
bool center_on_symmetry_axis(const BodyModel& model);

// The unit vector against gravity in P: gamma = q^-1 up_S.
inline Vec3 up_in_body(const BodyModel& m, const Quat& q) {
  return q.conjugate() * m.up_S;
}

// dy/dt = y x w + gamma x chi in P, N m: Euler's equations with gravity, without loads.
inline Vec3 momentum_rate(const BodyModel& m, const Vec3& y, const Vec3& gamma) {
  return y.cross(angular_velocity(m, y)) + gamma.cross(m.chi_P);
}

// dq/dt = q o (0, w) / 2, 1/s.
inline Quat attitude_rate(const Quat& q, const Vec3& w_P) {
  return Quat(0.5 * (q * Quat(0.0, w_P.x(), w_P.y(), w_P.z())).coeffs());
}

// Torque about the reference point in P at time t (s), N m: torque_of_loads() without gravity and
// gimbals, torque() with both.
Vec3 torque_of_loads(const BodyModel& m, double t, const State& s);
Vec3 torque(const BodyModel& m, double t, const State& s);

// The total force on a free body in S at time t (s), gravity included, N.
Vec3 force(const BodyModel& m, double t, const State& s);

// Kinetic energy of rotation about the reference point plus potential energy, J: y.w/2 + chi.gamma
// + potential_of() (model/loads.h) of the loads, + that of gimbal rings. With six degrees of
// freedom also the kinetic energy of the centre of mass and potential_of_place().
double energy(const BodyModel& m, const State& s);

// What the loads without a potential in energy() do at time t (s), with six degrees of freedom, W:
// where nothing else does work, the rate of energy().
double power_of_loads(const BodyModel& m, double t, const State& s);

// The angular velocity at which space turns, in S, rad/s; none if it does not.
std::optional<Vec3> frame_rotation_of(const BodyModel& m);

// Sets the rings of the gimbals, which must be there, and the attitude and momentum of the body
// that they carry. Of the two quaternions of that attitude the one that is nearer to s.q.
void set_rings(const BodyModel& m, const GimbalPose& rings, State& s);

// The part of energy() that is the motion of gimbal rings, J; 0 without them.
double kinetic_energy_of_gimbals(const BodyModel& m, const State& s);

// Potential energy of gravity and of forces that are constant in S (Loads::pushes; those that vary
// with time have none) for a free body with its centre of mass at center_S (m), J; 0 at the origin.
double potential_of_place(const BodyModel& m, const Vec3& center_S);

// Whether the motion conserves energy(), and angular momentum about the reference point (with a
// torque of gravity its vertical component).
bool keeps_energy(const BodyModel& m);
bool keeps_momentum(const BodyModel& m);

// Angular momentum about the reference point, in S, kg m^2/s.
inline Vec3 momentum_in_space(const State& s) {
  return s.q * s.y;
}

}  // namespace polhode
