// SPDX-License-Identifier: MIT
#include "model/table.h"

#include <array>
#include <cmath>

#include <Eigen/LU>

#include "base/error.h"
#include "model/mobility.h"

namespace polhode {
namespace {

constexpr int kMostUnknowns = 6;
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostUnknowns, 1>;
using System =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostUnknowns, kMostUnknowns>;

// accelerations of the centre of mass and of the rotation, in P
struct Accelerations {
  Vec3 linear = Vec3::Zero();   // m/s^2
  Vec3 angular = Vec3::Zero();  // rad/s^2
};

// a force at the contact and a moment, in P, per unit of one unknown
struct Effort {
  Vec3 force = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
};

Accelerations of_effort(const BodyModel& m, const Vec3& arm, const Effort& effort) {
  return {effort.force / m.body.mass,
          m.inverse_moments.cwiseProduct(arm.cross(effort.force) + effort.moment)};
}

// What the table may do to the body: each unknown with its direction, and the acceleration that it
// keeps at a given value. For bodies that are also kept from rolling or boring.
class Contact {
 public:
  Contact(const BodyModel& m, const Vec3& arm) : m_(m), arm_(arm) {}

  // the contact point is not accelerated along `direction` but for `wanted`
  void hold_point(const Vec3& direction, const Effort& effort, double wanted) {
    add(effort, {direction, arm_.cross(direction)}, wanted);
  }
  // nor is the rotation about it
  void hold_turn(const Vec3& direction, double wanted) {
    add({Vec3::Zero(), direction}, {Vec3::Zero(), direction}, wanted);
  }

  // force and moment that do so; not numbers where there are none
  Effort solve() const {
    System A(count_, count_);
    Unknowns b(count_);
    for (int i = 0; i < count_; ++i) {
      const Accelerations& row = rows_[static_cast<std::size_t>(i)];
      b[i] = wanted_[static_cast<std::size_t>(i)];
      for (int j = 0; j < count_; ++j) {
        const Accelerations& column = columns_[static_cast<std::size_t>(j)];
        A(i, j) = row.linear.dot(column.linear) + row.angular.dot(column.angular);
      }
    }
    Effort total;
    // the first unknown, the normal force, accelerates what it holds by this much while all else is
    // held; as in slide(), a force that pushes the contact point into the table is no answer
    const int others = count_ - 1;
    const Eigen::PartialPivLU<System> lu(A);
    if (!(lu.determinant() / A.bottomRightCorner(others, others).determinant() > 0.0)) {
      total.force.fill(NAN);
      return total;
    }
    const Unknowns x = lu.solve(b);
    for (int i = 0; i < count_; ++i) {
      total.force += x[i] * efforts_[static_cast<std::size_t>(i)].force;
      total.moment += x[i] * efforts_[static_cast<std::size_t>(i)].moment;
    }
    return total;
  }

 private:
  void add(const Effort& effort, const Accelerations& row, double wanted) {
    const auto i = static_cast<std::size_t>(count_++);
    efforts_[i] = effort;
    rows_[i] = row;
    columns_[i] = of_effort(m_, arm_, effort);
    wanted_[i] = wanted;
  }

  const BodyModel& m_;
  Vec3 arm_;
  int count_ = 0;
  std::array<Effort, kMostUnknowns> efforts_;
  std::array<Accelerations, kMostUnknowns> rows_, columns_;
  std::array<double, kMostUnknowns> wanted_{};
};

// The normal force with what is in proportion to it, so that the contact point is accelerated by
// `missing` along `up`.
Effort slide(const BodyModel& m,
             const Vec3& arm,
             const Vec3& up,
             const Effort& per_newton,
             const Vec3& missing) {
  const Accelerations gain = of_effort(m, arm, per_newton);
  const double along = up.dot(gain.linear + gain.angular.cross(arm));
  // a force that pushes the contact point into the table is no answer
  const double normal = along > 0.0 ? up.dot(missing) / along : NAN;
  return {normal * per_newton.force, normal * per_newton.moment};
}

// The force that accelerates the contact point by `missing`, and a moment per newton of its part
// along `up`.
Effort stick(const BodyModel& m,
             const Vec3& arm,
             const Vec3& up,
             const Vec3& moment_per_newton,
             const Vec3& missing) {
  Mat3 K = mobility(m, arm);
  const bool resisted = !moment_per_newton.isZero(0.0);
  if (resisted) K += m.inverse_moments.cwiseProduct(moment_per_newton).cross(arm) * up.transpose();
  const Vec3 force = K.inverse() * missing;
  if (!resisted) return {force, Vec3::Zero()};
  return {force, force.dot(up) * moment_per_newton};
}

// v / |v|, but on the side of `reference`, a unit vector, which stands for it where it is zero.
// Only the part along it is turned about: so beyond a zero, friction goes on as before it, and
// still brakes what goes to the side.
Vec3 direction_near(const Vec3& v, const Vec3& reference) {
  const double size = v.norm();
  if (!(size > 0.0)) return reference;
  const double along = v.dot(reference);
  return along < 0.0 ? Vec3((v - 2.0 * along * reference) / size) : Vec3(v / size);
}

// the force and moment of the laws of friction per newton of normal force, in S, where nothing is
// held
Effort friction_per_newton(const Friction& law,
                           const Touch& touch,
                           const Vec3& slip_S,
                           const Vec3& slip_way_S,
                           const Vec3& roll_way_S) {
  Effort effort;
  if (law.kind == Friction::Kind::viscous) effort.force = -law.c * horizontal(slip_S);
  if (law.kind == Friction::Kind::coulomb && !touch.sticks) effort.force = -law.mu * slip_way_S;
  if (law.rolling > 0.0 && !touch.keeps_from_rolling) effort.moment = -law.rolling * roll_way_S;
  if (law.boring > 0.0 && !touch.keeps_from_boring)
    effort.moment -= law.boring * touch.bore * Vec3::UnitZ();
  return effort;
}

// beyond this many times Touch::creep, the direction of slip is that of the slip alone
constexpr double kCreepReach = 6.0;

// The direction against which friction acts on a motion v (a slip, a rolling) that is slower than
// kCreepReach times `creep`: the one in which v changes by itself, and more and more its own.
// reference: that so far; deceleration: about what friction does to v; rate_along: how v changes if
// friction acts against a direction.
template <class Rate>
Vec3 creeping_direction(const Vec3& v,
                        const Vec3& reference,
                        double creep,
                        double deceleration,
                        const Rate& rate_along) {
  Vec3 own = creep_direction(reference, deceleration, rate_along);
  // what clearly dies does so in its own direction, as does what could not go on in the other,
  // where it would be held between them, or where the body would jam
  constexpr double kDies = 0.05;
  const double grows = rate_along(own).dot(own);
  const bool turns_back = own.dot(reference) < 0.0;
  if (!(grows >= (turns_back ? 0.0 : -kDies * deceleration))) own = reference;
  const double part = v.norm() / creep;
  return (part * direction_near(v, reference) + std::exp(-part * part) * own).normalized();
}

}  // namespace

Moving moving_of(const BodyModel& model, const State& state) {
  return {state.q, state.y, state.place_S, state.linear_momentum_S / model.body.mass};
}

State state_of(const BodyModel& model, const Moving& now) {
  return {now.q, now.y, now.place_S, model.body.mass * now.velocity_S};
}

Posed posed(const BodyModel& model, const Touch& touch, const Moving& now) {
  Posed pose;
  pose.R_SP = now.q.toRotationMatrix();
  pose.up_P = pose.R_SP.row(2);
  pose.w_P = angular_velocity(model, now.y);
  pose.point = model.table->surface->at(-pose.up_P, pose.w_P.cross(pose.up_P), touch.piece);
  return pose;
}

Vec3 slip_of(const BodyModel& model, const Touch& touch, const Moving& now) {
  const Posed pose = posed(model, touch, now);
  const Vec3& arm_P = pose.point.arm_P;
  const Vec3 turntable(0.0, 0.0, model.table->friction.turntable);
  return now.velocity_S + pose.R_SP * pose.w_P.cross(arm_P) -
         turntable.cross(now.place_S + pose.R_SP * arm_P);
}

double gap_of(const BodyModel& model, const Touch& touch, const Moving& now) {
  const Vec3 down_P = down_in_body(now.q);
  return now.place_S.z() - model.table->surface->height(down_P, touch.piece);
}

double gap_of(const BodyModel& model, const Moving& now) {
  const Vec3 down_P = down_in_body(now.q);
  const ContactSurface& surface = *model.table->surface;
  return now.place_S.z() - surface.height(down_P, surface.lowest(down_P));
}

bool is_on_table(const BodyModel& model, const Moving& now) {
  constexpr double kAbove = 1e-9;  // of the reach
  return gap_of(model, now) <= kAbove * model.table->surface->reach();
}

double energy_of(const BodyModel& model, const Moving& now) {
  return energy(model, state_of(model, now));
}

Reaction reaction_of(const BodyModel& model, const Touch& touch, double t, const Moving& now) {
  return reaction_of(model, touch, t, now, posed(model, touch, now));
}

Reaction reaction_of(
    const BodyModel& model, const Touch& touch, double t, const Moving& now, const Posed& pose) {
  const Friction& law = model.table->friction;
  const double mass = model.body.mass;
  const Mat3& R_SP = pose.R_SP;
  const Vec3 &up_P = pose.up_P, &w_P = pose.w_P;
  Reaction found;
  found.point = pose.point;
  if (touch.phase == Touch::Phase::lying) return found;

  // gravity and loads
  found.acceleration_S = model.gravity_S;
  found.momentum_rate_P = now.y.cross(w_P);
  if (!model.loads.empty()) {
    const State s = state_of(model, now);
    found.momentum_rate_P += torque_of_loads(model, t, s);
    found.acceleration_S = force(model, t, s) / mass;
    found.power = power_of_loads(model, t, s);
  }

  // the contact moves over the body: d down / dt = w x up. The material point that touches keeps
  // its slip while another one takes its place
  const Vec3& arm = found.point.arm_P;
  const Vec3 turntable_P = law.turntable * up_P;
  const Vec3 velocity_P = R_SP.transpose() * now.velocity_S;
  const Vec3 turning_P = w_P.cross(arm);
  const Vec3& arm_rate = found.point.arm_rate_P;
  found.slip_S = R_SP * (velocity_P + turning_P);
  Vec3 wanted_P = -w_P.cross(turning_P + arm_rate);
  if (law.turntable != 0.0) {
    found.slip_S -= Vec3(0, 0, law.turntable).cross(now.place_S + R_SP * arm);
    wanted_P += turntable_P.cross(velocity_P + turning_P + arm_rate);
  }
  found.slip_S.z() = 0.0;
  const Vec3 missing_P = wanted_P - R_SP.transpose() * found.acceleration_S -
                         Vec3(model.inverse_moments.cwiseProduct(found.momentum_rate_P)).cross(arm);
  if (touch.phase == Touch::Phase::flying) {
    found.slip_rate_S = R_SP * -missing_P;
    return found;
  }

  // what the laws say per newton of normal force, and what is held
  const Vec3 w_S = R_SP * (w_P - turntable_P);
  found.roll_direction_S = direction_near(horizontal(w_S), touch.roll_S);
  const auto per_newton_along = [&](const Vec3& slip_way_S, const Vec3& roll_way_S) -> Effort {
    const Effort law_S = friction_per_newton(law, touch, found.slip_S, slip_way_S, roll_way_S);
    return {R_SP.transpose() * Vec3(law_S.force + Vec3::UnitZ()), R_SP.transpose() * law_S.moment};
  };
  const bool held =
      law.kind == Friction::Kind::rolling || (law.kind == Friction::Kind::coulomb && touch.sticks);
  const bool no_roll = law.rolling > 0.0 && touch.keeps_from_rolling;
  const bool no_bore = law.boring > 0.0 && touch.keeps_from_boring;
  const auto exerted = [&](const Effort& per_newton) -> Effort {
    if (!no_roll && !no_bore) {
      return held ? stick(model, arm, up_P, per_newton.moment, missing_P)
                  : slide(model, arm, up_P, per_newton, missing_P);
    }
    const Vec3 x_P = R_SP.row(0), y_P = R_SP.row(1);
    Contact contact(model, arm);
    contact.hold_point(up_P, per_newton, up_P.dot(missing_P));
    if (held) {
      contact.hold_point(x_P, {x_P, Vec3::Zero()}, x_P.dot(missing_P));
      contact.hold_point(y_P, {y_P, Vec3::Zero()}, y_P.dot(missing_P));
    }
    const Vec3 turning = model.inverse_moments.cwiseProduct(found.momentum_rate_P);
    if (no_roll) {
      contact.hold_turn(x_P, -x_P.dot(turning));
      contact.hold_turn(y_P, -y_P.dot(turning));
    }
    if (no_bore) contact.hold_turn(up_P, -up_P.dot(turning));
    return contact.solve();
  };

  found.slip_direction_S = direction_near(found.slip_S, touch.slip_S);
  const double weight = mass * model.gravity_S.norm();
  const auto normal_of = [&](const Effort& per_newton) {
    const double normal = std::abs(up_P.dot(exerted(per_newton).force));
    return normal > 0.0 ? normal : weight;
  };
  if (law.rolling > 0.0 && !no_roll && horizontal(w_S).norm() < kCreepReach * touch.roll_creep) {
    const Vec3& K = model.inverse_moments;
    const double level = 0.5 * (K.sum() - up_P.dot(K.cwiseProduct(up_P)));
    const double normal = normal_of(per_newton_along(found.slip_direction_S, touch.roll_S));
    const auto rate_along = [&](const Vec3& way) {
      const Effort effort = exerted(per_newton_along(found.slip_direction_S, way));
      const Vec3 moment_P = found.momentum_rate_P + arm.cross(effort.force) + effort.moment;
      return horizontal(R_SP * K.cwiseProduct(moment_P));
    };
    found.roll_direction_S = creeping_direction(
        horizontal(w_S), touch.roll_S, touch.roll_creep, level * law.rolling * normal, rate_along);
  }
  const bool creeps = law.kind == Friction::Kind::coulomb && !touch.sticks &&
                      found.slip_S.norm() < kCreepReach * touch.creep;
  if (creeps) {
    // what friction does to the slip, as a mean of all directions: so the iteration converges
    const Mat3 K = mobility(model, arm);
    const double level = 0.5 * (K.trace() - up_P.dot(K * up_P));
    const double normal = normal_of(per_newton_along(touch.slip_S, found.roll_direction_S));
    const auto rate_along = [&](const Vec3& way) {
      const Accelerations gain =
          of_effort(model, arm, exerted(per_newton_along(way, found.roll_direction_S)));
      return Vec3(R_SP * (gain.linear + gain.angular.cross(arm) - missing_P));
    };
    found.slip_direction_S = creeping_direction(
        found.slip_S, touch.slip_S, touch.creep, level * law.mu * normal, rate_along);
  }
  Effort total = exerted(per_newton_along(found.slip_direction_S, found.roll_direction_S));
  const bool is_beyond = !held && found.slip_S.dot(touch.slip_S) < 0.0;
  if ((creeps || is_beyond) && !total.force.allFinite()) {
    // a step looks beyond the zero of the slip, where there may be no solution, nor a need for one
    found.slip_direction_S = touch.slip_S;
    total = exerted(per_newton_along(found.slip_direction_S, found.roll_direction_S));
  }
  if (!total.force.allFinite()) {
    throw Error(Fault::check_failed,
                "the equations of friction have no solution here (the body jams: Painleve's "
                "paradox); take less friction",
                {{}, 0, "motion.friction"});
  }
  const Vec3 force_S = R_SP * total.force;
  found.normal = force_S.z();
  found.friction_S = Vec3(force_S.x(), force_S.y(), 0.0);
  found.moment_S = R_SP * total.moment;
  const Vec3 moment_P = arm.cross(total.force) + total.moment;
  found.momentum_rate_P += moment_P;
  found.acceleration_S += force_S / mass;
  found.slip_rate_S =
      R_SP * Vec3(total.force / mass +
                  Vec3(model.inverse_moments.cwiseProduct(moment_P)).cross(arm) - missing_P);
  if (!law.keeps_energy())
    found.power += total.force.dot(velocity_P + turning_P) + total.moment.dot(w_P);
  return found;
}

void hold_to_table(const BodyModel& model, const Touch& touch, Moving& now) {
  Posed pose = posed(model, touch, now);
  hold_to_table(model, touch, pose, now);
}

void hold_to_table(const BodyModel& model, const Touch& touch, Posed& pose, Moving& now) {
  if (touch.phase == Touch::Phase::flying) return;
  if (touch.phase == Touch::Phase::lying) {
    now.y = now.velocity_S = pose.w_P = Vec3::Zero();
    return;
  }
  const Friction& law = model.table->friction;
  // what is kept from turning
  const bool no_roll = law.rolling > 0.0 && touch.keeps_from_rolling;
  const bool no_bore = law.boring > 0.0 && touch.keeps_from_boring;
  if (no_roll || no_bore) {
    const Vec3& up_P = pose.up_P;
    const Vec3 w_P = pose.w_P;
    const Vec3 upright = no_bore ? Vec3(law.turntable * up_P) : Vec3(w_P.dot(up_P) * up_P);
    const Vec3 level = no_roll ? Vec3(Vec3::Zero()) : Vec3(w_P - w_P.dot(up_P) * up_P);
    pose.w_P = upright + level;
    now.y = model.moments.cwiseProduct(pose.w_P);
    pose.point = model.table->surface->at(-up_P, pose.w_P.cross(up_P), touch.piece);
  }
  const Vec3& arm = pose.point.arm_P;
  now.place_S.z() = pose.point.height;
  const Vec3 point_speed_S = pose.R_SP * pose.w_P.cross(arm);
  now.velocity_S.z() = -point_speed_S.z();
  const bool held =
      law.kind == Friction::Kind::rolling || (law.kind == Friction::Kind::coulomb && touch.sticks);
  if (!held) return;
  now.velocity_S.head<2>() = -point_speed_S.head<2>();
  if (law.turntable == 0.0) return;
  const Vec3 table_speed_S = Vec3(0.0, 0.0, law.turntable).cross(now.place_S + pose.R_SP * arm);
  now.velocity_S.head<2>() += table_speed_S.head<2>();
}

}  // namespace polhode
