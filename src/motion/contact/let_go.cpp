// SPDX-License-Identifier: MIT
#include "motion/contact/let_go.h"

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

  // Without what needs too much, or the fewest of it that spare the others.
  Touch one_by_one(Touch touch) const {
    for (std::size_t i = 0; i < kHolds.size(); ++i) {
      const Reaction r = reaction(touch);
      const std::vector<ContactEvent> too_much = over(touch, r);
      if (too_much.empty()) break;
      const auto freed = [&](unsigned which) {
        Touch one = touch;
        for (std::size_t k = 0; k < too_much.size(); ++k)
          if ((which >> k) & 1U) one = without(stepper_, one, t_, now_, r, too_much[k]);
        return one;
      };
      const unsigned all = (1U << too_much.size()) - 1U;
      for (int count = 1; count < static_cast<int>(too_much.size()); ++count) {
        for (unsigned which = 1; which < all; ++which) {
          if (std::popcount(which) != count) continue;
          Touch one = freed(which);
          if (over(one, reaction(one)).empty()) return one;
        }
      }
      touch = freed(all);
    }
    return touch;
  }

  // Whether what is held can be held, and what `touch` lets go and `held` did not grows.
  bool goes_on(const Touch& held, const Touch& touch) const {
    const BodyModel& model = stepper_.model();
    const Reaction r = reaction(touch);
    if (!over(touch, r).empty()) return false;
    const Vec3 rate_S = now_.moving.q * Vec3(model.inverse_moments.cwiseProduct(r.momentum_rate_P));
    const bool slips = held.sticks && !touch.sticks;
    const bool rolls = held.keeps_from_rolling && !touch.keeps_from_rolling;
    const bool bores = held.keeps_from_boring && !touch.keeps_from_boring;
    return !(slips && r.slip_rate_S.dot(touch.slip_S) < 0.0) &&
           !(rolls && rate_S.dot(touch.roll_S) < 0.0) && !(bores && rate_S.z() * touch.bore < 0.0);
  }

  // Each of what is held changes what the others need, also which way they go.
  std::optional<Touch> any_that_goes_on(const Touch& held) const {
    const Reaction r = reaction(held);
    std::vector<ContactEvent> holds;
    for (const ContactEvent event : kHolds)
      if (is_held(law_, held, event)) holds.push_back(event);
    for (int count = 0; count <= static_cast<int>(holds.size()); ++count) {
      for (unsigned which = 0; which < 1U << holds.size(); ++which) {
        if (std::popcount(which) != count) continue;
        for (const double way : {1.0, -1.0}) {
          try {
            Touch one = held;
            for (std::size_t k = 0; k < holds.size(); ++k)
              if ((which >> k) & 1U) one = without(stepper_, one, t_, now_, r, holds[k]);
            if (held.keeps_from_boring && !one.keeps_from_boring) one.bore *= way;
            one = settled(held, one);
            if (goes_on(held, one)) return one;
          } catch (const Error& error) {
            if (error.fault() != Fault::check_failed) throw;  // the body jams
          }
        }
      }
    }
    return {};
  }

  // with the directions in which a slip and a rotation begin together
  Touch settled(const Touch& held, Touch touch) const {
    constexpr int kMost = 50;
    constexpr double kSettled = 1e-12;
    const bool slips = held.sticks && !touch.sticks;
    const bool rolls = held.keeps_from_rolling && !touch.keeps_from_rolling;
    for (int i = 0; i < kMost; ++i) {
      const Reaction r = reaction(touch);
      const Touch before = touch;
      if (slips) touch.slip_S = r.slip_direction_S;
      if (rolls) touch.roll_S = r.roll_direction_S;
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
