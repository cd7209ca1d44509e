// SPDX-License-Identifier: MIT
// A complete motion: attitude and position of the body at any time. All pictures are made from it.
#pragma once

#include <memory>
#include <optional>

#include "motion/motion_spec.h"
#include "motion/trajectory.h"

namespace polhode {

// The quantities of one moment. Frames and letters: math/notation.h.
struct Sample {
  double t = 0.0;                            // s
  Quat q_SB = Quat::Identity();              // attitude, rotates B to S
  Vec3 w_B = Vec3::Zero();                   // angular velocity in body axes, rad/s
  Vec3 w_S = Vec3::Zero();                   // the same in space axes
  Vec3 L_S = Vec3::Zero();                   // angular momentum about the reference point, kg m^2/s
  Vec3 center_S = Vec3::Zero();              // centre of mass, m
  Vec3 reference_S = Vec3::Zero();           // fixed point (the origin) or centre of mass, m
  Vec3 reference_velocity_S = Vec3::Zero();  // of the reference point, m/s; zero on a pivot
  double energy = 0.0;                       // kinetic (rotation, translation) + potential (gravity
                                             // and loads), J; the potential of gravity and of
                                             // constant forces is 0 at the origin of S
};

// Immutable; at() may be called from any thread.
class Motion {
 public:
  // The trajectory (never null) gives the rotation, and with six degrees of freedom
  // (BodyModel::with_translation) the path; position, velocity and duration come from `spec`.
  // `model` is that of the trajectory.
  Motion(const BodyModel& model,
         std::shared_ptr<const Trajectory> trajectory,
         const MotionSpec& spec);

  // The quantities at t (s), 0 <= t <= duration(). Throws Error (check_failed) as Trajectory::at
  // does.
  Sample at(double t) const;
  // The state of the rotation at that time; its place and linear momentum are those of the motion
  // with six degrees of freedom only. Throws Error likewise.
  State state_at(double t) const { return trajectory_->at(t); }
  // How the body touches the table at that time, if there is one. Throws Error likewise.
  std::optional<ContactState> contact_at(double t) const { return trajectory_->contact_at(t); }
  // A reference to a member.
  const BodyModel& model() const { return model_; }
  // In seconds; the motion begins at t = 0.
  double duration() const { return duration_; }
  // The same motion until `end` (s) at the latest.
  Motion until(double end) const;

 private:
  BodyModel model_;
  std::shared_ptr<const Trajectory> trajectory_;
  Quat q_PB_;
  Vec3 position_;  // of the centre of mass at t = 0, in S, m; free bodies only
  Vec3 velocity_;  // m/s
  double duration_;
};

// The drift of the conserved quantities between the start and t (s), 0 <= t <= duration(), as
// DriftWatch::of() gives it. Throws Error (check_failed) as Motion::at does.
Drift drift_at(const Motion& motion, double t);

// What the table does to the body at t (s), 0 <= t <= duration(); absent without a table or
// contact. Throws Error (check_failed) as Motion::at does.
std::optional<Reaction> reaction_at(const Motion& motion, double t);

// The torque about the reference point, S, N m: of gravity, of loads, and of what a table does.
// Null on a table where the method does not tell what touches. Throws Error (check_failed) as
// reaction_of() does.
std::optional<Vec3> torque_at(const Motion& motion, double t);

// Position in S (m) of the point r_B of the body (m, from the body origin).
Vec3 point_position(const BodyModel& model, const Sample& sample, const Vec3& r_B);

// Velocity in S (m/s) of the point r_B of the body (m, from the body origin): V + Omega x r, with V
// the velocity of the reference point and r the position from there (lecture notes, eq. 2; see
// docs/theory.md).
Vec3 point_velocity(const BodyModel& model, const Sample& sample, const Vec3& r_B);

// The model of a body with the pivot, gravity and loads of a [motion] table. Moments that nearly
// agree count as equal if that turns the body by less than 1e-10 rad in this motion. Throws Error
// (input) as make_model in model/body_model.h does.
BodyModel make_model(const BodySpec& body, const MotionSpec& motion);

// Gravity of a [motion] table in S, m/s^2. The default is zero for a free body and standard gravity
// on a pivot.
Vec3 gravity_of(const MotionSpec& spec);

// The state at t = 0, with place and linear momentum; `times_spin`: a factor on the spin, which
// rings and, on a table, the velocity follow. Throws Error (input), naming motion.spin or a
// key in it, for a rotator that spins about its own axis, for steady precession or a sleeping top
// that this body cannot have, and for an axial spin without them; naming
// motion.attitude.momentum_up without a spin in body axes; naming motion.position or
// motion.velocity if it is not zero for a body on a pivot.
State start_state(const BodyModel& model, const MotionSpec& spec, double times_spin = 1.0);

}  // namespace polhode
