// SPDX-License-Identifier: MIT
// A whole motion: rotation and place of the body at any time. What every picture is made from.
#pragma once

#include <memory>

#include "motion/motion_spec.h"
#include "motion/trajectory.h"

namespace polhode {

// All quantities of one moment. Letters of frames: math/notation.h.
struct Sample {
  double t = 0.0;                            // s
  Quat q_SB = Quat::Identity();              // attitude, body to space
  Vec3 w_B = Vec3::Zero();                   // angular velocity in body axes, rad/s
  Vec3 w_S = Vec3::Zero();                   // the same in space axes
  Vec3 L_S = Vec3::Zero();                   // angular momentum about the reference point, kg m^2/s
  Vec3 center_S = Vec3::Zero();              // centre of mass, m
  Vec3 reference_S = Vec3::Zero();           // fixed point or centre of mass, m
  Vec3 reference_velocity_S = Vec3::Zero();  // of that point, m/s; zero on a pivot
  double energy = 0.0;                       // kinetic (rotation and translation) + potential, J
};

// Immutable; at() may be called from any thread.
class Motion {
 public:
  Motion(const BodyModel& model,
         std::shared_ptr<const Trajectory> trajectory,
         const MotionSpec& spec);

  Sample at(double t) const;
  // The same moment as the trajectory knows it.
  State state_at(double t) const { return trajectory_->at(t); }
  const BodyModel& model() const { return model_; }
  double duration() const { return duration_; }

 private:
  BodyModel model_;
  std::shared_ptr<const Trajectory> trajectory_;
  Quat q_PB_;
  Vec3 position_;  // of the centre of mass at t = 0, free bodies, m
  Vec3 velocity_;  // m/s
  double duration_;
};

// How far the invariants are off at t (s) from where they began.
Drift drift_at(const Motion& motion, double t);

// Where the point r_B of the body (m, from the body origin) is in space, m.
Vec3 point_position(const BodyModel& model, const Sample& sample, const Vec3& r_B);

// Its velocity in space, m/s: V + Omega x r, r from the reference point (notes, section 0.1).
Vec3 point_velocity(const BodyModel& model, const Sample& sample, const Vec3& r_B);

// The model of a body held and loaded as a [motion] table says. Throws Error (input) as the other
// make_model does.
BodyModel make_model(const BodySpec& body, const MotionSpec& motion);

// Gravity of a [motion] table, defaults resolved: none for a free body, standard on a pivot.
Vec3 gravity_of(const MotionSpec& spec);

// Attitude and momentum at t = 0. Throws Error (input): a rotator spun about its own axis.
State start_state(const BodyModel& model, const MotionSpec& spec);

}  // namespace polhode
