// SPDX-License-Identifier: MIT
#include "chart/reference_solution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "motion/conditioning.h"
#include "motion/deviation.h"
#include "motion/refinement.h"
#include "motion/scales.h"
#include "motion/solution_method.h"
#include "motion/stepper_table.h"

namespace polhode {
namespace {

constexpr int kTimes = 65;
constexpr double kHopeless = 0.05;  // rad; two runs further apart than this prove nothing

const SolutionMethod* closed_form_of(const BodyModel& model) {
  for (const SolutionMethod& row : solution_methods()) {
    if (row.closed_form && row.why_not(model).empty()) return &row;
  }
  return nullptr;
}

// the most accurate run of a method that double precision gives: its last refinement that still
// changes the answer by more than round-off does
std::vector<State> finest(const StepperInfo& method,
                          const BodyModel& model,
                          const State& start,
                          double duration,
                          const std::vector<double>& times) {
  const double rate = typical_rate(model, start) + 1.0 / duration;
  // well below where truncation and round-off meet for these orders
  constexpr double kTurn = 0.05;
  constexpr double kTolerance = 1e-15;
  const double h = duration / std::ceil(duration * rate / kTurn);
  const Integration run =
      integrate_with(method, model, start, duration, method.adaptive ? kTolerance : h);
  std::vector<State> states;
  states.reserve(times.size());
  for (const double t : times)
    states.push_back(run.trajectory->at(t));
  return states;
}

}  // namespace

ReferenceSolution::ReferenceSolution(const BodyModel& model, const State& start, double duration)
    : model_(model), duration_(duration) {
  for (int i = 0; i < kTimes; ++i)
    times_.push_back(duration * i / (kTimes - 1));
  if (closed_form_of(model) != nullptr) {
    by_closed_form(start);
  } else if (model.table) {
    by_two_tolerances(start);
  } else {
    by_two_methods(start);
  }
}

void ReferenceSolution::by_closed_form(const State& start) {
  const SolutionMethod& row = *closed_form_of(model_);
  source_ = "closed form (" + row.name + ")";
  const std::unique_ptr<Trajectory> truth = row.make(model_, start);
  for (const double t : times_)
    states_.push_back(truth->at(t));
  // measured against a 19-digit reference: round-off of the phases
  uncertainty_ = 4e-16 * (10.0 + typical_rate(model_, start) * duration_);
  // near a separatrix the closed form answers a start that has been rounded
  const Conditioning conditioning =
      conditioning_of_closed_form(row, model_, start, *truth, duration_, kHopeless);
  uncertainty_ = std::max(uncertainty_, conditioning.effect);
  if (!conditioning.exceeds_limit) return;
  source_ = "nobody: one rounding of the start moves the closed form by more than 0.05 rad";
  uncertainty_ = std::numeric_limits<double>::infinity();
}

void ReferenceSolution::by_two_tolerances(const State& start) {
  constexpr double kTolerance = 1e-12, kLooser = 1e-10;
  const StepperInfo& method = find_stepper("dop853");
  source_ = method.name + " from event to event, at two tolerances";
  try {
    const Integration fine = integrate_with(method, model_, start, duration_, kTolerance);
    const Integration loose = integrate_with(method, model_, start, duration_, kLooser);
    for (const double t : times_) {
      states_.push_back(fine.trajectory->at(t));
      const double apart = deviation(model_, states_.back(), loose.trajectory->at(t));
      if (!(apart <= uncertainty_)) uncertainty_ = apart;
    }
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    states_.assign(times_.size(), start);
    uncertainty_ = std::numeric_limits<double>::infinity();
  }
  if (uncertainty_ <= kHopeless) return;
  source_ = "nobody: " + method.name + " does not agree with itself at two tolerances";
  uncertainty_ = std::numeric_limits<double>::infinity();
}

void ReferenceSolution::by_two_methods(const State& start) {
  // of different kinds, so that they do not err together
  const StepperInfo& one = find_stepper("dop853");
  const StepperInfo& splitting = find_stepper("kick_srkn11");
  const StepperInfo& other =
      why_not(splitting, model_).empty() ? splitting : find_stepper("gauss6");
  source_ = one.name + " and " + other.name + " agree";
  try {
    states_ = finest(one, model_, start, duration_, times_);
    const std::vector<State> second = finest(other, model_, start, duration_, times_);
    for (std::size_t i = 0; i < times_.size(); ++i) {
      const double apart = deviation(model_, states_[i], second[i]);
      if (!(apart <= uncertainty_)) uncertainty_ = apart;
    }
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    states_.assign(times_.size(), start);  // of no use, but there
    uncertainty_ = std::numeric_limits<double>::infinity();
  }
  if (uncertainty_ <= kHopeless) return;
  source_ =
      "nobody: there is no closed form, and " + one.name + " and " + other.name + " do not agree";
  uncertainty_ = std::numeric_limits<double>::infinity();
}

double ReferenceSolution::error_at_end(const State& end) const {
  return deviation(model_, end, states_.back());
}

double ReferenceSolution::error_of(const Trajectory& run) const {
  double worst = 0.0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const double error = deviation(model_, run.at(times_[i]), states_[i]);
    if (!(error <= worst)) worst = error;
    if (std::isnan(worst)) return worst;
  }
  return worst;
}

}  // namespace polhode
