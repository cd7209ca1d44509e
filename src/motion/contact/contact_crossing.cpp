// SPDX-License-Identifier: MIT
#include "motion/contact/contact_crossing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/bracketed_zero.h"

namespace polhode {
namespace {

constexpr int kMostHalvings = 60;
constexpr double kRoundingOfTime = 1e-16;  // relative
// Dips less deep than this part of the tolerance change nothing that the steps resolve.
constexpr double kShallow = 1e-2;
// The most values that are looked at for one margin of one step.
constexpr int kMostLooksAtMargin = 64;

// A margin after a part of a step, s.
struct MarginAfter {
  double part, value;
};

// Half the second derivative through three of them.
double curvature(const MarginAfter& a, const MarginAfter& b, const MarginAfter& c) {
  const double left = (b.value - a.value) / (b.part - a.part);
  const double right = (c.value - b.value) / (c.part - b.part);
  return std::abs(right - left) / (c.part - a.part);
}

// The first of the places i for which the margin may be below zero between place i and i + 1,
// where it is positive; by a parabola that is bent more than those through neighbours.
std::optional<std::size_t> first_that_may_dip(const std::vector<MarginAfter>& along,
                                              double shallow) {
  constexpr double kMoreBent = 3.0;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const auto& [from, at_from] = along[i];
    const auto& [to, at_to] = along[i + 1];
    if (at_from < -shallow || at_to <= 0.0) continue;
    double bent = 0.0;
    if (i > 0) bent = curvature(along[i - 1], along[i], along[i + 1]);
    if (i + 2 < along.size())
      bent = std::max(bent, curvature(along[i], along[i + 1], along[i + 2]));
    // the chord less sag u (1 - u), u from 0 to 1
    const double sag = kMoreBent * bent * (to - from) * (to - from);
    const double u = sag > 0.0 ? 0.5 * (sag - (at_to - at_from)) / sag : 0.0;
    if (!(u > 0.0 && u < 1.0)) continue;
    if (at_from + u * (at_to - at_from) - sag * u * (1.0 - u) < -shallow) return i;
  }
  return std::nullopt;
}

OnTable after(const ContactStepper& stepper, const TakenStep& step, double part) {
  if (!(part > 0.0)) return step.from;
  return stepper.step(step.touch, step.t, part, step.from, step.implicit).end;
}

Margins margins_after(const ContactStepper& stepper, const TakenStep& step, double part) {
  return stepper.margins(step.touch, step.t + part, after(stepper, step, part));
}

// The first part after which the margin is negative, and then positive again.
std::optional<double> first_dip(const std::vector<MarginAfter>& along, double shallow) {
  for (std::size_t i = 1; i + 1 < along.size(); ++i)
    if (along[i].value < -shallow && along[i + 1].value > 0.0) return along[i].part;
  return std::nullopt;
}

// As dip_within, of one margin; `seen` in order.
std::optional<double> dip_of(const ContactStepper& stepper,
                             const TakenStep& step,
                             std::size_t event,
                             const std::vector<MarginAfter>& seen,
                             double shallow) {
  if (!first_dip(seen, shallow) && !first_that_may_dip(seen, shallow)) return std::nullopt;
  std::vector<MarginAfter> along = {seen.back()};
  const auto look = [&](double part) {
    const auto place =
        std::lower_bound(along.begin(), along.end(), part, [](const MarginAfter& m, double p) {
          return m.part < p;
        });
    if (place != along.end() && place->part == part) return place->value;
    return along.insert(place, {part, margins_after(stepper, step, part)[event]})->value;
  };
  const auto lowest = std::min_element(
      seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  for (const double part : {0.0, 0.25 * step.h, 0.5 * step.h, 0.75 * step.h, lowest->part})
    look(part);
  if (const auto dip = first_dip(along, shallow)) return dip;
  for (int looks = 0; looks < kMostLooksAtMargin; ++looks) {
    const auto i = first_that_may_dip(along, shallow);
    if (!i) break;
    const double part = 0.5 * (along[*i].part + along[*i + 1].part);
    if (look(part) < -shallow) return part;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> dip_within(const ContactStepper& stepper,
                                 const TakenStep& step,
                                 MarginsSeen& seen) {
  const double shallow = std::max(kShallow * stepper.scales().tolerance, kNoiseOfMargins);
  std::stable_sort(
      seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  std::vector<MarginAfter> along;
  for (std::size_t event = 0; event < kContactEvents; ++event) {
    along.clear();
    for (const MarginsAt& one : seen) {
      const MarginAfter here{one.t - step.t, one.margins[event]};
      // of those at one time the last is the best
      if (!along.empty() && along.back().part == here.part) along.pop_back();
      along.push_back(here);
    }
    if (const auto dip = dip_of(stepper, step, event, along, shallow)) return dip;
  }
  return std::nullopt;
}

Crossing crossing_in(const ContactStepper& stepper, const TakenStep& step, double h) {
  const auto least_after = [&](double part) {
    return least_of(margins_after(stepper, step, part));
  };
  // a margin that begins at zero, such as the gap after lift-off, grows first
  Bracket found{0.0, h, least_after(0.0), least_after(h)};
  for (int i = 1; found.at_low <= kNoiseOfMargins && i <= kMostHalvings; ++i) {
    found.low = std::ldexp(h, -i);
    found.at_low = least_after(found.low);
  }
  const auto first_of = [](const Margins& margins) {
    const auto least = std::min_element(margins.begin(), margins.end());
    return static_cast<ContactEvent>(least - margins.begin());
  };
  // if it never grew, the event is now
  if (found.at_low <= 0.0) return {0.0, first_of(margins_after(stepper, step, h))};
  const double crossing = narrowed(found, kRoundingOfTime * step.t, least_after).high;
  return {crossing, first_of(margins_after(stepper, step, crossing))};
}

}  // namespace polhode
