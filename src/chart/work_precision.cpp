// SPDX-License-Identifier: MIT
#include "chart/work_precision.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/system/interrupt.h"
#include "motion/refinement.h"
#include "motion/scales.h"
#include "motion/walk.h"

namespace polhode {
namespace {

constexpr int kMostFailures = 12;  // in a row: finer steps do not help
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double seconds_of(const std::function<void()>& run, long repeats) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (long i = 0; i < repeats; ++i)
    run();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// the bare integration: nothing is kept of it but its end
State walk(const StepperInfo& method, const WorkProblem& problem, double fineness) {
  // from event to event there is no bare walk
  if (problem.model.table && method.adaptive) {
    return integrate_with(method, problem.model, problem.start, problem.duration, fineness)
        .trajectory->at(problem.duration);
  }
  const std::unique_ptr<Stepper> stepper =
      method.make(problem.model, momentum_scale(problem.model, problem.start));
  State s = problem.start;
  const auto look_away = [](auto, const State&) {
  };
  if (method.adaptive) {
    walk_adaptive(method,
                  *stepper,
                  s,
                  problem.duration,
                  fineness,
                  first_step(problem.model, problem.start, fineness, method.order),
                  problem.model.loads.switches,
                  look_away);
  } else {
    walk_fixed(*stepper, s, fineness, std::lround(problem.duration / fineness), look_away);
  }
  return s;
}

// one run, measured and timed
WorkPoint point(const StepperInfo& method,
                const WorkProblem& problem,
                const ReferenceSolution& reference,
                double fineness,
                const WorkOptions& options) {
  WorkPoint p{method.name, method.order, fineness, 0, kUnknown, kUnknown, kUnknown, kUnknown, ""};
  try {
    const Integration run =
        integrate_with(method, problem.model, problem.start, problem.duration, fineness);
    p.evaluations = run.record.evaluations;
    p.energy_drift = run.record.drift.energy.value_or(kUnknown);
    p.momentum_drift = run.record.drift.momentum.value_or(kUnknown);
    p.error_rad = options.judge_the_end_only
                      ? reference.error_at_end(run.trajectory->at(problem.duration))
                      : reference.error_of(*run.trajectory);
    p.time_us = median_time_us([&] { walk(method, problem, fineness); }, options.least_work_s);
  } catch (const Error& error) {
    if (error.fault() != Fault::check_failed) throw;
    const bool nan = error.message().find("not a number") != std::string::npos;
    p.status = nan ? "not_a_number" : "no_solution";
    return p;
  }
  if (std::isinf(reference.uncertainty())) {
    p.error_rad = kUnknown;
    p.status = "no_judge";
  } else {
    p.status = p.error_rad < reference.least_error() ? kPointBelowReference : kPointOk;
  }
  return p;
}

// steps from about two radians down, tolerances from a hundredth down; by what factor
struct Fineness {
  double first, factor;
};
Fineness range_of(const StepperInfo& method, const WorkProblem& problem) {
  if (method.adaptive) return {1e-2, 0.5};
  // one step for all
  if (method.exact_when_free && problem.model.chi_P.squaredNorm() == 0.0)
    return {problem.duration, 0.1};
  const double rate = typical_rate(problem.model, problem.start) + 1.0 / problem.duration;
  // errors of neighbours are about a factor of four to ten apart
  const double factor = method.order <= 1 ? 0.25 : method.order <= 2 ? 0.5 : std::sqrt(0.5);
  return {2.5 / rate, factor};
}

bool known(const WorkPoint& p) {
  return p.status == kPointOk || p.status == kPointBelowReference;
}

}  // namespace

double median_time_us(const std::function<void()>& run, double least_work_s) {
  // one run to warm up and to learn how many make a tenth of the work
  const double once = std::max(seconds_of(run, 1), 1e-9);
  const long repeats = std::max(1L, std::lround(0.1 * least_work_s / once));
  std::vector<double> times;
  for (double total = 0.0; total < least_work_s || times.size() < 3;) {
    const double seconds = seconds_of(run, repeats);
    total += seconds;
    times.push_back(seconds / static_cast<double>(repeats));
  }
  const auto middle = times.begin() + static_cast<long>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle * 1e6;
}

std::vector<WorkPoint> work_precision(const StepperInfo& method,
                                      const WorkProblem& problem,
                                      const ReferenceSolution& reference,
                                      const WorkOptions& options) {
  const Fineness range = range_of(method, problem);
  std::vector<WorkPoint> points;
  double best = std::numeric_limits<double>::infinity();
  int no_better = 0, failed = 0;
  double last_fineness = std::numeric_limits<double>::infinity();
  for (double fineness = range.first; no_better < 3; fineness *= range.factor) {
    stop_if_interrupted();
    if (method.adaptive && fineness < kLeastTolerance) break;
    // the end lies on the grid, and every grid is new
    const double exact =
        method.adaptive ? fineness : problem.duration / std::ceil(problem.duration / fineness);
    if (!(exact < last_fineness)) continue;
    last_fineness = exact;
    const WorkPoint& p = points.emplace_back(point(method, problem, reference, exact, options));
    options.after_point();
    const bool drawn = p.status == kPointOk;
    if (drawn && p.error_rad < 0.7 * best) {
      best = p.error_rad;
      no_better = 0;
    } else if (p.status == kPointBelowReference || (drawn && best < 1e-9)) {
      ++no_better;  // round-off: finer steps only cost
    }
    failed = std::isnan(p.time_us) ? failed + 1 : 0;
    if (p.time_us > 1e6 * options.most_run_s || failed > kMostFailures) break;
  }
  return points;
}

const WorkPoint* cheapest(const std::vector<WorkPoint>& points, double error_rad) {
  const WorkPoint* best = nullptr;
  for (const WorkPoint& p : points) {
    // no finer points were tried than those that the reference cannot judge
    if (p.status == kPointBelowReference && p.error_rad > error_rad) return nullptr;
    const bool good = known(p) && p.error_rad <= error_rad;
    if (good && (best == nullptr || p.time_us < best->time_us)) best = &p;
  }
  return best;
}

}  // namespace polhode
