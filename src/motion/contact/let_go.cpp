// SPDX-License-Identifier: MIT
#include "motion/contact/let_go.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "base/error.h"

namespace polhode {
namespace {

// Whether a law holds what the event lets go.
bool is_held(const Friction& law, const Touch& touch, ContactEvent event) {
  switch (event) {
    case ContactEvent::slip_begins:
      return law.kind == Friction::Kind::coulomb && touch.sticks;
    case ContactEvent::rolling_begins:
      return law.rolling > 0.0 && touch.keeps_from_rolling;
    case ContactEvent::boring_begins:
      return law.boring > 0.0 && touch.keeps_from_boring;
    default:
      return false;
  }
}

// Whether it is held, and needs more than the law gives.
bool gives_way(const Friction& law, const Touch& touch, const Reaction& r, ContactEvent event) {
  if (!is_held(law, touch, event)) return false;
  switch (event) {
    case ContactEvent::slip_begins:
      return r.friction_S.norm() > law.mu * r.normal;
    case ContactEvent::rolling_begins:
      return horizontal(r.moment_S).norm() > law.rolling * r.normal;
    default:
      return std::abs(r.moment_S.z()) > law.boring * r.normal;
  }
}

// The touch with that let go, in the direction in which it is pushed by the reaction r.
Touch without(const ContactStepper& stepper,
              Touch touch,
              double t,
              const OnTable& now,
              const Reaction& r,
              ContactEvent event) {
  switch (event) {
    case ContactEvent::slip_begins:
      touch.sticks = false;
      touch.slip_S = -r.friction_S.normalized();
      touch.slip_S = reaction_of(stepper.model(), touch, t, now.moving).slip_direction_S;
      break;
    case ContactEvent::rolling_begins:
      touch.keeps_from_rolling = false;
      touch.roll_S = -horizontal(r.moment_S).normalized();
      touch.roll_S = reaction_of(stepper.model(), touch, t, now.moving).roll_direction_S;
      break;
    default:
      touch.keeps_from_boring = false;
      touch.bore = -std::copysign(1.0, r.moment_S.z());
  }
  return touch;
}

// What one way of touching lets go and another, `held`, did not.
struct Freed {
  bool slips, rolls, bores;
};
Freed freed_since(const Touch& held, const Touch& touch) {
  return {held.sticks && !touch.sticks,
          held.keeps_from_rolling && !touch.keeps_from_rolling,
          held.keeps_from_boring && !touch.keeps_from_boring};
}

// All choices of at least one of so many things, as bits; those of fewer first.
std::vector<unsigned> choices_of(std::size_t count) {
  std::vector<unsigned> all;
  for (unsigned which = 1; which < 1U << count; ++which)
    all.push_back(which);
  std::stable_sort(all.begin(), all.end(), [](unsigned a, unsigned b) {
    return std::popcount(a) < std::popcount(b);
  });
  return all;
}

// What the laws let go, and in which directions, of what they hold while the body is at rest there.
class LettingGo {
 public:
  LettingGo(const ContactStepper& stepper, double t, const OnTable& now)
      : stepper_(stepper), law_(stepper.model().table->friction), t_(t), now_(now) {}

  // `given_way`: what an event has just found at its limit.
  Touch from(Touch touch, const ContactEvent* given_way) const {
    if (given_way != nullptr && is_held(law_, touch, *given_way))
      touch = without(stepper_, touch, t_, now_, reaction(touch), *given_way);
    Touch found = one_by_one(touch);
    if (goes_on(touch, found)) return found;
    return any_that_goes_on(touch).value_or(found);
  }

 private:
  static constexpr std::array<ContactEvent, 3> kHolds = {
      ContactEvent::boring_begins, ContactEvent::rolling_begins, ContactEvent::slip_begins};

  Reaction reaction(const Touch& touch) const {
    return reaction_of(stepper_.model(), touch, t_, now_.moving);
  }

  std::vector<ContactEvent> over(const Touch& touch, const Reaction& r) const {
    std::vector<ContactEvent> all;
    for (const ContactEvent event : kHolds)
      if (gives_way(law_, touch, r, event)) all.push_back(event);
    return all;
  }

  // The touch without some of these, in the directions in which its reaction r pushes them.
  Touch freed(Touch touch,
              const Reaction& r,
              const std::vector<ContactEvent>& events,
              unsigned which) const {
    for (std::size_t k = 0; k < events.size(); ++k)
      if ((which >> k) & 1U) touch = without(stepper_, touch, t_, now_, r, events[k]);
    return touch;
  }

  // Without the fewest of what needs too much that spare the others, or all of it.
  Touch one_by_one(Touch touch) const {
    for (std::size_t i = 0; i < kHolds.size(); ++i) {
      const Touch held = touch;
      const Reaction r = reaction(held);
      const std::vector<ContactEvent> too_much = over(held, r);
      if (too_much.empty()) break;
      for (const unsigned which : choices_of(too_much.size())) {
        touch = freed(held, r, too_much, which);
        if (over(touch, reaction(touch)).empty()) return touch;
      }
    }
    return touch;
  }

  // Whether what is held can be held, and what `touch` lets go and `held` did not grows.
  bool goes_on(const Touch& held, const Touch& touch) const {
    const Reaction r = reaction(touch);
    if (!over(touch, r).empty()) return false;
    const Vec3& inverse = stepper_.model().inverse_moments;
    const Vec3 rate_S = now_.moving.q * Vec3(inverse.cwiseProduct(r.momentum_rate_P));
    const auto [slips, rolls, bores] = freed_since(held, touch);
    return !(slips && r.slip_rate_S.dot(touch.slip_S) < 0.0) &&
           !(rolls && rate_S.dot(touch.roll_S) < 0.0) && !(bores && rate_S.z() * touch.bore < 0.0);
  }

  // Each of what is held changes what the others need, also which way they go.
  std::optional<Touch> any_that_goes_on(const Touch& held) const {
    const Reaction r = reaction(held);
    std::vector<ContactEvent> holds;
    for (const ContactEvent event : kHolds)
      if (is_held(law_, held, event)) holds.push_back(event);
    for (const unsigned which : choices_of(holds.size())) {
      if (std::optional<Touch> one = attempt(held, r, holds, which, false)) return one;
      const bool bores = (which & 1U) != 0 && holds.front() == ContactEvent::boring_begins;
      if (!bores) continue;
      if (std::optional<Touch> one = attempt(held, r, holds, which, true)) return one;
    }
    return {};
  }

  // The touch without these, if they grow and the rest is held. other_way: turning about the
  // vertical begins against its push.
  std::optional<Touch> attempt(const Touch& held,
                               const Reaction& r,
                               const std::vector<ContactEvent>& events,
                               unsigned which,
                               bool other_way) const {
    try {
      Touch touch = freed(held, r, events, which);
      if (other_way) touch.bore = -touch.bore;
      touch = settled(held, touch);
      if (goes_on(held, touch)) return touch;
    } catch (const Error& error) {
      if (error.fault() != Fault::check_failed) throw;  // the body jams
    }
    return {};
  }

  // with the directions in which a slip and a rotation begin together
  Touch settled(const Touch& held, Touch touch) const {
    constexpr int kMost = 50;
    constexpr double kSettled = 1e-12;
    const Freed begins = freed_since(held, touch);
    for (int i = 0; i < kMost; ++i) {
      const Reaction r = reaction(touch);
      const Touch before = touch;
      if (begins.slips) touch.slip_S = r.slip_direction_S;
      if (begins.rolls) touch.roll_S = r.roll_direction_S;
      if ((touch.slip_S - before.slip_S).norm() + (touch.roll_S - before.roll_S).norm() < kSettled)
        break;
    }
    return touch;
  }

  const ContactStepper& stepper_;
  const Friction& law_;
  double t_;
  const OnTable& now_;
};

}  // namespace

Touch let_go(const ContactStepper& stepper,
             const Touch& touch,
             double t,
             const OnTable& now,
             const ContactEvent* given_way) {
  return LettingGo(stepper, t, now).from(touch, given_way);
}

}  // namespace polhode
