// SPDX-License-Identifier: MIT
#include "chart/stability.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/system/interrupt.h"
#include "base/units.h"
#include "math/so3.h"
#include "motion/deviation.h"
#include "motion/scales.h"
#include "motion/walk.h"

namespace polhode {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr double kKept = 1e-3;     // drift of what passes for fine where nobody knows the truth
constexpr double kChanged = 0.02;  // drift of energy that makes it the reason
constexpr double kBlownUp = 1e6;   // drift at which a run that blows up is left

constexpr std::array<const char*, kRunOutcomes> kNames = {"fine",
                                                          "phase_wrong",
                                                          "flips_wrongly",
                                                          "energy_grows",
                                                          "energy_decays",
                                                          "solver_failed",
                                                          "not_a_number",
                                                          "unchecked"};

// Which way the body points, as a number between -1 and 1: towards its centre of mass against the
// vertical, or for a free body its angular momentum along the axis that it is closest to at first.
class Pointing {
 public:
  Pointing(const BodyModel& model, const State& start) : model_(model) {
    start.y.cwiseAbs().maxCoeff(&axis_);
  }
  double of(const State& s) const {
    if (model_.chi_P.squaredNorm() > 0.0)
      return up_in_body(model_, s.q).dot(model_.chi_P) / model_.chi_P.norm();
    return s.y[axis_] / s.y.norm();
  }

 private:
  const BodyModel& model_;
  Eigen::Index axis_ = 0;
};

// the states at the times of the reference, one after the other, until `visit` returns false
template <class Visit>
void states_at(const std::vector<double>& times,
               const Stepper& stepper,
               State s,
               double h,
               const Visit& visit) {
  if (h > times.back()) {
    // its parts may have solutions where it has none
    State end = s;
    stepper.step_within(0.0, times.back(), h, end);
  }
  long i = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    for (; (static_cast<double>(i) + 1.0) * h <= times[k] * (1.0 + 1e-12); ++i)
      stepper.step(static_cast<double>(i) * h, h, s);
    stop_if_interrupted();
    State now = s;
    const double t = static_cast<double>(i) * h;
    if (times[k] - t > 1e-9 * h) stepper.part_of_step(t, times[k] - t, h, now);
    if (!visit(k, now)) return;
  }
}

RunOutcome outcome_of(const StabilityCell& cell, bool flipped, double allowed_rad) {
  const bool known = !std::isnan(cell.error_rad);
  if (!known && std::isnan(cell.energy_drift) && std::isnan(cell.momentum_drift))
    return RunOutcome::unchecked;
  const bool kept = !(std::abs(cell.energy_drift) > kKept) && !(cell.momentum_drift > kKept);
  if (known ? cell.error_rad <= allowed_rad : kept) return RunOutcome::fine;
  if (cell.energy_drift > kChanged) return RunOutcome::energy_grows;
  if (cell.energy_drift < -kChanged) return RunOutcome::energy_decays;
  return flipped ? RunOutcome::flips_wrongly : RunOutcome::phase_wrong;
}

}  // namespace

const char* name_of(RunOutcome outcome) {
  return kNames[static_cast<std::size_t>(outcome)];
}

std::optional<RunOutcome> find_run_outcome(const std::string& name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames[i]) return static_cast<RunOutcome>(i);
  }
  return {};
}

StabilityProblem::StabilityProblem(const BodyModel& m, const State& s, double T)
    : model(m), start(s), duration(T), reference(m, s, T) {}

StabilityCell try_method(const StepperInfo& method,
                         const StabilityProblem& problem,
                         double h,
                         double allowed_rad) {
  const BodyModel& model = problem.model;
  const std::unique_ptr<Stepper> stepper = method.make(model, momentum_scale(model, problem.start));
  const bool known = std::isfinite(problem.reference.uncertainty());
  const Pointing pointing(model, problem.start);
  DriftWatch drift(model, problem.start);
  const double energy_at_start = energy(model, problem.start);
  double last_energy = energy_at_start;
  double error = 0.0;
  bool flipped = false, nan = false, blown_up = false;
  StabilityCell cell;
  try {
    states_at(
        problem.reference.times(), *stepper, problem.start, h, [&](std::size_t k, const State& s) {
          if (!is_finite(s)) {
            nan = true;
            return false;
          }
          const State& truth = problem.reference.states()[k];
          // what a table really takes is no error
          ContactState contact;
          if (model.table && known) contact.work = energy(model, truth) - energy_at_start;
          drift.look_at(s, contact);
          last_energy = energy(model, s) - contact.work;
          error = std::max(error, deviation(model, s, truth));
          // on opposite sides, and both clearly
          constexpr double kClearly = 0.3;
          const double found = pointing.of(s), wanted = pointing.of(truth);
          flipped = flipped || (found * wanted < 0.0 && std::abs(found) > kClearly &&
                                std::abs(wanted) > kClearly &&
                                rotation_angle_between(s.q, truth.q) > 0.5 * kPi);
          blown_up = drift.worst().energy.value_or(0.0) > kBlownUp;
          return !blown_up;
        });
  } catch (const Error& failure) {
    if (failure.fault() == Fault::interrupted) throw;
    return {RunOutcome::solver_failed, kNoValue, kNoValue, kNoValue};
  }
  if (nan) return {RunOutcome::not_a_number, kNoValue, kNoValue, kNoValue};
  const double sign = last_energy < energy_at_start ? -1.0 : 1.0;
  cell.error_rad = known && !blown_up ? error : kNoValue;
  cell.energy_drift = sign * drift.worst().energy.value_or(kNoValue);
  cell.momentum_drift = drift.worst().momentum.value_or(kNoValue);
  cell.outcome =
      blown_up ? RunOutcome::energy_grows : outcome_of(cell, flipped && known, allowed_rad);
  return cell;
}

}  // namespace polhode
