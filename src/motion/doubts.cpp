// SPDX-License-Identifier: MIT
#include "motion/doubts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/units.h"
#include "motion/deviation.h"
#include "motion/scales.h"

namespace polhode {
namespace {

constexpr double kRounding = 0x1p-53;
// by how many roundings the rates in closed forms may be off; measured: up to 1.5
constexpr double kRoundingsOfRates = 3.0;
constexpr int kTimesCompared = 257;

std::string may_move(std::string_view what, double turn, double accuracy_rad) {
  return fmt::format("{} may move the attitude by {:.2g} rad, and the scene allows {:.2g}",
                     what,
                     turn,
                     accuracy_rad);
}

std::optional<std::string> doubt_if_much(std::string_view what, double turn, double accuracy_rad) {
  if (!(turn > accuracy_rad)) return {};
  return may_move(what, std::min(turn, kPi), accuracy_rad);
}

}  // namespace

std::optional<std::string> doubt_of_conditioning(const Conditioning& found,
                                                 bool closed_form,
                                                 double accuracy_rad) {
  if (!found.exceeds_limit) return {};
  const char* what = closed_form ? "one rounding of the start" : "round-off";
  return fmt::format(
      "{} (reached at {:.4g} s): the motion is chaotic, close to a separatrix, or turns too often "
      "for that",
      may_move(what, found.effect, accuracy_rad),
      found.exceeded_at);
}

std::optional<std::string> doubt_of_length(double rate,
                                           double duration,
                                           double accuracy_rad,
                                           Conditioning& found) {
  const double per_second = kRoundingsOfRates * kRounding * rate;
  found.effect = std::max(found.effect, per_second * duration);
  if (!(per_second * duration > accuracy_rad)) return {};
  const double since = accuracy_rad / per_second;
  found.exceeded_at = found.exceeds_limit ? std::min(found.exceeded_at, since) : since;
  found.exceeds_limit = true;
  return fmt::format(
      "{} (reached at {:.4g} s): so many turns are too long for numbers of 16 digits",
      may_move("rounding", per_second * duration, accuracy_rad),
      since);
}

std::optional<std::string> doubt_of_kind(const BodyModel& model,
                                         const State& start,
                                         double duration,
                                         double accuracy_rad) {
  return doubt_if_much("two moments of inertia count as equal; what they differ by",
                       turn_left_out(model, start, duration, true),
                       accuracy_rad);
}

std::optional<std::string> doubt_of_arms(const BodyModel& model,
                                         const State& start,
                                         double duration,
                                         double accuracy_rad) {
  return doubt_if_much(
      "the centre of mass, or where a force acts, is as near to what the body turns about as "
      "round-off tells; what is left",
      turn_by_arms_left_out(model, start, duration),
      accuracy_rad);
}

std::optional<std::string> doubt_of_switches(const BodyModel& model,
                                             double duration,
                                             double accuracy_rad) {
  constexpr double kFewDigits = 16.0;
  double turn = 0.0;
  for (const Load& load : model.loads.turning) {
    const bool is_torque = load.kind == Load::Kind::torque;
    const bool is_force = load.kind == Load::Kind::force || load.kind == Load::Kind::couple;
    if (load.acts.always() || !(is_torque || is_force)) continue;
    const Switching& acts = load.acts;
    const double last = std::isfinite(acts.until) ? acts.until + acts.ramp : acts.from + acts.ramp;
    const double digit = std::numeric_limits<double>::epsilon() * std::abs(last);
    const double length = acts.until - acts.from;
    const double off = acts.ramp > 0.0 ? 2.0 * digit : length < kFewDigits * digit ? length : 0.0;
    const double strength = load.vector.norm();
    const double torque = strength * (is_torque ? 1.0 : load.arm_P.norm());
    const double left = duration - std::clamp(acts.from, 0.0, duration);
    turn += off * torque * model.inverse_moments.maxCoeff() * left;
    // places count in radii of gyration, as in deviation()
    if (load.kind == Load::Kind::force && model.with_translation)
      turn += off * strength * left / std::sqrt(model.moments.maxCoeff() * model.body.mass);
  }
  return doubt_if_much("the times at which loads begin and end have 16 digits, of which the last",
                       turn,
                       accuracy_rad);
}

std::optional<std::string> doubt_of_body(const BodyModel& model,
                                         const MotionSpec& motion,
                                         const State& start,
                                         const Trajectory& found,
                                         const Solve& solve,
                                         double one_rounding,
                                         double accuracy_rad) {
  const double arm = (model.body.center - model.pivot_B).norm();
  double part = model.moments_off * model.inverse_moments.maxCoeff();
  if (!model.chi_P.isZero(0.0)) part = std::max(part, model.lever_off / arm);
  if (part == 0.0) return {};
  constexpr double kGrowth = 100.0;  // of what most motions do to it
  const double turn = typical_turn(model, start, motion.duration) + 1.0;
  if (kGrowth * part * turn < accuracy_rad && part / kRounding * one_rounding < accuracy_rad)
    return {};
  try {
    const BodyModel other = moved_by_rounding(model);
    const double moved =
        largest_deviation(model,
                          found,
                          *solve(other, start_state(other, motion)),
                          times_to_compare(model, found, motion.duration, kTimesCompared));
    return doubt_if_much(
        "round-off of the moments of inertia and of the centre of mass, as they follow from the "
        "body,",
        std::isnan(moved) ? kPi : moved,
        accuracy_rad);
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    return "it could not be held against a body that round-off has changed: " + error.message();
  }
}

}  // namespace polhode
