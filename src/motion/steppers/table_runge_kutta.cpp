// SPDX-License-Identifier: MIT
// Explicit Runge-Kutta steps of a body on a table, with the equations of motion/contact/ but
// without events: how the body touches is decided at the beginning of each step. Kept to show what
// a step does that passes over an event, and how Euler's step drifts while a body rolls.
#include <array>
#include <cmath>

#include "math/so3.h"
#include "model/fall_on_table.h"
#include "motion/contact/contact_change.h"
#include "motion/steppers/all.h"

namespace polhode {
namespace {

// the tolerance that goes with such steps: what is slower than it allows counts as at rest
constexpr double kRestTolerance = 1e-6;

// attitude (x, y, z, w), angular momentum, place, velocity
using TableVector = Eigen::Matrix<double, 13, 1>;

TableVector table_vector(const Moving& now) {
  TableVector v;
  v << now.q.coeffs(), now.y, now.place_S, now.velocity_S;
  return v;
}

Moving moving_at(const TableVector& v) {
  Moving now;
  now.q = normalized(Quat(v[3], v[0], v[1], v[2]));
  now.y = v.segment<3>(4);
  now.place_S = v.segment<3>(7);
  now.velocity_S = v.segment<3>(10);
  return now;
}

// with the angular momentum that scales are for
Moving typical_moving(double momentum_scale) {
  Moving now;
  now.y = momentum_scale * Vec3::UnitZ();
  return now;
}

class TableRungeKutta final : public Stepper {
 public:
  // held: height, and velocity where the contact sticks, follow from the rest. Otherwise only their
  // accelerations do, and the constraint drifts.
  TableRungeKutta(const BodyModel& model, double momentum_scale, int order, bool held)
      : stepper_(model, table_scales(model, typical_moving(momentum_scale), kRestTolerance)),
        order_(order),
        held_(held) {}

  void step(double t, double h, State& s, Work& work) const override {
    const BodyModel& model = stepper_.model();
    OnTable begins;
    begins.moving = moving_of(model, s);
    OnTable known = begins;
    // what has drifted off the table is still taken to touch it
    if (!held_) put_down(known.moving);
    const Touch touch = first_touch(stepper_, t, known);
    if (held_) begins = known;
    Moving now = after(touch, t, h, begins.moving, work);
    end_flight(touch, now);
    s = state_of(model, now);
  }

 private:
  void put_down(Moving& now) const {
    constexpr double kOff = 0.1;  // of the reach: farther off, it flies
    const BodyModel& model = stepper_.model();
    Touch touch;
    touch.piece = model.table->surface->lowest(down_in_body(now.q));
    const double gap = gap_of(model, touch, now);
    if (std::abs(gap) > kOff * stepper_.scales().length) return;
    now.place_S.z() -= gap;
    now.velocity_S.z() -= slip_of(model, touch, now).z();
  }

  Moving after(const Touch& touch, double t, double h, const Moving& from, Work& work) const {
    const TableVector v = table_vector(from);
    const auto slope = [&](double at, const TableVector& w) -> TableVector {
      ++work.evaluations;
      Moving now = moving_at(w);
      if (held_) hold_to_table(stepper_.model(), touch, now);
      const Reaction reaction = reaction_of(stepper_.model(), touch, at, now);
      TableVector rate;
      rate << attitude_rate(now.q, angular_velocity(stepper_.model(), now.y)).coeffs(),
          reaction.momentum_rate_P, now.velocity_S, reaction.acceleration_S;
      return rate;
    };
    const TableVector k1 = slope(t, v);
    if (order_ == 1) return held(touch, moving_at(v + h * k1));
    const TableVector k2 = slope(t + 0.5 * h, v + 0.5 * h * k1);
    const TableVector k3 = slope(t + 0.5 * h, v + 0.5 * h * k2);
    const TableVector k4 = slope(t + h, v + h * k3);
    return held(touch, moving_at(v + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)));
  }

  Moving held(const Touch& touch, Moving now) const {
    if (held_) hold_to_table(stepper_.model(), touch, now);
    return now;
  }

  // a body that was found in the table at the end of a step has come down on it then
  void end_flight(Touch touch, Moving& now) const {
    if (touch.phase != Touch::Phase::flying) return;
    const BodyModel& model = stepper_.model();
    touch.piece = model.table->surface->lowest(down_in_body(now.q));
    const double gap = gap_of(model, touch, now);
    if (gap >= 0.0) return;
    now.place_S.z() -= gap;
    if (slip_of(model, touch, now).z() < 0.0)
      fall_on_table(model, touch, model.table->friction.restitution, now);
  }

  ContactStepper stepper_;
  int order_;
  bool held_;
};

}  // namespace

std::unique_ptr<Stepper> make_table_euler(const BodyModel& model, double momentum_scale) {
  return std::make_unique<TableRungeKutta>(model, momentum_scale, 1, false);
}

std::unique_ptr<Stepper> make_table_rk4(const BodyModel& model, double momentum_scale) {
  return std::make_unique<TableRungeKutta>(model, momentum_scale, 4, true);
}

}  // namespace polhode
