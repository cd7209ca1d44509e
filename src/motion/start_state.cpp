// SPDX-License-Identifier: MIT
#include <cmath>

#include "base/error.h"
#include "math/so3.h"
#include "motion/motion.h"

namespace polhode {
namespace {

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

// On a table, height and velocity follow from attitude and spin, unless the body begins above it.
void put_on_table(const BodyModel& model, const MotionSpec& spec, State& start) {
  if (!model.table) return;
  const Vec3 down_P = down_in_body(start.q);
  const ContactSurface& surface = *model.table->surface;
  Touch touch;
  touch.piece = surface.lowest(down_P);
  const double height = surface.height(down_P, touch.piece);
  constexpr double kAbove = 1e-9;  // of the reach: nearer it is on the table
  if (spec.position.z() > height + kAbove * surface.reach()) return;
  if (surface.tilt_of_face(down_P, touch.piece) < 1e-9 ||
      surface.clearance(down_P, touch.piece) < 1e-9 * surface.reach()) {
    throw input_error(
        "puts more than one point of the body on the table (a face or an edge); tilt it")
        .at({{}, 0, "motion.attitude"});
  }
  const bool rolls = model.table->friction.kind == Friction::Kind::rolling;
  if (spec.velocity.z() != 0.0 || (rolls && spec.velocity != Vec3::Zero())) {
    throw input_error("{} follows from the spin for a body that is on the table{}; leave it out",
                      rolls ? "the velocity" : "the vertical velocity",
                      rolls ? " and rolls" : "")
        .at({{}, 0, "motion.velocity"});
  }
  // on the table, and not held otherwise: that is found when it is known what holds it
  touch.sticks = touch.keeps_from_boring = touch.keeps_from_rolling = false;
  Moving now{start.q, start.y, start.place_S, spec.velocity};
  hold_to_table(model, touch, now);
  start.place_S = now.place_S;
  start.linear_momentum_S = model.body.mass * now.velocity_S;
}

// A symmetric top under gravity on a pivot, as steady precession is defined for.
struct LagrangeTop {
  Vec3 axis_P;          // from the pivot to the centre of mass, unit
  double across = 0.0;  // moment about a line across the axis through the pivot, kg m^2
  double along = 0.0;   // about the axis
  double mgl = 0.0;     // weight times distance of the centre of mass, N m
};

LagrangeTop lagrange_top(const BodyModel& model, const char* key) {
  const double mgl = model.chi_P.norm();
  const bool spherical = model.kind.shape == TopKind::Shape::spherical;
  const int axis = spherical ? 0 : model.kind.axis;
  if (!model.on_pivot || !(mgl > 0.0) || !(spherical || center_on_symmetry_axis(model))) {
    throw input_error(
        "is for a symmetric top on a pivot under gravity, with its centre of mass on its axis")
        .at({{}, 0, key});
  }
  return {model.chi_P / mgl, model.moments[(axis + 1) % 3], model.moments[axis], mgl};
}

// The angular velocity of steady precession at the tilt of `q` (Goldstein, Classical Mechanics,
// section 5.7: I cos(theta) w^2 - L3 w + m g l = 0).
Vec3 steady_rotation_P(const BodyModel& model, const SpinSpec& spin, const Quat& q) {
  const LagrangeTop top = lagrange_top(model, "motion.spin.steady");
  if (frame_rotation_of(model)) {
    throw input_error("is for a top in a space that does not turn; give spin.rates")
        .at({{}, 0, "motion.spin.steady"});
  }
  if (!spin.axial) {
    throw input_error("needs axial = rate, the angular velocity about the top's own axis")
        .at({{}, 0, "motion.spin.steady"});
  }
  const Vec3 up_P = up_in_body(model, q);
  const double rounded = up_P.dot(top.axis_P);
  const double level = std::abs(rounded) < 1e-12 ? 0.0 : rounded;
  const double L3 = top.along * *spin.axial;
  const double under_root = L3 * L3 - 4.0 * top.across * top.mgl * level;
  if (L3 == 0.0 && level == 0.0) {
    throw input_error("must not be 0: a level axis without spin falls")
        .at({{}, 0, "motion.spin.axial"});
  }
  if (under_root < 0.0) {
    // rounded up, so that what is printed is enough
    const double least = 2.0 * std::sqrt(top.across * top.mgl * std::max(level, 0.0)) / top.along;
    throw input_error("at this tilt no precession is steady below {:.6g} rad/s",
                      least * (1.0 + 1e-5))
        .at({{}, 0, "motion.spin.axial"});
  }
  // as a quotient nothing cancels
  const double sum = L3 + std::copysign(std::sqrt(under_root), L3);
  double precession = 2.0 * top.mgl / sum;
  if (*spin.steady == "fast") {
    if (level == 0.0) {
      throw input_error("a level axis has no fast steady precession; use \"slow\"")
          .at({{}, 0, "motion.spin.steady"});
    }
    precession = sum / (2.0 * top.across * level);
  }
  return precession * up_P + (*spin.axial - precession * level) * top.axis_P;
}

// the rotation of a top that stands upright
Vec3 sleeping_rotation_P(const BodyModel& model, double rate, const Quat& q) {
  const LagrangeTop top = lagrange_top(model, "motion.spin.sleeping");
  if (up_in_body(model, q).dot(top.axis_P) < 1.0 - 1e-12) {
    throw input_error(
        "a sleeping top stands upright, and this one's centre of mass is not above the pivot; turn "
        "it there with motion.attitude, or give another spin")
        .at({{}, 0, "motion.spin.sleeping"});
  }
  return rate * top.axis_P;
}

// the rotation that takes the momentum, which the spin gives in body axes, upwards
Quat momentum_up_SB(const BodyModel& model, const AttitudeSpec& attitude, const SpinSpec& spin) {
  const auto refuse = [](const char* why) {
    throw input_error("{}", why).at({{}, 0, "motion.attitude.momentum_up"});
  };
  if (!*attitude.momentum_up) refuse("must be true, or be left out");
  if (!spin.body && !spin.momentum_body)
    refuse("needs a spin in body axes: motion.spin = { body = ... } or { momentum_body = ... }");
  const Mat3 R_PB = model.R_BP.transpose();
  const Vec3 L_B = spin.momentum_body
                       ? *spin.momentum_body
                       : Vec3(model.R_BP * model.moments.cwiseProduct(R_PB * *spin.body));
  if (!(L_B.norm() > 0.0)) refuse("a body at rest has no angular momentum");
  return turn_between(L_B, Vec3::UnitZ());
}

Quat start_attitude_SB(const BodyModel& model, const MotionSpec& motion) {
  const AttitudeSpec& spec = motion.attitude;
  if (spec.zxz) return from_zxz_angles(*spec.zxz);
  if (spec.tilt) return from_zxz_angles(Vec3(0.0, *spec.tilt, 0.0));
  if (spec.momentum_up) return momentum_up_SB(model, spec, motion.spin);
  if (spec.quaternion) {
    const Eigen::Vector4d& q = *spec.quaternion;
    const Eigen::Vector4d unit = q.stableNormalized();
    return Quat(unit[0], unit[1], unit[2], unit[3]);
  }
  return Quat::Identity();
}

// of the zxz angles at the start
Vec3 start_angles(const AttitudeSpec& spec, const Quat& q_SB) {
  if (spec.tilt) return {0.0, *spec.tilt, 0.0};
  return spec.zxz.value_or(zxz_angles(q_SB));
}

// Whether the zxz angles of a scene are those of its gimbals: not if the axle is not the z axis of
// the body, or gravity is not along -Z.
bool have_angles_of_scene(const Gimbals& gimbals, const BodyModel& model) {
  constexpr double kRounding = 1e-12;
  return gimbals.axes_S.isIdentity(kRounding) &&
         (model.R_BP * gimbals.axes_P).isIdentity(kRounding);
}

// Rings without mass cannot turn a body about two axes that coincide.
void refuse_massless_lock(const BodyModel& model) {
  const Gimbals& gimbals = *model.loads.gimbals;
  if (gimbals.outer + gimbals.inner.z() > 0.0 || gimbals.clamp == Gimbals::Clamp::outer) return;
  throw input_error(
      "the axle is along the axis of the outer ring (gimbal lock), where rings without mass have "
      "no motion; give motion.gimbals.outer, or tilt the axle by more than 0.001 rad")
      .at({{}, 0, "motion.attitude"});
}

// Sets where the rings are and how they turn, and refuses what the gimbals cannot begin with.
void set_start_of_rings(const BodyModel& model, const MotionSpec& spec, State& start) {
  if (!model.loads.gimbals) return;
  if (spec.spin.steady || spec.spin.sleeping) {
    throw input_error("is for a top without motion.gimbals; give spin.rates")
        .at({{}, 0, spec.spin.steady ? "motion.spin.steady" : "motion.spin.sleeping"});
  }
  const Gimbals& gimbals = *model.loads.gimbals;
  const Vec3 axle_S = start.q * gimbals.axes_P.col(2);
  const Vec3 up_S = gimbals.axes_S.col(2);
  constexpr double kLeastTilt = 1e-3;  // rad
  const bool locked = up_S.cross(axle_S).norm() < kLeastTilt;
  if (locked) refuse_massless_lock(model);
  const bool as_given = have_angles_of_scene(gimbals, model);
  GimbalPose& rings = start.rings;
  if (as_given && spec.spin.rates && spec.attitude.zxz) {
    rings = {*spec.attitude.zxz, *spec.spin.rates};
  } else if (locked) {
    throw input_error(
        "the axle is along the axis of the outer ring (gimbal lock), so that this does not say "
        "where the rings are; {}tilt the axle by more than 0.001 rad",
        as_given ? "give attitude.zxz and spin.rates, or " : "")
        .at({{}, 0, "motion.attitude"});
  } else {
    const double phi = spec.attitude.zxz ? (*spec.attitude.zxz)[0] : 0.0;
    rings = pose_of(gimbals, start.q, angular_velocity(model, start.y), phi);
  }
  const double kept = gimbals.clamp == Gimbals::Clamp::inner   ? rings.rates[1]
                      : gimbals.clamp == Gimbals::Clamp::outer ? rings.rates[0]
                                                               : 0.0;
  if (std::abs(kept) > 1e-9 * rings.rates.norm()) {
    throw input_error("turns the {} ring at {:.6g} rad/s, which motion.gimbals.clamp holds",
                      *spec.gimbals->clamp,
                      kept)
        .at({{}, 0, "motion.spin"});
  }
}

// the angular momentum in P that the scene gives, or that its angular velocity has
Vec3 start_momentum_P(const BodyModel& model,
                      const MotionSpec& spec,
                      const Quat& q_SB,
                      const Quat& q_SP) {
  const Mat3 R_PB = model.R_BP.transpose();
  if (spec.spin.momentum_body) {
    Vec3 y = R_PB * *spec.spin.momentum_body;
    refuse_spin_about_line(model, y);
    return y;
  }
  Vec3 w_B = Vec3::Zero();
  if (spec.spin.body) w_B = *spec.spin.body;
  if (spec.spin.space) w_B = q_SB.conjugate() * *spec.spin.space;
  if (spec.spin.rates) {
    w_B = body_rate_from_zxz_rates(start_angles(spec.attitude, q_SB), *spec.spin.rates);
  }
  Vec3 w_P = R_PB * w_B;
  if (spec.spin.steady) w_P = steady_rotation_P(model, spec.spin, q_SP);
  if (spec.spin.sleeping) w_P = sleeping_rotation_P(model, *spec.spin.sleeping, q_SP);
  if (spec.spin.axial && !spec.spin.steady)
    throw input_error("is for steady = \"slow\" or \"fast\"").at({{}, 0, "motion.spin.axial"});
  refuse_spin_about_line(model, w_P);
  return model.moments.cwiseProduct(w_P);
}

}  // namespace

State start_state(const BodyModel& model, const MotionSpec& spec, double times_spin) {
  refuse_flight_on_pivot(model, spec);
  const Quat q_SB = start_attitude_SB(model, spec);
  State start;
  start.q = q_SB * Quat(model.R_BP);
  start.y = start_momentum_P(model, spec, q_SB, start.q);
  start.place_S = spec.position;
  start.linear_momentum_S = model.body.mass * spec.velocity;
  set_start_of_rings(model, spec, start);
  start.y *= times_spin;
  start.rings.rates *= times_spin;
  put_on_table(model, spec, start);
  return start;
}

}  // namespace polhode
