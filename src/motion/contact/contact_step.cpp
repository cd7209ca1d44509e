// SPDX-License-Identifier: MIT
#include "motion/contact/contact_step.h"

#include <algorithm>
#include <cmath>

#include "math/so3.h"
#include "motion/steppers/dormand_prince.h"
#include "motion/steppers/radau_step.h"

namespace polhode {
namespace {

// attitude (x, y, z, w), angular momentum, place, velocity, work
constexpr int kNumbers = 14;
using Vector = Eigen::Matrix<double, kNumbers, 1>;

Vector vector_of(const OnTable& s) {
  Vector v;
  v << s.moving.q.coeffs(), s.moving.y, s.moving.place_S, s.moving.velocity_S, s.work;
  return v;
}

OnTable on_table(const Vector& v) {
  OnTable s;
  s.moving.q = normalized(Quat(v[3], v[0], v[1], v[2]));
  s.moving.y = v.segment<3>(4);
  s.moving.place_S = v.segment<3>(7);
  s.moving.velocity_S = v.segment<3>(10);
  s.work = v[13];
  return s;
}

Vector slope_of(const BodyModel& model, const Moving& now, const Reaction& reaction) {
  Vector slope;
  slope << attitude_rate(now.q, angular_velocity(model, now.y)).coeffs(), reaction.momentum_rate_P,
      now.velocity_S, reaction.acceleration_S, reaction.power;
  return slope;
}

// errors of what is stepped; height and vertical velocity follow while the body touches
double size_of_error(const Vector& v, const TableScales& scales, bool touching) {
  const auto part = [&](int from) {
    return touching ? v.segment<2>(from).norm() : v.segment<3>(from).norm();
  };
  return std::max({v.head<4>().norm(),
                   v.segment<3>(4).norm() / scales.momentum,
                   part(7) / scales.length,
                   part(10) / scales.speed});
}

// How far a motion (a slip, a rolling) is from its end, by its part along its direction and the
// rate of that, in units of `scale`. What has just begun is of either sign by its error, and grows.
double margin_of_end(double along, double rate, double creep, double scale) {
  const bool begins = std::abs(along) < creep && rate > 0.0;
  return (begins ? creep : along) / scale;
}

}  // namespace

TableScales table_scales(const BodyModel& model, const Moving& start, double tolerance) {
  constexpr double kLeastStopped = 1e-8;
  constexpr double kFlattest = 1e-8, kLeastFlat = 1e-4;  // rad
  // of the square of `stopped`; a disc of the tilt a turns at 2 sqrt(a g / length)
  constexpr double kFlatOfStopped = 100.0;
  TableScales scales;
  const double g = model.gravity_S.norm();
  scales.length = model.table->surface->reach();
  scales.weight = model.body.mass * g;
  scales.speed = std::max(std::sqrt(g * scales.length), start.velocity_S.norm());
  scales.rate = std::sqrt(g / scales.length);
  scales.momentum = std::max(start.y.norm(), model.moments.maxCoeff() * scales.rate);
  scales.tolerance = tolerance;
  scales.stopped = std::max(std::pow(tolerance, kPowerOfStopped), kLeastStopped);
  scales.flat = std::clamp(kFlatOfStopped * scales.stopped * scales.stopped, kFlattest, kLeastFlat);
  return scales;
}

Margins margins_of(const BodyModel& model,
                   const TableScales& scales,
                   const Touch& touch,
                   const Moving& now,
                   const Reaction& reaction) {
  Margins margins;
  margins.fill(1.0);
  const auto set = [&](ContactEvent event, double value) {
    margins[static_cast<std::size_t>(event)] = value;
  };
  if (touch.phase == Touch::Phase::lying) return margins;
  const ContactSurface& surface = *model.table->surface;
  if (touch.phase == Touch::Phase::flying) {
    set(ContactEvent::landing, gap_of(model, now) / scales.length);
    return margins;
  }
  const Friction& law = model.table->friction;
  const double normal = reaction.normal;
  set(ContactEvent::lift_off, normal / scales.weight);
  if (law.kind == Friction::Kind::coulomb) {
    if (touch.sticks) {
      set(ContactEvent::slip_begins,
          (law.mu * normal - reaction.friction_S.norm()) / scales.weight);
    } else {
      set(ContactEvent::slip_ends,
          margin_of_end(reaction.slip_S.dot(touch.slip_S),
                        reaction.slip_rate_S.dot(touch.slip_S),
                        touch.creep,
                        scales.speed));
    }
  }
  if (law.rolling > 0.0 || law.boring > 0.0) {
    const Vec3 w_S = now.q * angular_velocity(model, now.y) - Vec3(0, 0, law.turntable);
    const double per_newton_metre = 1.0 / (scales.weight * scales.length);
    if (law.rolling > 0.0 && touch.keeps_from_rolling) {
      set(ContactEvent::rolling_begins,
          (law.rolling * normal - reaction.moment_S.head<2>().norm()) * per_newton_metre);
    } else if (law.rolling > 0.0) {
      const Vec3 rate_S =
          now.q * Vec3(model.inverse_moments.cwiseProduct(reaction.momentum_rate_P));
      set(ContactEvent::rolling_ends,
          margin_of_end(
              w_S.dot(touch.roll_S), rate_S.dot(touch.roll_S), touch.roll_creep, scales.rate));
    }
    if (law.boring > 0.0 && touch.keeps_from_boring) {
      set(ContactEvent::boring_begins,
          (law.boring * normal - std::abs(reaction.moment_S.z())) * per_newton_metre);
    } else if (law.boring > 0.0) {
      set(ContactEvent::boring_ends, w_S.z() * touch.bore / scales.rate);
    }
  }
  if (surface.as_sphere() != nullptr) return margins;
  const Vec3 down_P = down_in_body(now.q);
  if (surface.pieces().size() > 1)
    set(ContactEvent::second_contact, surface.clearance(down_P, touch.piece) / scales.length);
  set(ContactEvent::lies_flat, surface.tilt_of_face(down_P, touch.piece) - scales.flat);
  return margins;
}

Touch refreshed(const BodyModel& model, const Touch& touch, const Moving& now) {
  const Friction& law = model.table->friction;
  Touch fresh = touch;
  if (touch.phase != Touch::Phase::touching) return fresh;
  const auto follow = [](Vec3& direction, Vec3 v) {
    v.z() = 0.0;
    if (v.norm() > 0.0 && v.dot(direction) > 0.0) direction = v.normalized();
  };
  if (law.kind == Friction::Kind::coulomb && !touch.sticks)
    follow(fresh.slip_S, slip_of(model, touch, now));
  if (law.rolling > 0.0 && !touch.keeps_from_rolling)
    follow(fresh.roll_S, now.q * angular_velocity(model, now.y));
  return fresh;
}

double least_of(const Margins& margins) {
  return *std::min_element(margins.begin(), margins.end());
}

double ContactStepper::turning_rate(const Touch& touch, const Moving& now) const {
  constexpr double kMobility = 3.5;  // of a ball, times its mass
  const Friction& law = model_.table->friction;
  if (touch.phase != Touch::Phase::touching) return 0.0;
  double rate = 0.0;
  if (law.kind == Friction::Kind::coulomb && !touch.sticks) {
    const double slip = slip_of(model_, touch, now).head<2>().norm() + touch.creep;
    rate = law.mu * model_.gravity_S.norm() * kMobility / slip;
  }
  if (law.rolling > 0.0 && !touch.keeps_from_rolling) {
    const Vec3 w_S = now.q * angular_velocity(model_, now.y);
    const double roll = w_S.head<2>().norm() + touch.roll_creep;
    const double inertia =
        model_.moments.maxCoeff() + model_.body.mass * scales_.length * scales_.length;
    rate = std::max(rate, law.rolling * scales_.weight / (inertia * roll));
  }
  return rate;
}

ContactStepper::Result ContactStepper::step(const Touch& touch,
                                            double t,
                                            double h,
                                            const OnTable& from,
                                            bool implicit,
                                            MarginsSeen* seen) const {
  Result result;
  const bool touching = touch.phase != Touch::Phase::flying;
  const auto slope = [&](double at, const Vector& v) -> Vector {
    OnTable now = on_table(v);
    Posed pose = posed(model_, touch, now.moving);
    hold_to_table(model_, touch, pose, now.moving);
    const Reaction reaction = reaction_of(model_, touch, at, now.moving, pose);
    if (seen != nullptr)
      seen->push_back({at, margins_of(model_, scales_, touch, now.moving, reaction)});
    return slope_of(model_, now.moving, reaction);
  };
  const auto size = [&](const Vector& e) {
    return size_of_error(e, scales_, touching);
  };
  const Vector v = vector_of(from);
  Vector change = Vector::Zero();
  // of the tolerance, how exactly Radau's equations are solved
  constexpr double kSolved = 0.01;
  // well below the slips, relative to a fall's speed, that have a direction of their own
  constexpr double kDifference = 1e-10;
  if (implicit) {
    result.order = 5;
    // the direction of a slip turns the slower, the faster the slip has become within the step
    const RadauSettings settings{
        .enough = kSolved * scales_.tolerance, .difference = kDifference, .place = 0.5};
    change = RadauStep<Vector, decltype(slope), decltype(size)>(slope, size, settings)(
        t, h, v, result.error);
  }
  if (result.order == 8 || std::isinf(result.error)) {
    result.order = 8;
    change = dormand_prince::step_of_order_8(t, h, v, slope, size, result.error);
  }
  result.end = on_table(v + change);
  hold_to_table(model_, touch, result.end.moving);
  return result;
}

OnTable ContactStepper::part(
    const Touch& touch, double t, double part, const OnTable& from, bool implicit) const {
  constexpr int kMostDivisions = 40;
  OnTable now = from;
  double left = part, h = part;
  for (int halvings = 0;;) {
    h = std::min(h, left);
    const Result trial = step(touch, t, h, now, implicit);
    if (!(trial.error <= scales_.tolerance) && halvings < kMostDivisions) {
      h *= 0.5;
      ++halvings;
      continue;
    }
    if (h == left) return trial.end;
    now = trial.end;
    t += h;
    left -= h;
    h *= 2.0;
    halvings = 0;
  }
}

Margins ContactStepper::margins(const Touch& touch, double t, const OnTable& now) const {
  return margins_of(model_, scales_, touch, now.moving, reaction_of(model_, touch, t, now.moving));
}

}  // namespace polhode
