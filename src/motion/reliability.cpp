// SPDX-License-Identifier: MIT
#include "motion/reliability.h"

#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/deviation.h"
#include "motion/solution_method.h"
#include "motion/step_limit.h"
#include "motion/stepper_table.h"

namespace polhode {
namespace {

constexpr int kTimesCompared = 256;

}  // namespace

std::vector<std::string> doubts_of_drift(const BodyModel& model, const Drift& drift) {
  std::vector<std::string> doubts;
  const auto watch = [&](const std::optional<double>& worst, const char* what) {
    if (!worst || *worst <= kTrustedDrift) return;
    doubts.push_back(std::isfinite(*worst)
                         ? fmt::format("{} drifts by {:.2g} of itself", what, *worst)
                         : fmt::format("{} drifts without end", what));
  };
  watch(drift.energy, "energy");
  watch(drift.momentum,
        model.table                       ? "what the table conserves"
        : model.chi_P.squaredNorm() > 0.0 ? "L about the vertical"
                                          : "L");
  return doubts;
}

Reliability reliability_of(const BodyModel& model,
                           const State& start,
                           double duration,
                           double accuracy_rad,
                           const Integration& found) {
  Reliability result;
  result.doubts = doubts_of_drift(model, found.record.drift);
  if (found.record.left_out_rad > accuracy_rad) {
    result.doubts.push_back(fmt::format(
        "a face comes down on the table, where the body is taken to lie still; it would "
        "move on by about {:.1g} rad, and the scene allows {:.2g}",
        found.record.left_out_rad,
        accuracy_rad));
  }
  for (const SolutionMethod& row : solution_methods()) {
    if (!row.closed_form || model.with_translation || !row.why_not(model).empty()) continue;
    const std::unique_ptr<Trajectory> truth = row.make(model, start);
    const double worst =
        largest_deviation(model,
                          *found.trajectory,
                          *truth,
                          times_to_compare(model, *found.trajectory, duration, kTimesCompared));
    result.attitude_error_rad = worst;
    if (!(worst <= accuracy_rad)) {
      result.doubts.push_back(
          fmt::format("the attitude is off by up to {:.2g} rad, and the scene allows {:.2g}",
                      worst,
                      accuracy_rad));
    }
    break;
  }
  return result;
}

std::optional<std::string> step_beyond_limit(const BodyModel& model,
                                             const State& start,
                                             const NumericsSpec& numerics) {
  if (!numerics.step) return {};
  for (const StepperInfo& row : stepper_table()) {
    if (row.name != numerics.method) continue;
    const double limit = step_limit(row, model, start);
    if (*numerics.step <= limit) return {};
    return fmt::format("a step of {:.3g} s is beyond {:.3g} s, where {} ends on this motion ({})",
                       *numerics.step,
                       limit,
                       row.name,
                       row.limit);
  }
  return {};
}

std::optional<std::string> turns_backwards(double fastest_rad_per_s, double frame_s) {
  const double turn = fastest_rad_per_s * frame_s;
  if (!(turn > kPi)) return {};
  return fmt::format(
      "the body turns by {:.0f} degrees from frame to frame, so that the eye sees it slower or "
      "backwards",
      turn * 180.0 / kPi);
}

}  // namespace polhode
