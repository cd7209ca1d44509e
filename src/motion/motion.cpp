// SPDX-License-Identifier: MIT
#include "motion/motion.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "math/so3.h"
#include "motion/scales.h"

namespace polhode {
namespace {

constexpr double kStandardGravity = 9.80665;  // m/s^2, the defined standard value

// a ring has mass, and all of it at distances from its axes
void check_inner_ring(const Vec3& moments) {
  constexpr double kRoundOff = 1e-9;  // the largest moment of a flat ring is the sum of the others
  if (2.0 * moments.maxCoeff() <= moments.sum() * (1.0 + kRoundOff)) return;
  throw input_error(
      "no ring has these moments: the largest, {}, is greater than the sum of the other two",
      moments.maxCoeff())
      .at({{}, 0, "motion.gimbals.inner"});
}

Gimbals make_gimbals(const GimbalsSpec& spec, const BodyModel& model, const Vec3& frame) {
  Gimbals gimbals;
  // for a body whose axle is z under gravity along -Z, the zxz angles of the scene
  const Vec3 axle_B =
      model.kind.symmetric() ? Vec3(model.R_BP.col(model.kind.axis)) : Vec3(Vec3::UnitZ());
  gimbals.axes_P = model.R_BP.transpose() * turn_between(Vec3::UnitZ(), axle_B).toRotationMatrix();
  gimbals.axes_S = turn_between(Vec3::UnitZ(), model.up_S).toRotationMatrix();
  gimbals.outer = spec.outer;
  gimbals.inner = spec.inner;
  gimbals.friction = spec.friction;
  if (spec.clamp) {
    gimbals.clamp = *spec.clamp == "outer" ? Gimbals::Clamp::outer : Gimbals::Clamp::inner;
  }
  gimbals.frame_S = frame;
  return gimbals;
}

void put_on_table(const BodySpec& body, const MotionSpec& motion, BodyModel& model) {
  if (!(model.gravity_S.z() < 0.0)) {
    throw input_error("must point down, to the table z = 0: its z must be negative")
        .at({{}, 0, "motion.gravity"});
  }
  if (!model.loads.switches.empty()) {
    throw input_error(
        "loads that are switched are not for a body on a table; leave out from, "
        "until and ramp")
        .at({{}, 0, "motion.torque"});
  }
  if (model.kind.rotator) {
    throw input_error(
        "a body with all its mass on a line has no place on a table: it cannot take "
        "up a torque about that line; give it a width")
        .at({{}, 0, "motion.hold"});
  }
  Table table;
  table.surface = make_contact_surface(body, model.body, model.R_BP);
  FrictionSpec none;
  none.kind = "none";
  table.friction = make_friction(motion.friction.value_or(none));
  model.table = table;
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

Motion Motion::until(double end) const {
  Motion part = *this;
  part.duration_ = std::min(duration_, end);
  return part;
}

Drift drift_at(const Motion& motion, double t) {
  return DriftWatch(motion.model(), motion.state_at(0.0))
      .of(motion.state_at(t), motion.contact_at(t).value_or(ContactState{}));
}

std::optional<Reaction> reaction_at(const Motion& motion, double t) {
  const std::optional<ContactState> contact = motion.contact_at(t);
  if (!contact || contact->touch.phase == Touch::Phase::flying) return {};
  const BodyModel& model = motion.model();
  Reaction found = reaction_of(model, contact->touch, t, moving_of(model, motion.state_at(t)));
  if (contact->touch.phase == Touch::Phase::lying)
    found.normal = -model.body.mass * model.gravity_S.z();
  // what friction holds does not slip but for rounding errors
  const Friction::Kind kind = model.table->friction.kind;
  if (kind == Friction::Kind::rolling || (kind == Friction::Kind::coulomb && contact->touch.sticks))
    found.slip_S.setZero();
  return found;
}

std::optional<Vec3> torque_at(const Motion& motion, double t) {
  const BodyModel& model = motion.model();
  const State state = motion.state_at(t);
  if (!model.table) return Vec3(state.q * torque(model, t, state));
  const std::optional<ContactState> contact = motion.contact_at(t);
  if (!contact) return {};
  const Reaction found = reaction_of(model, contact->touch, t, moving_of(model, state));
  return Vec3(state.q * (found.momentum_rate_P + angular_velocity(model, state.y).cross(state.y)));
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
  return spec.hold == "free" ? Vec3(Vec3::Zero()) : Vec3(0, 0, -kStandardGravity);
}

namespace {

// `finely`: see make_model() in model/body_model.h
BodyModel model_of(const BodySpec& body, const MotionSpec& motion, bool finely) {
  BodyModel model =
      make_model(body, motion.hold == "pivot", gravity_of(motion), motion.torque, finely);
  const auto refuse_free = [&](const char* key) {
    if (model.on_pivot) return;
    throw input_error("is for a body on a pivot; set motion.hold = \"pivot\"").at({{}, 0, key});
  };
  const Vec3 frame = motion.frame_rotation.value_or(Vec3::Zero());
  if (motion.frame_rotation) refuse_free("motion.frame_rotation");
  if (frame != Vec3::Zero()) {
    Load turning;
    turning.kind = Load::Kind::frame;
    turning.vector = frame;
    turning.moments = model.moments;
    model.loads.turning.push_back(turning);
  }
  if (motion.gimbals) {
    refuse_free("motion.gimbals");
    if (model.kind.rotator) {
      throw input_error(
          "the axle would be the line on which all mass lies, and nothing tells how it turns; give "
          "the body a thickness")
          .at({{}, 0, "motion.gimbals"});
    }
    check_inner_ring(motion.gimbals->inner);
    const Gimbals gimbals = make_gimbals(*motion.gimbals, model, frame);
    if (!gimbals.idle()) model.loads.gimbals = gimbals;
  }
  if (motion.hold == "table") {
    put_on_table(body, motion, model);
  } else if (motion.friction) {
    throw input_error(
        "is for a body on a table; set motion.hold = \"table\", or use motion.torque = [{{ kind = "
        "\"damping\", c = ... }}] for friction of a pivot or of air")
        .at({{}, 0, "motion.friction"});
  }
  return model;
}

}  // namespace

BodyModel make_model(const BodySpec& body, const MotionSpec& motion) {
  constexpr double kUnseen = 1e-10;  // rad
  BodyModel model = model_of(body, motion, false);
  if (model.left_out == 0.0 && model.torque_left_out == 0.0) return model;
  try {
    const State start = start_state(model, motion);
    const double turn = turn_left_out(model, start, motion.duration, false) +
                        turn_by_arms_left_out(model, start, motion.duration);
    if (turn <= kUnseen) return model;
  } catch (const Error&) {
    return model;  // a start that cannot be is told where it is asked for
  }
  return model_of(body, motion, true);
}

}  // namespace polhode
