// SPDX-License-Identifier: MIT
// A body on a table, the plane z = 0 of space: how it touches, and the forces that follow from
// that. docs/theory.md, "Bodies on a table".
#pragma once

#include "model/body_model.h"

namespace polhode {

// How the body touches the table. Between events it stays the same; where a law has a direction
// that its velocity gives, the reference directions say how the law goes on beyond a zero of that
// velocity, so that the zero is an ordinary root (motion/contact/).
struct Touch {
  enum class Phase { flying, touching, lying };  // lying: at rest for good, on a face
  Phase phase = Phase::touching;
  int piece = 0;                   // of the surface
  bool sticks = true;              // the contact does not slip
  bool keeps_from_rolling = true;  // the horizontal part of the angular velocity stays zero
  bool keeps_from_boring = true;   // that about the vertical stays that of the table
  Vec3 slip_S = Vec3::Zero();      // direction of slip, where it is or begins, unit
  Vec3 roll_S = Vec3::Zero();      // likewise of the horizontal part of the angular velocity
  // Speed of slip, m/s, below which its direction is that in which it grows or falls by itself.
  // Near zero it turns there at once, far faster than anything else moves.
  double creep = 0.0;
  double roll_creep = 0.0;  // likewise of the horizontal part of the angular velocity, rad/s
  double bore = 1.0;        // likewise the sign of that about the vertical
};

// The motion of a body on a table: attitude (P to S), angular momentum (P), centre of mass and its
// velocity (S).
struct Moving {
  Quat q = Quat::Identity();
  Vec3 y = Vec3::Zero();           // kg m^2/s
  Vec3 place_S = Vec3::Zero();     // m
  Vec3 velocity_S = Vec3::Zero();  // m/s
};

// The part of a vector of S along the table.
inline Vec3 horizontal(const Vec3& v_S) {
  return {v_S.x(), v_S.y(), 0.0};
}

// The motion that a state holds, and the state of a motion.
Moving moving_of(const BodyModel& model, const State& state);
State state_of(const BodyModel& model, const Moving& now);

// What the table does to the body, and the accelerations that follow.
struct Reaction {
  SurfacePoint point;              // where it touches
  double normal = 0.0;             // N; negative: the body would have to be held down
  Vec3 friction_S = Vec3::Zero();  // horizontal, N
  Vec3 moment_S = Vec3::Zero();    // against rolling and boring, N m
  Vec3 slip_S = Vec3::Zero();      // velocity of the body's lowest point against the table, m/s
  Vec3 slip_direction_S = Vec3::Zero();  // against which dry friction acts, unit; where it slips
  Vec3 roll_direction_S = Vec3::Zero();  // against which the moment against rolling acts, likewise
  Vec3 slip_rate_S = Vec3::Zero();      // rate of the slip, m/s^2; in flight with the vertical part
  Vec3 momentum_rate_P = Vec3::Zero();  // dy/dt, N m
  Vec3 acceleration_S = Vec3::Zero();   // of the centre of mass, m/s^2
  // what normal force, friction, moments and the loads without a potential do to the body, W
  double power = 0.0;
};

// Throws Error (check_failed) if no normal force solves the equations (Painleve's paradox: friction
// jams the body). t in s. In flight and lying the table exerts nothing, and lying nothing
// accelerates.
Reaction reaction_of(const BodyModel& model, const Touch& touch, double t, const Moving& now);

// The velocity of the body's lowest point against the table, S, m/s; its vertical part is that of
// the gap.
Vec3 slip_of(const BodyModel& model, const Touch& touch, const Moving& now);

// The height of the lowest point above the table, m: of the piece that touches, or of all.
double gap_of(const BodyModel& model, const Touch& touch, const Moving& now);
double gap_of(const BodyModel& model, const Moving& now);
// Whether there is no such gap, but for rounding.
bool is_on_table(const BodyModel& model, const Moving& now);

// A motion as forces see it.
struct Posed {
  Mat3 R_SP = Mat3::Identity();
  Vec3 up_P = Vec3::UnitZ();
  Vec3 w_P = Vec3::Zero();  // rad/s
  SurfacePoint point;
};
Posed posed(const BodyModel& model, const Touch& touch, const Moving& now);
// reaction_of() and hold_to_table() of a motion that is posed: in the loops of integration.
Reaction reaction_of(
    const BodyModel& model, const Touch& touch, double t, const Moving& now, const Posed& pose);
void hold_to_table(const BodyModel& model, const Touch& touch, Posed& pose, Moving& now);

// Sets what the contact determines: height and vertical velocity from the attitude, the rest of the
// velocity too where it sticks, and no angular velocity that is kept at zero.
void hold_to_table(const BodyModel& model, const Touch& touch, Moving& now);

// Kinetic plus potential energy, J.
double energy_of(const BodyModel& model, const Moving& now);

}  // namespace polhode
