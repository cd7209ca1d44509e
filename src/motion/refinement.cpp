// SPDX-License-Identifier: MIT
#include "motion/refinement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "motion/scales.h"

namespace polhode {
namespace {

constexpr int kTimesCompared = 257;
constexpr long kMostStepsRefined = 4'000'000;
constexpr double kLeastToleranceRefined = 1e-15;
constexpr double kTolerancesApart = 32.0;  // from run to run
// differences that fall this many times faster than the order demands are not believed
constexpr double kFasterThanOrder = 4.0;
constexpr double kSafety = 2.0;

// Largest deviation of two runs from each other: at the end, and at times that fill the motion
// evenly (multiples of the golden section), others for every `round`, on no run's grid.
double difference(
    const BodyModel& model, const Trajectory& a, const Trajectory& b, double duration, int round) {
  constexpr double kGoldenSection = 0.6180339887498949;
  double largest = deviation(model, a.at(duration), b.at(duration));
  for (int i = 1; i < kTimesCompared; ++i) {
    const double part = kGoldenSection * (i + kTimesCompared * round);
    const double t = duration * (part - std::floor(part));
    const double apart = deviation(model, a.at(t), b.at(t));
    if (!(apart <= largest)) largest = apart;
  }
  return largest;
}

// How runs of one method at increasing fineness approach each other.
class Convergence {
 public:
  // drop: the factor by which the error falls from run to run, by the order of the method
  explicit Convergence(double drop) : drop_(drop) {}

  void add(double difference) {
    before_ = last_;
    last_ = difference;
  }

  // Error of the last run; absent: too few runs.
  //
  // With errors that fall by 1/r from run to run, that of the last one is r/(1-r) times its
  // difference from the run before. Two runs may agree by chance while both are wrong, so that
  // the last difference counts for no less than the one before it and the order allow.
  std::optional<double> error() const {
    if (!before_) return std::nullopt;
    const double believed = std::max(*last_, *before_ / (kFasterThanOrder * drop_));
    const double ratio = std::max(1.0 / drop_, believed / *before_);
    if (ratio < 0.5) return kSafety * believed * ratio / (1.0 - ratio);
    return kSafety * std::max(*last_, *before_);  // round-off: no order is left
  }

  // Whether the runs came close to each other and then no closer.
  bool stalls() const {
    constexpr double kClose = 0.1;  // rad
    return before_ && *before_ < kClose && *last_ >= 0.5 * *before_;
  }
  double last() const { return last_.value_or(0.0); }

 private:
  double drop_;
  std::optional<double> before_, last_;
};

}  // namespace

Integration integrate_with(const StepperInfo& method,
                           const BodyModel& model,
                           const State& start,
                           double duration,
                           double fineness) {
  return method.adaptive ? integrate_adaptive(method, model, start, duration, fineness)
                         : integrate_fixed(method, model, start, duration, fineness);
}

Refined refine(const StepperInfo& method,
               const BodyModel& model,
               const State& start,
               double duration,
               double accuracy) {
  const double rate = typical_rate(model, start) + 1.0 / duration;
  const double finer = method.adaptive ? 1.0 / kTolerancesApart : 0.5;
  double fineness = method.adaptive
                        ? accuracy
                        : std::min(0.1 * std::max(1.0, 0.5 * method.order) / rate, duration);
  Convergence convergence(method.adaptive ? kTolerancesApart : std::exp2(method.order));
  Integration coarse = integrate_with(method, model, start, duration, fineness);
  int stalled = 0;
  for (int round = 0;; ++round) {
    fineness *= finer;
    const bool too_fine = method.adaptive ? fineness < kLeastToleranceRefined
                                          : duration / fineness > kMostStepsRefined;
    if (too_fine) {
      throw input_error(
          "{} cannot reach an attitude accuracy of {:.3g} rad over {} s with reasonable effort; "
          "give a step or tolerance yourself, a looser accuracy, or another method",
          method.name,
          accuracy,
          duration);
    }
    Integration fine = integrate_with(method, model, start, duration, fineness);
    convergence.add(difference(model, *coarse.trajectory, *fine.trajectory, duration, round));
    const std::optional<double> error = convergence.error();
    if (error && *error <= accuracy) return {std::move(fine), fineness, *error};
    stalled = convergence.stalls() ? stalled + 1 : 0;
    if (stalled == 2) {
      throw input_error(
          "round-off grows so much in this motion that runs of {} agree only within {:.2g} rad "
          "over {} s, and {:.3g} rad are asked for; take a shorter duration or a looser accuracy",
          method.name,
          convergence.last(),
          duration,
          accuracy);
    }
    coarse = std::move(fine);
  }
}

}  // namespace polhode
