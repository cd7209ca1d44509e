// SPDX-License-Identifier: MIT
#include "motion/refinement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "motion/contact/contact_step.h"
#include "motion/contact/contact_trajectory.h"
#include "motion/deviation.h"
#include "motion/scales.h"
#include "motion/walk.h"

namespace polhode {
namespace {

constexpr int kTimesOfRuns = 256;
constexpr double kLeastToleranceRefined = 1e-15;
// differences that fall this many times faster or slower than the order demands are not believed
constexpr double kFromOrder = 4.0;
constexpr double kSafety = 2.0;
// of the accuracy: round-off, which no order reduces, keeps two runs further apart than this
constexpr double kClearlyLess = 0.25;
// distance of the neighbour that shows how errors grow: well above round-off
constexpr double kNudge = 1e-13;
// The round-off of n steps does as much as this many roundings of the start, times the root of n:
// measured on 150 random heavy bodies and ten methods, nine of ten stay below it for the methods
// that are chosen by themselves.
constexpr double kRoundingsPerRootOfSteps = 8.0;
// of a difference: where round-off does no more, finer runs will come closer
constexpr double kOfRoundOff = 0.01;
// A run on a table that is too coarse may come to an end that the motion does not have, such as an
// edge that comes down. It is believed when so many runs in a row, each finer, come to an end.
constexpr int kRunsStopped = 3;

// How runs of one method at increasing fineness approach each other.
class Convergence {
 public:
  // drop: the factor by which the error falls from run to run, by the order of the method
  explicit Convergence(double drop) : drop_(drop) {}

  void add(double difference) {
    before_ = last_;
    last_ = difference;
  }

  // Whether the last run may be believed to be within `accuracy`: the differences fall as the order
  // demands, or two of them in a row are clearly below the accuracy.
  bool is_within(double accuracy) const {
    const double clearly = kClearlyLess * accuracy;
    if (!before_ || !(error() <= accuracy) || !(*last_ <= clearly)) return false;
    return *before_ <= clearly || *last_ * drop_ <= kFromOrder * *before_;
  }

  // Estimated error of the last of at least three runs. With errors that fall by 1/r from run to
  // run, it is r/(1-r) times the difference from the run before. Two runs may agree by chance while
  // both are wrong, so that the last difference counts for no less than the one before it and the
  // order allow.
  double error() const {
    const double believed = std::max(*last_, *before_ / (kFromOrder * drop_));
    const double ratio = std::max(1.0 / drop_, believed / *before_);
    if (ratio < 0.5) return kSafety * believed * ratio / (1.0 - ratio);
    return kSafety * std::max(*last_, *before_);  // round-off: no order is left
  }

  // Whether the runs came close to each other and then no closer.
  bool stalls() const {
    constexpr double kClose = 0.1;  // rad
    return before_ && *before_ < kClose && *last_ >= 0.8 * *before_;
  }
  double last() const { return last_.value_or(0.0); }
  // the best accuracy of which is_within() could be told of at least three runs
  double best_shown() const { return std::max(error(), *last_ / kClearlyLess); }

 private:
  double drop_;
  std::optional<double> before_, last_;
};

// The runs of one refinement.
class Runs {
 public:
  Runs(const StepperInfo& method,
       const BodyModel& model,
       const State& start,
       double duration,
       long most_steps,
       const SimulationWatch& watch)
      : method_(method),
        model_(model),
        start_(start),
        duration_(duration),
        most_steps_(most_steps),
        watch_(watch) {}

  Integration integrate(double fineness) { return integrate_from(start_, fineness); }

  // The same, or the first finer run that does not come to an end; `fineness` becomes that of it.
  Integration integrate_or_finer(double& fineness) {
    for (int stopped = 1;; ++stopped, fineness /= kTolerancesApart) {
      try {
        return integrate(fineness);
      } catch (const Error& error) {
        const bool may_be_too_coarse = model_.table && method_.adaptive &&
                                       error.fault() == Fault::check_failed &&
                                       fineness / kTolerancesApart >= kLeastToleranceRefined;
        if (!may_be_too_coarse || stopped == kRunsStopped) throw;
      }
    }
  }

  double difference(const Integration& coarse, const Integration& fine, unsigned round) const {
    const std::vector<double> times =
        cheap_times(*coarse.trajectory,
                    times_to_compare(model_, *coarse.trajectory, duration_, kTimesOfRuns, round));
    return largest_deviation(model_, *coarse.trajectory, *fine.trajectory, times);
  }

  // what round-off does in `steps` steps, by how a neighbour parts from `motion` of this fineness
  Conditioning round_off(const Integration& motion, double fineness, long steps, double accuracy) {
    return conditioning_of(
        model_,
        *motion.trajectory,
        duration_,
        one_neighbour_of(model_, start_, kNudge),
        kRoundingsPerRootOfSteps * std::sqrt(steps),
        accuracy,
        [&](const State& from) { return integrate_from(from, fineness).trajectory; });
  }

 private:
  Integration integrate_from(const State& from, double fineness) {
    ++run_;
    Effort effort{most_steps_, likely_steps_};
    if (watch_) {
      effort.watch = [&](double part) {
        watch_(run_, part);
      };
    }
    Integration found = integrate_with(method_, model_, from, duration_, fineness, effort);
    // a finer run takes so many more, and a little
    const double more = 1.1 * std::pow(kTolerancesApart, 1.0 / method_.order);
    likely_steps_ = static_cast<long>(more * static_cast<double>(found.record.steps));
    return found;
  }

  const StepperInfo& method_;
  const BodyModel& model_;
  const State& start_;
  double duration_;
  long most_steps_;
  const SimulationWatch& watch_;
  int run_ = 0;
  long likely_steps_ = 0;
};

}  // namespace

Integration integrate_with(const StepperInfo& method,
                           const BodyModel& model,
                           const State& start,
                           double duration,
                           double fineness,
                           const Effort& effort) {
  if (model.table && method.adaptive)
    return integrate_on_table(method, model, start, duration, fineness, effort);
  if (model.table) {
    Integration run = integrate_fixed(method, model, start, duration, fineness, effort);
    // what the table takes is not known
    if (!model.table->friction.keeps_energy()) run.record.drift.energy.reset();
    return run;
  }
  return method.adaptive ? integrate_adaptive(method, model, start, duration, fineness, effort)
                         : integrate_fixed(method, model, start, duration, fineness, effort);
}

Refined refine(const StepperInfo& method,
               const BodyModel& model,
               const State& start,
               double duration,
               double accuracy,
               long most_steps,
               const SimulationWatch& watch,
               std::optional<double> likely) {
  const double rate = typical_rate(model, start) + 1.0 / duration;
  // no explicit method takes longer steps: what is hopeless is refused before it begins
  constexpr double kLongestStep = 3.0;  // rad
  const double least_steps = (typical_turn(model, start, duration) + 1.0) / kLongestStep;
  if (!method.stiff && least_steps > static_cast<double>(most_steps))
    throw too_many_steps(method, duration, least_steps, most_steps);
  const double finer = method.adaptive ? 1.0 / kTolerancesApart : 0.5;
  double fineness = method.adaptive
                        ? accuracy
                        : std::min(0.1 * std::max(1.0, 0.5 * method.order) / rate, duration);
  if (likely) fineness = *likely / (finer * finer);
  // slips on a table are told from rest by a power of the tolerance
  const double power = model.table && method.adaptive ? kPowerOfStopped : 1.0;
  const double drop = method.adaptive ? std::pow(kTolerancesApart, power) : std::exp2(method.order);
  Convergence convergence(drop);
  Runs runs(method, model, start, duration, most_steps, watch);
  const Error out_of_reach = input_error(
      "{} cannot reach an attitude accuracy of {:.3g} rad over {} s in double precision; give "
      "a tolerance yourself, a looser accuracy, or another method",
      method.name,
      accuracy,
      duration);
  const auto run = [&] {
    try {
      return runs.integrate_or_finer(fineness);
    } catch (const StepTooSmall&) {
      throw out_of_reach;
    }
  };
  Integration coarse = run();
  int stalled = 0;
  for (unsigned round = 0;; ++round) {
    fineness *= finer;
    if (method.adaptive && fineness < kLeastToleranceRefined) throw out_of_reach;
    const double wanted = fineness;
    Integration fine = run();
    if (fineness != wanted) {
      // a run between the two was no motion: the coarser one shows nothing, either
      convergence = Convergence(drop);
      coarse = std::move(fine);
      continue;
    }
    convergence.add(runs.difference(coarse, fine, round));
    stalled = convergence.stalls() ? stalled + 1 : 0;
    const bool is_within = convergence.is_within(accuracy);
    if (is_within || stalled == 2) {
      // the coarser run shows as well how neighbours part
      const Conditioning round_off =
          runs.round_off(coarse, fineness / finer, fine.record.steps, accuracy);
      if (is_within) {
        const double total = std::max(convergence.error(), round_off.effect);
        return {std::move(fine), fineness, total, round_off};
      }
      // runs that are still too coarse for a chaotic motion may seem to stall too
      if (!(round_off.effect <= kOfRoundOff * convergence.last())) {
        throw input_error(
            "round-off grows so much in this motion that runs of {} over {} s show an accuracy of "
            "{:.2g} rad at best, and {:.3g} rad are asked for; take a shorter duration or a looser "
            "accuracy",
            method.name,
            duration,
            convergence.best_shown(),
            accuracy);
      }
      stalled = 0;
    }
    coarse = std::move(fine);
  }
}

}  // namespace polhode
