// SPDX-License-Identifier: MIT
#include "motion/grid_trajectory.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/system/interrupt.h"
#include "motion/scales.h"
#include "motion/stepper_table.h"
#include "motion/walk.h"

namespace polhode {
namespace {

constexpr long kMostKeptStates = 100'000;
constexpr long kStepsBetweenLooks = 4096;

// from the work: is it still wanted, and who wants to know?
void look_up(const Effort& effort, double part) {
  stop_if_interrupted();
  if (effort.watch) effort.watch(part);
}

// Grid times t_0 = 0 < t_1 < ... ; the state at every `stride`-th of them.
class GridTrajectory final : public Trajectory {
 public:
  explicit GridTrajectory(std::unique_ptr<Stepper> method) : stepper(std::move(method)) {}

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
      index = last_time_until(t);
    }
    const long kept = std::min(index / stride, static_cast<long>(states.size()) - 1);

    // walk the grid as it was walked before, then take the partial step
    State s = states[static_cast<std::size_t>(kept)];
    const long walk_from = kept * stride;
    if (walk_from == index && time(index) == t) return s;
    for (long i = walk_from; i < index; ++i)
      stepper->step(time(i), step_length(i), s);
    const double rest = t - time(index);
    if (rest != 0.0) stepper->step(time(index), rest, s);
    return s;
  }

  // of an adaptive grid, whose steps are seldom far from even: a guess, and steps from it that grow
  long last_time_until(double t) const {
    const auto guess = static_cast<long>(t / times.back() * static_cast<double>(last));
    long low = std::clamp(guess, 0L, last), high = low + 1;
    for (long way = 1; low > 0 && time(low) > t; way *= 2) {
      high = low;
      low = std::max(0L, low - way);
    }
    for (long way = 1; high <= last && time(high) <= t; way *= 2) {
      low = high;
      high = std::min(last + 1, high + way);
    }
    const auto end = times.begin() + high;
    return std::max(low, std::upper_bound(times.begin() + low, end, t) - times.begin() - 1);
  }

  // Keeps the state after so many steps, if it is its turn; of too many states every second goes.
  void keep(long index, const State& s) {
    if (index % stride != 0) return;
    states.push_back(s);
    if (static_cast<long>(states.size()) <= 2 * kMostKeptStates) return;
    for (std::size_t i = 0; 2 * i < states.size(); ++i)
      states[i] = states[2 * i];
    states.resize((states.size() + 1) / 2);
    stride *= 2;
  }

  // the very step that the integration took, so that walking again gives the same bits
  double step_length(long i) const { return times.empty() ? h : time(i + 1) - time(i); }

  std::unique_ptr<Stepper> stepper;
  double h = 0.0;
  long last = 0;  // index of the last grid time
  long stride = 1;
  std::vector<double> times;  // adaptive grids only
  std::vector<State> states;
};

}  // namespace

Error too_many_steps(const StepperInfo& method, double duration, double needed, long most) {
  const long limit = method.adaptive ? kMostSteps / 8 : kMostSteps;
  return input_error(
      "{} needs at least about {:.2g} steps for {:.4g} s, and at most {:.2g} are taken; take a "
      "shorter or slower motion{}",
      method.name,
      needed,
      duration,
      static_cast<double>(most),
      most < limit ? ", or allow more with numerics.max_steps" : " or another method");
}

Integration integrate_fixed(const StepperInfo& method,
                            const BodyModel& model,
                            const State& start,
                            double duration,
                            double h,
                            const Effort& effort) {
  CHECK(h > 0.0 && duration > 0.0);
  // grid times inside [0, duration]; what is left is a partial step at the time of asking
  const double steps = std::floor(duration / h * (1.0 + 1e-12));
  const long most = std::min(effort.most_steps, kMostSteps);
  if (steps > static_cast<double>(most)) throw too_many_steps(method, duration, steps, most);
  auto grid = std::make_shared<GridTrajectory>(method.make(model, momentum_scale(model, start)));
  grid->h = h;
  grid->last = static_cast<long>(steps);
  grid->stride = std::max(1L, (grid->last + kMostKeptStates - 1) / kMostKeptStates);
  grid->states.reserve(static_cast<std::size_t>(grid->last / grid->stride + 1));

  DriftWatch drift(model, start);
  State s = start;
  drift.look_at(s);
  grid->states.push_back(s);
  const WalkRecord walk =
      walk_fixed(*grid->stepper, s, h, grid->last, [&](long i, const State& now) {
        if (i % kStepsBetweenLooks == 0) look_up(effort, static_cast<double>(i) * h / duration);
        refuse_nan(now, method, grid->time(i));
        if (i % grid->stride == 0) grid->states.push_back(now);
        drift.look_at(now);
      });
  // the partial step to the end
  const State end = grid->at(duration);
  refuse_nan(end, method, duration);
  drift.look_at(end);
  return {grid, {walk.steps, 0, walk.work.evaluations, drift.worst(), {}}};
}

Integration integrate_adaptive(const StepperInfo& method,
                               const BodyModel& model,
                               const State& start,
                               double duration,
                               double tolerance,
                               const Effort& effort) {
  CHECK(method.adaptive && tolerance > 0.0);
  if (tolerance < kLeastTolerance) {
    throw input_error("a tolerance of {} is below the round-off of a step; ask for at least {}",
                      tolerance,
                      kLeastTolerance);
  }
  const long most = std::min(effort.most_steps, kMostSteps / 8);
  auto grid = std::make_shared<GridTrajectory>(method.make(model, momentum_scale(model, start)));
  DriftWatch drift(model, start);
  State s = start;
  grid->times.push_back(0.0);
  grid->states.push_back(s);
  const WalkRecord walk = walk_adaptive(
      method,
      *grid->stepper,
      s,
      duration,
      tolerance,
      first_step(model, start, tolerance, method.order),
      model.loads.switches,
      [&](double t, const State& now) {
        drift.look_at(now);
        grid->times.push_back(t);
        const auto steps = static_cast<long>(grid->times.size()) - 1;
        grid->keep(steps, now);
        if (steps % kStepsBetweenLooks == 0) look_up(effort, t / duration);
        if (steps <= most) return;
        throw too_many_steps(method, duration, static_cast<double>(steps) * duration / t, most);
      });
  grid->last = static_cast<long>(grid->times.size()) - 1;
  return {grid, {walk.steps, walk.rejected, walk.work.evaluations, drift.worst(), {}}};
}

}  // namespace polhode
