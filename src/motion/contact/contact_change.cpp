// SPDX-License-Identifier: MIT
#include "motion/contact/contact_change.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "model/fall_on_table.h"
#include "motion/contact/let_go.h"

namespace polhode {
namespace {

// A rebound slower than this part of the tolerance, in units of the speed of a fall, is the end of
// endless bounces; slips that stop or turn in each of them would be left out with more.
constexpr double kLastRebound = 1e-3;
constexpr double kLeastRebound = 1e-12, kMostLastRebound = 1e-6;
// Bounces that are lower, in the reach of the surface, are told by their velocity alone.
constexpr double kLowBounce = 1e-11;
// By how much a body on whose face a motion ends may still have risen, turned or slid, rad and in
// its reach: beyond this there is no answer.
constexpr double kMostLeftOut = 0.1;
constexpr double kMostRise = 1e-3;

struct EventWords {
  const char* name;
  const char* words;
};
constexpr std::array<EventWords, kContactEvents> kWords = {{
    {"lift_off", "the body lifts off"},
    {"landing", "the body comes down on the table"},
    {"slip_ends", "the contact stops slipping"},
    {"slip_begins", "the contact begins to slip"},
    {"rolling_ends", "the body stops rolling"},
    {"rolling_begins", "the body begins to roll"},
    {"boring_ends", "the body stops turning about the vertical"},
    {"boring_begins", "the body begins to turn about the vertical"},
    {"second_contact", "a second point comes down on the table"},
    {"lies_flat", "a face lies on the table"},
}};

// what moves is let go on in its direction; what is at rest is held, if a law can hold it
Touch by_velocities(const ContactStepper& stepper, Touch touch, const Moving& now) {
  const BodyModel& model = stepper.model();
  const TableScales& scales = stepper.scales();
  const Friction& law = model.table->friction;
  const Vec3 slip = horizontal(slip_of(model, touch, now));
  const Vec3 w_S = now.q * angular_velocity(model, now.y) - Vec3(0, 0, law.turntable);
  touch.creep = scales.stopped * scales.speed;
  touch.sticks = slip.norm() <= touch.creep;
  if (!touch.sticks) touch.slip_S = slip.normalized();
  touch.roll_creep = scales.stopped * scales.rate;
  touch.keeps_from_rolling = horizontal(w_S).norm() <= touch.roll_creep;
  if (!touch.keeps_from_rolling) touch.roll_S = horizontal(w_S).normalized();
  touch.keeps_from_boring = std::abs(w_S.z()) <= scales.stopped * scales.rate;
  if (!touch.keeps_from_boring) touch.bore = std::copysign(1.0, w_S.z());
  return touch;
}

// how the body touches at these velocities, or that it lifts off
Touch touch_now(const ContactStepper& stepper,
                const Touch& before,
                double t,
                OnTable& now,
                const ContactEvent* given_way = nullptr) {
  Touch touch = before;
  touch.phase = Touch::Phase::touching;
  touch = by_velocities(stepper, touch, now.moving);
  // a slip that has just begun goes on, however slow it is, where only a rotation begins or ends
  const bool of_rotation =
      given_way != nullptr &&
      (*given_way == ContactEvent::rolling_ends || *given_way == ContactEvent::rolling_begins ||
       *given_way == ContactEvent::boring_ends || *given_way == ContactEvent::boring_begins);
  if (of_rotation && !before.sticks && touch.sticks) {
    touch.sticks = false;
    touch.slip_S = refreshed(stepper.model(), before, now.moving).slip_S;
  }
  // what is held stops, and what cannot be held goes on with what it has
  OnTable at_rest = now;
  hold_to_table(stepper.model(), touch, at_rest.moving);
  touch = let_go(stepper, touch, t, at_rest, given_way);
  // what is snapped to zero counts as work
  const double had = energy_of(stepper.model(), now.moving);
  hold_to_table(stepper.model(), touch, now.moving);
  now.work += energy_of(stepper.model(), now.moving) - had;
  const Reaction reaction = reaction_of(stepper.model(), touch, t, now.moving);
  if (reaction.normal < 0.0) touch.phase = Touch::Phase::flying;
  return touch;
}

// kinetic energy, J
double kinetic(const BodyModel& model, const Moving& now) {
  return 0.5 * now.y.dot(angular_velocity(model, now.y)) +
         0.5 * model.body.mass * now.velocity_S.squaredNorm();
}

Error two_contacts(double t) {
  return {Fault::check_failed,
          fmt::format("at {:.6g} s a second point of the body comes down on the table; how it goes "
                      "on along an edge or on two points is not computed: end the motion before, "
                      "or round the body",
                      t),
          {{}, 0, "motion.duration"}};
}

// How long a bounce takes whose lowest point rises with the velocity `rebound`, m/s, and is pulled
// down by `pull`, m/s^2, if it is low and short; else 0.
double time_of_low_bounce(const ContactStepper& stepper,
                          double rebound,
                          double pull,
                          const Moving& now) {
  constexpr double kShort = 1e-3;  // rad
  const TableScales& scales = stepper.scales();
  if (!(pull > 0.0) || rebound * rebound >= 2.0 * pull * kLowBounce * scales.length) return 0.0;
  const double flight = 2.0 * rebound / pull;
  const double rate = scales.rate + angular_velocity(stepper.model(), now.y).norm();
  return flight * rate < kShort ? flight : 0.0;
}

ContactChange land(const ContactStepper& stepper, const Touch& before, double t, OnTable& now) {
  const BodyModel& model = stepper.model();
  const TableScales& scales = stepper.scales();
  ContactChange change{before};
  Touch& touch = change.touch;
  const ContactSurface& surface = *model.table->surface;
  const Vec3 down_P = down_in_body(now.moving.q);
  touch.piece = surface.lowest(down_P);
  constexpr double kTogether = 1e-3;  // of the reach: as good as together
  if (surface.clearance(down_P, touch.piece) < kTogether * scales.length ||
      surface.tilt_of_face(down_P, touch.piece) < scales.flat)
    throw two_contacts(t);
  const double restitution = model.table->friction.restitution;
  const double speed = -slip_of(model, touch, now.moving).z();
  const double had = energy_of(model, now.moving);
  const double least =
      std::clamp(kLastRebound * scales.tolerance, kLeastRebound, kMostLastRebound) * scales.speed;
  const bool bounces = restitution * speed > least;
  // the impulses of the rest of endless bounces together are that of a fall that ends in contact
  fall_on_table(model, touch, bounces ? restitution : 0.0, now.moving);
  const double rebound = slip_of(model, touch, now.moving).z();
  touch.phase = Touch::Phase::flying;
  const double pull = -reaction_of(model, touch, t, now.moving).slip_rate_S.z();
  if (bounces && rebound > least) {
    now.work += energy_of(model, now.moving) - had;
    change.flies_for = time_of_low_bounce(stepper, rebound, pull, now.moving);
    return change;
  }
  change.bounces_end = restitution > 0.0 && restitution < 1.0 && pull > 0.0;
  touch.phase = Touch::Phase::touching;
  touch.sticks = touch.keeps_from_boring = touch.keeps_from_rolling = false;
  hold_to_table(model, touch, now.moving);
  now.work += energy_of(model, now.moving) - had;
  touch = touch_now(stepper, touch, t, now);
  return change;
}

// what may move a body that lies on a face, in words; "": nothing does
std::string what_moves_it_on(const BodyModel& model) {
  const Friction& law = model.table->friction;
  const auto acts_at_rest = [](const Load& load) {
    return load.kind != Load::Kind::damp_momentum && load.kind != Load::Kind::damp_spin;
  };
  const std::vector<Load>& loads = model.loads.turning;
  if (!model.loads.pushes.empty() || std::any_of(loads.begin(), loads.end(), acts_at_rest))
    return "loads act on it";
  if (law.turntable != 0.0) return "the table turns";
  const double along = horizontal(model.gravity_S).norm(), down = -model.gravity_S.z();
  const bool is_held = law.kind == Friction::Kind::rolling ||
                       (law.kind == Friction::Kind::coulomb && along <= law.mu * down);
  return along > 0.0 && !is_held ? "gravity pulls it along" : "";
}

// For how long a body with this speed (rad/s, and its reach a second) slides or turns on a face.
double slides_for(const Friction& law, const BodyModel& model, double rate, double speed) {
  if (law.kind == Friction::Kind::rolling) return 0.0;
  if (law.kind == Friction::Kind::coulomb) return speed / (law.mu * rate * rate);
  if (law.kind == Friction::Kind::viscous) return model.body.mass / law.c;
  return std::numeric_limits<double>::infinity();
}

// About how far a body would go on that is laid on a face: by which angle (rad) it could rise from
// there, turn about the vertical, or slide, in the reach of its surface.
double left_out(const ContactStepper& stepper, const Touch& touch, double t, const Moving& now) {
  constexpr double kSlaps = 10.0;  // times its tilt
  const BodyModel& model = stepper.model();
  const TableScales& scales = stepper.scales();
  const Vec3 w_S = now.q * angular_velocity(model, now.y);
  const double rocking = 0.5 * (now.q * now.y).head<2>().dot(w_S.head<2>()) +
                         0.5 * model.body.mass * now.velocity_S.z() * now.velocity_S.z();
  const double all = scales.weight * scales.length;
  const double rise = rocking / all;
  const double tilt =
      std::max(scales.flat, model.table->surface->tilt_of_face(down_in_body(now.q), touch.piece));
  if (rise > kMostRise) return std::numeric_limits<double>::infinity();
  const double speed =
      std::max(horizontal(now.velocity_S).norm() / scales.length, std::abs(w_S.z()));
  if (speed <= scales.stopped * scales.rate) return std::max(tilt, rise);
  // a disc that runs round on its edge loses energy as the square of the time that is left
  const double power = -reaction_of(model, touch, t, now).power;
  const double rocks_for = rise > kSlaps * tilt ? std::sqrt(8.0 * rise) / scales.rate
                                                : 2.0 * (rocking + tilt * all) / power;
  const double lasts = rocks_for + slides_for(model.table->friction, model, scales.rate, speed);
  return lasts >= 0.0 ? std::max({tilt, rise, speed * lasts})
                      : std::numeric_limits<double>::infinity();
}

ContactChange lie_down(const ContactStepper& stepper, const Touch& before, double t, OnTable& now) {
  const BodyModel& model = stepper.model();
  ContactChange change{before};
  change.left_out_rad = left_out(stepper, before, t, now.moving);
  const double left = kinetic(model, now.moving);
  if (change.left_out_rad > kMostLeftOut) {
    throw Error(Fault::check_failed,
                fmt::format("at {:.6g} s a flat face comes down on the table while the body still "
                            "moves ({:.2g} J); how it slides, turns or rises on a face is not "
                            "computed: end the motion before, or round the body",
                            t,
                            left),
                {{}, 0, "motion.duration"});
  }
  if (const std::string why = what_moves_it_on(model); !why.empty()) {
    throw Error(Fault::check_failed,
                fmt::format("at {:.6g} s the body lies on a flat face, and {}; how it slides or "
                            "rises from a face is not computed: end the motion before",
                            t,
                            why),
                {{}, 0, "motion.duration"});
  }
  change.touch.phase = Touch::Phase::lying;
  now.moving.y = now.moving.velocity_S = Vec3::Zero();
  now.work -= left;
  return change;
}

// Ideal rolling holds a body sideways also where nothing presses it to the table. Let go, it may
// come down at once, or again and again; then there is no motion that goes on.
ContactChange lift_off(const ContactStepper& stepper,
                       const Touch& before,
                       double t,
                       const OnTable& now) {
  constexpr double kFalls = 1e-6;  // of gravity: beyond the round-off of the normal force
  const BodyModel& model = stepper.model();
  ContactChange change{before};
  change.touch.phase = Touch::Phase::flying;
  const Reaction free = reaction_of(model, change.touch, t, now.moving);
  if (free.slip_rate_S.z() < -kFalls * model.gravity_S.norm()) throw held_without_pressure(t);
  return change;
}

}  // namespace

Error held_without_pressure(double t) {
  return {Fault::check_failed,
          fmt::format("at {:.6g} s rolling needs a friction that holds the body while nothing "
                      "presses it to the table, and without it the body comes down again: "
                      "take kind = \"coulomb\", with which it slips before",
                      t),
          {{}, 0, "motion.friction"}};
}

std::string words_for(ContactEvent event) {
  return kWords[static_cast<std::size_t>(event)].words;
}

std::string name_of(ContactEvent event) {
  return kWords[static_cast<std::size_t>(event)].name;
}

Touch first_touch(const ContactStepper& stepper, double t, OnTable& now) {
  const BodyModel& model = stepper.model();
  Touch touch;
  touch.piece = model.table->surface->lowest(down_in_body(now.moving.q));
  constexpr double kAbove = 1e-9;
  const double gap = gap_of(model, touch, now.moving) / stepper.scales().length;
  if (gap > kAbove || slip_of(model, touch, now.moving).z() > kAbove * stepper.scales().speed) {
    touch.phase = Touch::Phase::flying;
    return touch;
  }
  touch.sticks = touch.keeps_from_boring = touch.keeps_from_rolling = false;
  hold_to_table(model, touch, now.moving);
  return touch_now(stepper, touch, t, now);
}

ContactChange change_at(const ContactStepper& stepper,
                        ContactEvent event,
                        const Touch& before,
                        double t,
                        OnTable& now) {
  switch (event) {
    case ContactEvent::landing:
      return land(stepper, before, t, now);
    case ContactEvent::lies_flat:
      return lie_down(stepper, before, t, now);
    case ContactEvent::second_contact:
      throw two_contacts(t);
    case ContactEvent::lift_off:
      return lift_off(stepper, before, t, now);
    default:
      return {touch_now(stepper, before, t, now, &event)};
  }
}

}  // namespace polhode
