// SPDX-License-Identifier: MIT
#include "motion/grid_trajectory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/system/interrupt.h"
#include "motion/deviation.h"
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

// A list of states, of which only the numbers that the model has are kept.
class KeptStates {
 public:
  explicit KeptStates(const BodyModel& model)
      : width_(model.loads.gimbals      ? 19
               : model.with_translation ? 13
                                        : 7) {}

  void reserve(long count) { numbers_.reserve(static_cast<std::size_t>(count) * width_); }
  long size() const { return static_cast<long>(numbers_.size() / width_); }

  void push_back(const State& s) {
    const auto add = [this](const auto& vector) {
      numbers_.insert(numbers_.end(), vector.data(), vector.data() + vector.size());
    };
    add(s.q.coeffs());
    add(s.y);
    if (width_ >= 13) {
      add(s.place_S);
      add(s.linear_momentum_S);
    }
    if (width_ < 19) return;
    add(s.rings.angles);
    add(s.rings.rates);
  }

  State operator[](long index) const {
    const double* from = numbers_.data() + static_cast<std::size_t>(index) * width_;
    const auto three = [from](int first) -> Vec3 {
      return Eigen::Map<const Vec3>(from + first);
    };
    State s;
    s.q.coeffs() = Eigen::Map<const Eigen::Vector4d>(from);
    s.y = three(4);
    if (width_ >= 13) {
      s.place_S = three(7);
      s.linear_momentum_S = three(10);
    }
    if (width_ == 19) s.rings = {three(13), three(16)};
    return s;
  }

  // leaves every second
  void thin_out() {
    const auto width = static_cast<std::ptrdiff_t>(width_);
    auto to = numbers_.begin();
    for (auto from = to; from < numbers_.end(); from += std::min(2 * width, numbers_.end() - from))
      to = std::copy(from, from + width, to);
    numbers_.erase(to, numbers_.end());
  }

 private:
  std::size_t width_;  // numbers of a state
  std::vector<double> numbers_;
};

// Grid times t_0 = 0 < t_1 < ... ; the state at every `stride`-th of them.
class GridTrajectory final : public Trajectory {
 public:
  GridTrajectory(const StepperInfo& method, const BodyModel& model, const State& start)
      : stepper(method.make(model, momentum_scale(model, start))),
        inverse_moments(model.inverse_moments),
        states(model) {
    states.push_back(start);
  }

  // uniform grids store no times
  double time(long index) const {
    return times.empty() ? static_cast<double>(index) * h : times[static_cast<std::size_t>(index)];
  }

  State at(double t) const override {
    const long index = last_grid_time(t);
    State s = grid_state(index);
    if (time(index) != t)
      stepper->part_of_step(time(index), t - time(index), step_length(index), s);
    return s;
  }

  std::vector<State> at_each(const std::vector<double>& asked) const override {
    std::vector<State> found;
    std::vector<Leap> leaps;
    found.reserve(asked.size());
    leaps.reserve(asked.size());
    long index = 0;
    for (const double t : asked) {
      index = last_grid_time(t, index);
      found.push_back(grid_state(index));
      if (time(index) != t)
        leaps.push_back({time(index), t - time(index), step_length(index), &found.back()});
    }
    stepper->leap(leaps.data(), static_cast<int>(leaps.size()));
    return found;
  }

  // even grids would meet a motion always in the same phases
  std::vector<double> kept_times(const std::vector<double>& asked) const override {
    if (times.empty()) return asked;
    std::vector<double> kept(asked.size());
    long index = 0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      index = last_time_until(asked[i], index);
      kept[i] = time(last_kept(index));
    }
    return kept;
  }
  std::vector<double> busy_times(std::size_t count) const override {
    std::vector<double> grid, speeds;
    for (long i = 0; i < states.size(); ++i) {
      grid.push_back(time(i * stride));
      speeds.push_back(inverse_moments.cwiseProduct(states[i].y).norm());
    }
    return busy_times_of(grid, speeds, count);
  }
  long last_kept(long index) const { return std::min(index / stride, states.size() - 1) * stride; }

  // the index of the last grid time not after t, which may be near another
  long last_grid_time(double t, std::optional<long> near = {}) const {
    if (!times.empty()) return last_time_until(t, near);
    const long index = std::clamp(static_cast<long>(std::floor(t / h)), 0L, last);
    return time(index) > t && index > 0 ? index - 1 : index;
  }

  // from the last kept state, the grid is walked as it was walked before
  State grid_state(long index) const {
    const long kept = last_kept(index);
    State s = states[kept / stride];
    for (long i = kept; i < index; ++i)
      stepper->step(time(i), step_length(i), s);
    return s;
  }

  // Of an adaptive grid: a guess, by default that steps are even, and steps from it that grow.
  long last_time_until(double t, std::optional<long> near = {}) const {
    const long guess =
        near.value_or(static_cast<long>(t / times.back() * static_cast<double>(last)));
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
    if (states.size() <= 2 * kMostKeptStates) return;
    states.thin_out();
    stride *= 2;
  }

  // the very step that the integration took, so that walking again gives the same bits
  double step_length(long i) const {
    return times.empty() ? h : time(std::min(i + 1, last)) - time(i);
  }

  std::unique_ptr<Stepper> stepper;
  Vec3 inverse_moments;
  double h = 0.0;
  long last = 0;  // index of the last grid time
  long stride = 1;
  std::vector<double> times;  // adaptive grids only
  KeptStates states;
};

// Drift within steps is more than at their ends where these are long.
void look_within(const GridTrajectory& grid, double duration, DriftWatch& drift) {
  constexpr int kFewSteps = 64;
  if (grid.last >= kFewSteps) return;
  for (const State& s : grid.at_each(scattered_times(duration, kFewSteps)))
    drift.look_at(s);
}

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
  auto grid = std::make_shared<GridTrajectory>(method, model, start);
  grid->h = h;
  grid->last = static_cast<long>(steps);
  grid->stride = std::max(1L, (grid->last + kMostKeptStates - 1) / kMostKeptStates);
  grid->states.reserve(grid->last / grid->stride + 1);

  DriftWatch drift(model, start);
  State s = start;
  drift.look_at(s);
  const WalkRecord walk =
      walk_fixed(*grid->stepper, s, h, grid->last, [&](long i, const State& now) {
        if (i % kStepsBetweenLooks == 0) look_up(effort, static_cast<double>(i) * h / duration);
        refuse_nan(now, method, grid->time(i));
        if (i % grid->stride == 0) grid->states.push_back(now);
        drift.look_at(now);
      });
  // the partial step to the end; a motion that is shorter than a step has no other to be told by
  State end = s;
  if (grid->last > 0) {
    end = grid->at(duration);
  } else {
    grid->stepper->step_within(0.0, duration, h, end);
  }
  refuse_nan(end, method, duration);
  drift.look_at(end);
  look_within(*grid, duration, drift);
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
  auto grid = std::make_shared<GridTrajectory>(method, model, start);
  DriftWatch drift(model, start);
  State s = start;
  const long likely = std::min(effort.likely_steps, kMostKeptStates);
  grid->times.reserve(static_cast<std::size_t>(likely));
  grid->states.reserve(likely);
  grid->times.push_back(0.0);
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
  look_within(*grid, duration, drift);
  return {grid, {walk.steps, walk.rejected, walk.work.evaluations, drift.worst(), {}}};
}

}  // namespace polhode
