// SPDX-License-Identifier: MIT
#include "motion/motion.h"

#include <utility>

#include "base/error.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr double kStandardGravity = 9.80665;  // m/s^2, the defined standard value

Quat start_attitude_SB(const AttitudeSpec& spec) {
  if (spec.zxz) return from_zxz_angles(*spec.zxz);
  if (spec.quaternion) {
    const Eigen::Vector4d& q = *spec.quaternion;
    const Eigen::Vector4d unit = q.stableNormalized();
    return Quat(unit[0], unit[1], unit[2], unit[3]);
  }
  return Quat::Identity();
}

// a rotator has no momentum along its line of mass, so a spin about it means nothing
void refuse_spin_about_line(const BodyModel& model, const Vec3& vector_P) {
  for (int i = 0; i < 3; ++i) {
    if (model.moments[i] > 0.0 || std::abs(vector_P[i]) <= 1e-12 * vector_P.norm()) continue;
    throw input_error(
        "all mass lies on a line (one moment is less than 1e-12 of the largest): a spin about "
        "that line has no meaning; leave out the component along it")
        .at({{}, 0, "motion.spin"});
  }
}

// the fixed point is the origin of space and stays there
void refuse_flight_on_pivot(const BodyModel& model, const MotionSpec& spec) {
  if (!model.on_pivot) return;
  const auto refuse = [](const Vec3& value, const char* key) {
    if (value == Vec3::Zero()) return;
    throw input_error("is for free bodies; this one turns about a fixed point at the origin")
        .at({{}, 0, key});
  };
  refuse(spec.position, "motion.position");
  refuse(spec.velocity, "motion.velocity");
}

}  // namespace

Motion::Motion(const BodyModel& model,
               std::shared_ptr<const Trajectory> trajectory,
               const MotionSpec& spec)
    : model_(model),
      trajectory_(std::move(trajectory)),
      q_PB_(Quat(model.R_BP).conjugate()),
      position_(spec.position),
      velocity_(spec.velocity),
      duration_(spec.duration) {}

Sample Motion::at(double t) const {
  const State s = trajectory_->at(t);
  const Vec3 w_P = angular_velocity(model_, s.y);
  Sample sample;
  sample.t = t;
  sample.q_SB = s.q * q_PB_;
  sample.w_B = model_.R_BP * w_P;
  sample.w_S = s.q * w_P;
  sample.L_S = momentum_in_space(s);
  sample.energy = energy(model_, s);
  if (model_.on_pivot) {
    // the fixed point is the origin of space
    sample.center_S = sample.q_SB * (model_.body.center - model_.pivot_B);
    return sample;
  }

  // six degrees of freedom have been integrated, energy and all; else the centre of mass of a free
  // body goes by gravity and forces fixed in space, on a parabola or what they make of it
  const double mass = model_.body.mass;
  if (model_.with_translation) {
    sample.center_S = s.place_S;
    sample.reference_velocity_S = s.linear_momentum_S / mass;
  } else {
    Vec3 velocity = velocity_ + t * model_.gravity_S;
    sample.center_S = position_ + t * velocity_ + 0.5 * t * t * model_.gravity_S;
    for (const Push& push : model_.loads.pushes) {
      sample.center_S += way_of(push, t) / mass;
      velocity += speed_of(push, t) / mass;
    }
    sample.reference_velocity_S = velocity;
    sample.energy += 0.5 * mass * velocity.squaredNorm();
    sample.energy += potential_of_place(model_, sample.center_S);
  }
  sample.reference_S = sample.center_S;
  return sample;
}

Drift drift_at(const Motion& motion, double t) {
  return DriftWatch(motion.model(), motion.state_at(0.0)).of(motion.state_at(t));
}

Vec3 point_position(const BodyModel& model, const Sample& sample, const Vec3& r_B) {
  return sample.reference_S + sample.q_SB * (r_B - model.reference_B());
}

Vec3 point_velocity(const BodyModel& model, const Sample& sample, const Vec3& r_B) {
  return sample.reference_velocity_S +
         sample.w_S.cross(point_position(model, sample, r_B) - sample.reference_S);
}

Vec3 gravity_of(const MotionSpec& spec) {
  if (spec.gravity) return *spec.gravity;
  return spec.hold == "pivot" ? Vec3(0, 0, -kStandardGravity) : Vec3(Vec3::Zero());
}

BodyModel make_model(const BodySpec& body, const MotionSpec& motion) {
  return make_model(body, motion.hold == "pivot", gravity_of(motion), motion.torque);
}

State start_state(const BodyModel& model, const MotionSpec& spec) {
  refuse_flight_on_pivot(model, spec);
  const Quat q_SB = start_attitude_SB(spec.attitude);
  const Mat3 R_PB = model.R_BP.transpose();
  State start;
  start.q = q_SB * Quat(model.R_BP);
  start.place_S = spec.position;
  start.linear_momentum_S = model.body.mass * spec.velocity;
  if (spec.spin.momentum_body) {
    start.y = R_PB * *spec.spin.momentum_body;
    refuse_spin_about_line(model, start.y);
    return start;
  }

  Vec3 w_B = Vec3::Zero();
  if (spec.spin.body) w_B = *spec.spin.body;
  if (spec.spin.space) w_B = q_SB.conjugate() * *spec.spin.space;
  if (spec.spin.rates) {
    const Vec3 angles = spec.attitude.zxz.value_or(zxz_angles(q_SB));
    w_B = body_rate_from_zxz_rates(angles, *spec.spin.rates);
  }
  const Vec3 w_P = R_PB * w_B;
  refuse_spin_about_line(model, w_P);
  start.y = model.moments.cwiseProduct(w_P);
  return start;
}

}  // namespace polhode
