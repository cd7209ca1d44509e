// SPDX-License-Identifier: MIT
#include "motion/grid_trajectory.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/interrupt.h"

namespace polhode {
namespace {

constexpr long kMostKeptStates = 100'000;
constexpr long kStepsBetweenInterruptChecks = 4096;

// Grid times t_0 = 0 < t_1 < ... ; the state at every `stride`-th of them.
class GridTrajectory final : public Trajectory {
 public:
  GridTrajectory(const StepperInfo& method, const Model& model, double scale)
      : method_(method), model_(model), scale_(scale) {}

  // uniform grids store no times
  double time(long index) const {
    return times.empty() ? static_cast<double>(index) * h : times[static_cast<std::size_t>(index)];
  }

  State at(double t) const override {
    // last grid time not after t, then the last kept state not after that
    long index = 0;
    if (times.empty()) {
      index = std::clamp(static_cast<long>(std::floor(t / h)), 0L, last);
      if (time(index) > t && index > 0) --index;
    } else {
      index = std::upper_bound(times.begin(), times.end(), t) - times.begin() - 1;
      index = std::clamp(index, 0L, last);
    }
    const long kept = std::min(index / stride, static_cast<long>(states.size()) - 1);

    // walk the grid as it was walked before, then take the partial step
    State s = states[static_cast<std::size_t>(kept)];
    const long walk_from = kept * stride;
    if (walk_from == index && time(index) == t) return s;
    const std::unique_ptr<Stepper> stepper = method_.make(model_, scale_);
    for (long i = walk_from; i < index; ++i)
      stepper->step(time(i), step_length(i), s);
    const double rest = t - time(index);
    if (rest != 0.0) stepper->step(time(index), rest, s);
    return s;
  }

  // the very step that the integration took, so that walking again gives the same bits
  double step_length(long i) const { return times.empty() ? h : time(i + 1) - time(i); }

  double h = 0.0;
  long last = 0;  // index of the last grid time
  long stride = 1;
  std::vector<double> times;  // adaptive grids only
  std::vector<State> states;

 private:
  const StepperInfo& method_;
  Model model_;
  double scale_;
};

bool finite(const State& s) {
  return s.q.coeffs().allFinite() && s.y.allFinite() && s.place_S.allFinite() &&
         s.impulse_S.allFinite();
}

void refuse_nan(const State& s, const StepperInfo& method, double t) {
  if (finite(s)) return;
  throw Error(
      Fault::check_failed,
      fmt::format("the motion is not a number at t = {:.6g} s with method {}; take a smaller "
                  "step or another method",
                  t,
                  method.name));
}

double least_moment(const Model& model) {
  return (model.moments.array() > 0.0).select(model.moments, model.moments.maxCoeff()).minCoeff();
}

// how fast a load makes a body at rest swing, 1/s; 0 for damping
double driven_rate(const Model& model, const Load& load) {
  const double arm = load.arm_P.norm();
  const double torque = load.vector.norm() * (load.kind == Load::Kind::torque ? 1.0 : arm);
  const double least = least_moment(model);
  return std::sqrt(torque / least) +
         std::sqrt(load.k * (1.0 / model.body.mass + arm * arm / least));
}

}  // namespace

double typical_rate(const Model& model, const State& start) {
  const double least = least_moment(model);
  double rate = angular_velocity(model, start.y).norm() + std::sqrt(model.chi_P.norm() / least);
  for (const Load& load : model.loads.turning) {
    const double damping = load.kind == Load::Kind::damp_spin ? load.c / least : load.c;
    rate += driven_rate(model, load) + std::abs(load.rate) + damping;
  }
  return rate;
}

double momentum_scale(const Model& model, const State& start) {
  // what the body has, or what drives it will give it: a start almost at rest is no scale
  const double most = model.moments.maxCoeff();
  double scale = std::max(start.y.norm(), std::sqrt(most * model.chi_P.norm()));
  for (const Load& load : model.loads.turning)
    scale = std::max(scale, most * driven_rate(model, load));
  return scale > 0.0 ? scale : 1.0;
}

Integration integrate_fixed(
    const StepperInfo& method, const Model& model, const State& start, double duration, double h) {
  CHECK(h > 0.0 && duration > 0.0);
  // grid times inside [0, duration]; what is left is a partial step at the time of asking
  const double steps = std::floor(duration / h * (1.0 + 1e-12));
  if (steps > static_cast<double>(kMostSteps)) {
    throw input_error("{} s in steps of {} s are {:.3g} steps; at most {} are allowed",
                      duration,
                      h,
                      steps,
                      kMostSteps);
  }
  const double scale = momentum_scale(model, start);
  auto grid = std::make_shared<GridTrajectory>(method, model, scale);
  grid->h = h;
  grid->last = static_cast<long>(steps);
  grid->stride = std::max(1L, (grid->last + kMostKeptStates - 1) / kMostKeptStates);

  const std::unique_ptr<Stepper> stepper = method.make(model, scale);
  DriftWatch drift(model, start);
  State s = start;
  for (long i = 0;; ++i) {
    if (i % grid->stride == 0) grid->states.push_back(s);
    drift.look_at(s);
    if (i == grid->last) break;
    if (i % kStepsBetweenInterruptChecks == 0) stop_if_interrupted();
    stepper->step(grid->time(i), h, s);
    refuse_nan(s, method, grid->time(i + 1));
  }
  return {grid, {grid->last, 0, stepper->evaluations(), drift.worst()}};
}

Integration integrate_adaptive(const StepperInfo& method,
                               const Model& model,
                               const State& start,
                               double duration,
                               double tolerance) {
  CHECK(method.adaptive && tolerance > 0.0);
  if (tolerance < kLeastTolerance) {
    throw input_error("a tolerance of {} is below the round-off of a step; ask for at least {}",
                      tolerance,
                      kLeastTolerance);
  }
  const double scale = momentum_scale(model, start);
  auto grid = std::make_shared<GridTrajectory>(method, model, scale);
  const std::unique_ptr<Stepper> stepper = method.make(model, scale);
  DriftWatch drift(model, start);
  IntegrationRecord record;

  // a first step that turns the body, or swings it, by a hundredth of a radian
  const double rate = typical_rate(model, start);
  double h = rate > 0.0 ? std::min(duration, 0.01 / rate) : duration;
  double t = 0.0;
  State s = start;
  grid->times.push_back(0.0);
  grid->states.push_back(s);
  while (t < duration) {
    if (record.steps % kStepsBetweenInterruptChecks == 0) stop_if_interrupted();
    const double next = t + h < duration ? t + h : duration;
    State trial = s;
    const double error = stepper->step_with_error(t, next - t, trial);

    // standard controller: aim at 0.9^order of the tolerance, never jump by more than five
    const double ratio = std::pow(tolerance / std::max(error, 1e-300), 1.0 / method.order);
    if (!(error <= tolerance)) {
      ++record.rejected;
      h = (next - t) * std::clamp(0.9 * ratio, 0.1, 0.9);
      if (!std::isfinite(h) || t + h == t) {
        refuse_nan(trial, method, next);
        throw Error(Fault::check_failed,
                    fmt::format("{} cannot reach tolerance {} at t = {:.6g} s: its step fell to "
                                "round-off; ask for a larger tolerance",
                                method.name,
                                tolerance,
                                t));
      }
      continue;
    }
    refuse_nan(trial, method, next);
    h = (next - t) * std::clamp(0.9 * ratio, 0.2, 5.0);
    t = next;
    s = trial;
    drift.look_at(s);
    grid->times.push_back(t);
    grid->states.push_back(s);
    if (++record.steps > kMostSteps / 8) {
      throw input_error(
          "{} needs more than {} steps at tolerance {:.3g} for {} s; take a shorter "
          "motion, a slower one or a looser accuracy",
          method.name,
          kMostSteps / 8,
          tolerance,
          duration);
    }
  }
  grid->last = static_cast<long>(grid->times.size()) - 1;
  record.evaluations = stepper->evaluations();
  record.drift = drift.worst();
  return {grid, record};
}

}  // namespace polhode
