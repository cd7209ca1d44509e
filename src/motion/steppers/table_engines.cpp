// SPDX-License-Identifier: MIT
// Steps with which game engines and simple simulations hold a body on a table, without events: kept
// to show what each does to a top. All move first the velocities, then the body by the new ones
// (semi-implicit Euler), with the torque-free rotation at constant momentum in space.
#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "math/so3.h"
#include "model/table.h"
#include "motion/steppers/all.h"
#include "motion/steppers/turn.h"

namespace polhode {
namespace {

constexpr double kEngineRolls = 1.0;  // the coefficient of dry friction that stands for rolling

// A body in space between two parts of a step.
struct FreeFlight {
  Mat3 R_SP;
  Vec3 L_S;         // kg m^2/s
  Vec3 velocity_S;  // m/s
  Vec3 w_S;         // rad/s
  Mat3 inverse_S;   // of the inertia, 1/(kg m^2)

  FreeFlight(const BodyModel& m, const State& s)
      : R_SP(s.q.toRotationMatrix()),
        L_S(R_SP * s.y),
        velocity_S(s.linear_momentum_S / m.body.mass),
        inverse_S(R_SP * m.inverse_moments.asDiagonal() * R_SP.transpose()) {
    w_S = inverse_S * L_S;
  }
  void push(const BodyModel& m, const Vec3& arm_S, const Vec3& impulse_S) {
    velocity_S += impulse_S / m.body.mass;
    turn(arm_S.cross(impulse_S));
  }
  void turn(const Vec3& angular_impulse_S) {
    L_S += angular_impulse_S;
    w_S = inverse_S * L_S;
  }
  Vec3 velocity_at(const Vec3& arm_S) const { return velocity_S + w_S.cross(arm_S); }
  // of a point, per impulse there, 1/kg
  Mat3 mobility(const BodyModel& m, const Vec3& arm_S) const {
    const Mat3 r = hat(arm_S);
    return Mat3::Identity() / m.body.mass - r * inverse_S * r;
  }
};

// The lowest point.
struct LowestPoint {
  Vec3 arm_S = Vec3::Zero();  // from the centre of mass, m
  double gap = 0.0;           // above the table, m
};

LowestPoint lowest_of(const BodyModel& m, const State& s) {
  const Mat3 R_SP = s.q.toRotationMatrix();
  const Vec3 down_P = -R_SP.row(2);
  const ContactSurface& surface = *m.table->surface;
  const SurfacePoint point = surface.at(down_P, Vec3::Zero(), surface.lowest(down_P));
  return {R_SP * point.arm_P, s.place_S.z() - point.height};
}

// the velocity of the table under a point
Vec3 table_velocity(const BodyModel& m, const State& s, const Vec3& arm_S) {
  return Vec3(0, 0, m.table->friction.turntable).cross(s.place_S + arm_S);
}

// Impulses of the moments against rolling and boring of a normal impulse: at most what stops them.
void resist_turning(const BodyModel& m, double normal_impulse, FreeFlight& now) {
  const Friction& law = m.table->friction;
  const Vec3 w = now.w_S - Vec3(0, 0, law.turntable);
  const auto against = [&](const Vec3& way, double speed, double moment) {
    if (speed <= 0.0 || moment <= 0.0) return;
    const double stops = speed / way.dot(now.inverse_S * way);
    now.turn(-std::min(moment * normal_impulse, stops) * way);
  };
  const Vec3 rolling = horizontal(w);
  if (rolling.norm() > 0.0) against(rolling.normalized(), rolling.norm(), law.rolling);
  against(Vec3(0, 0, std::copysign(1.0, w.z())), std::abs(w.z()), law.boring);
}

// attitude and place after h seconds with the new velocities
void move(const BodyModel& m, double h, const FreeFlight& now, State& s) {
  s.q = normalized(exp_rotation(h * now.w_S) * s.q);
  s.y = s.q.conjugate() * now.L_S;
  s.place_S += h * now.velocity_S;
  s.linear_momentum_S = m.body.mass * now.velocity_S;
}

// what counts as small slip: this part of the speed of a fall from the height of the body, m/s
double small_slip(const BodyModel& m) {
  constexpr double kSmooth = 0.01;
  return kSmooth * std::sqrt(m.gravity_S.norm() * m.table->surface->reach());
}

// The horizontal force of dry friction per newton of normal force that is smoothed: in proportion
// to the slip where that is below `small` (m/s). It holds nothing.
Vec3 smoothed_friction(const Friction& law, double small, const Vec3& slip_S) {
  if (law.kind == Friction::Kind::none) return Vec3::Zero();
  if (law.kind == Friction::Kind::viscous) return -law.c * slip_S;
  const double mu = law.kind == Friction::Kind::rolling ? kEngineRolls : law.mu;
  return -mu / std::hypot(slip_S.norm(), small) * slip_S;
}

// The impulse that gives the lowest point, which moves with `before` against the table, the
// vertical velocity `wanted`, by the law of friction; zero if it would have to pull.
Vec3 contact_impulse(const Friction& law, const Mat3& K, const Vec3& before, double wanted) {
  const double rise = wanted - before.z();
  const auto along = [&](const Vec3& per_newton) -> Vec3 {
    const double gain = K.row(2).dot(per_newton);
    const double normal = gain > 0.0 ? rise / gain : 0.0;
    return normal > 0.0 ? Vec3(normal * per_newton) : Vec3::Zero();
  };
  const Vec3 slip = horizontal(before);
  if (law.kind == Friction::Kind::none) return along(Vec3::UnitZ());
  if (law.kind == Friction::Kind::viscous) return along(Vec3::UnitZ() - law.c * slip);
  Vec3 held = K.inverse() * Vec3(-slip.x(), -slip.y(), rise);
  if (held.z() <= 0.0) return along(Vec3::UnitZ());
  if (law.kind == Friction::Kind::rolling || horizontal(held).norm() <= law.mu * held.z())
    return held;
  return along(Vec3::UnitZ() + law.mu * horizontal(held).normalized());
}

// Velocities are put right by impulses. Gap: what is done about a gap (m) that has opened or
// closed: a velocity wanted against it, and a way by which the body is moved.
template <class Gap>
class ImpulseStep final : public Stepper {
 public:
  explicit ImpulseStep(const BodyModel& model) : model_(model) {}

  void step(double, double h, State& s, Work& work) const override {
    ++work.evaluations;
    advance(h, h, s);
  }
  // the body has the velocities of the whole step from its beginning
  void step_within(double, double h, double whole, State& s) const override {
    advance(h, whole, s);
  }

 private:
  // the body moves for `moves` of the h seconds of a step
  void advance(double moves, double h, State& s) const {
    const LowestPoint low = lowest_of(model_, s);
    FreeFlight now(model_, s);
    now.velocity_S += h * model_.gravity_S;
    const Vec3 slip = now.velocity_at(low.arm_S) - table_velocity(model_, s, low.arm_S);
    const double wanted = Gap::velocity(low.gap, h);
    // nothing is done before the body would be through the table
    if (slip.z() < wanted && low.gap + h * slip.z() <= 0.0) {
      const Vec3 impulse =
          contact_impulse(model_.table->friction, now.mobility(model_, low.arm_S), slip, wanted);
      now.push(model_, low.arm_S, impulse);
      resist_turning(model_, impulse.z(), now);
    }
    move(model_, moves, now, s);
    s.place_S.z() += Gap::lift(lowest_of(model_, s).gap);
  }

  BodyModel model_;
};

// Baumgarte, Comput. Methods Appl. Mech. Eng. 1 (1972) 1: a part of the gap is closed in each step
// by a velocity, which stays in the body.
template <int percent>
struct Stabilised {
  static double velocity(double gap, double h) { return -0.01 * percent * gap / h; }
  static double lift(double) { return 0.0; }
};

// The body is put back on the table, and its energy is what it happens to be there.
struct Projected {
  static double velocity(double, double) { return 0.0; }
  static double lift(double gap) { return std::max(0.0, -gap); }
};

// A stiff spring with a damper instead of a table.
class PenaltyStep final : public Stepper {
 public:
  explicit PenaltyStep(const BodyModel& model) : model_(model) {
    const double weight = model.body.mass * model.gravity_S.norm();
    stiffness_ = weight / (kSinks * model.table->surface->reach());
    small_ = small_slip(model);
    damping_ = 2.0 * kDamped * std::sqrt(stiffness_ * model.body.mass);
  }

  void step(double, double h, State& s, Work& work) const override {
    ++work.evaluations;
    const LowestPoint low = lowest_of(model_, s);
    FreeFlight now(model_, s);
    const Vec3 slip = now.velocity_at(low.arm_S) - table_velocity(model_, s, low.arm_S);
    now.velocity_S += h * model_.gravity_S;
    const double normal =
        low.gap < 0.0 ? std::max(0.0, -stiffness_ * low.gap - damping_ * slip.z()) : 0.0;
    const Vec3 per_newton =
        Vec3::UnitZ() + smoothed_friction(model_.table->friction, small_, horizontal(slip));
    now.push(model_, low.arm_S, h * normal * per_newton);
    resist_turning(model_, h * normal, now);
    move(model_, h, now, s);
  }

 private:
  static constexpr double kSinks = 1e-3;  // under its weight, in units of the reach of the body
  static constexpr double kDamped = 0.1;  // of critical damping
  BodyModel model_;
  double stiffness_;  // N/m
  double damping_;    // N s/m
  double small_;      // m/s
};

// The normal force is exact, and dry friction smoothed.
class SmoothedStep final : public Stepper {
 public:
  explicit SmoothedStep(const BodyModel& model)
      : model_(model), law_(model.table->friction), small_(small_slip(model)) {
    model_.table->friction.kind = Friction::Kind::viscous;
  }

  void step(double t, double h, State& s, Work& work) const override {
    ++work.evaluations;
    Touch touch;
    const Vec3 down_P = down_in_body(s.q);
    touch.piece = model_.table->surface->lowest(down_P);
    touch.sticks = touch.keeps_from_rolling = touch.keeps_from_boring = false;
    Moving now = moving_of(model_, s);
    if (gap_of(model_, touch, now) > kAbove * model_.table->surface->reach())
      touch.phase = Touch::Phase::flying;
    // as viscous friction that is as strong at this slip
    BodyModel slipping = model_;
    const Vec3 slip = horizontal(slip_of(model_, touch, now));
    const double size = slip.norm();
    slipping.table->friction.c =
        size > 0.0 ? smoothed_friction(law_, small_, slip).norm() / size : 0.0;
    Reaction reaction = reaction_of(slipping, touch, t, now);
    if (reaction.normal < 0.0) {
      touch.phase = Touch::Phase::flying;
      reaction = reaction_of(slipping, touch, t, now);
    }
    now.y += h * reaction.momentum_rate_P;
    now.velocity_S += h * reaction.acceleration_S;
    now.q = normalized(now.q * turn_by(h * angular_velocity(model_, now.y)));
    now.place_S += h * now.velocity_S;
    // what went through the table is put back
    if (touch.phase == Touch::Phase::touching || gap_of(model_, touch, now) < 0.0) {
      touch.phase = Touch::Phase::touching;
      hold_to_table(slipping, touch, now);
    }
    s = state_of(model_, now);
  }

 private:
  static constexpr double kAbove = 1e-9;  // of the reach
  BodyModel model_;
  Friction law_;
  double small_;  // m/s
};

}  // namespace

std::unique_ptr<Stepper> make_table_penalty(const BodyModel& model, double) {
  return std::make_unique<PenaltyStep>(model);
}

std::unique_ptr<Stepper> make_table_smoothed(const BodyModel& model, double) {
  return std::make_unique<SmoothedStep>(model);
}

std::unique_ptr<Stepper> make_table_baumgarte(const BodyModel& model, double) {
  return std::make_unique<ImpulseStep<Stabilised<20>>>(model);
}

std::unique_ptr<Stepper> make_table_baumgarte_hard(const BodyModel& model, double) {
  return std::make_unique<ImpulseStep<Stabilised<180>>>(model);
}

std::unique_ptr<Stepper> make_table_projection(const BodyModel& model, double) {
  return std::make_unique<ImpulseStep<Projected>>(model);
}

}  // namespace polhode
