// SPDX-License-Identifier: MIT
// How many motions a second one core computes, each by itself and in convoys: bare steps, motions
// that are refined and judged as those of an ensemble are, and motions of a Poincaré section. The
// two take turns; of their ratio the median counts. A timing is a benchmark, never a test.
#include <algorithm>
#include <ctime>
#include <functional>
#include <vector>

#include <fmt/format.h>

#include "base/system/parallel.h"
#include "chart/section.h"
#include "motion/convoy.h"
#include "motion/ensemble.h"
#include "motion/grid_trajectory.h"
#include "motion/scales.h"
#include "motion/simulate.h"
#include "motion/walk.h"

namespace polhode::bench {
namespace {

constexpr int kRounds = 9;

// a brick that hangs by a corner, as in scenes/chaos_spreads.toml
BodyModel brick() {
  BodySpec body;
  SolidSpec& solid = body.solid.emplace();
  solid.kind = "box";
  solid.size = Vec3(0.24, 0.115, 0.07);
  solid.density = 1800.0;
  body.pivot = Vec3(0.12, 0.0575, 0.035);
  return make_model(body, true, Vec3(0, 0, -9.80665));  // m/s^2
}

MotionSpec many_bricks() {
  MotionSpec motion;
  motion.hold = "pivot";
  motion.duration = 16.0;
  motion.attitude.zxz = Vec3(20, 100, 30) * kPi / 180.0;
  motion.spin.body = Vec3(6, 12, -4);
  motion.ensemble = EnsembleSpec{};
  motion.ensemble->members = 64;
  motion.ensemble->tilt = 0.2 * kPi / 180.0;
  return motion;
}

double processor_seconds(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// `alone` and `together` compute `count` motions
void compare(const std::string& what,
             int count,
             const std::function<void()>& alone,
             const std::function<void()>& together) {
  std::vector<double> ratios, rates;
  for (int i = 0; i < kRounds; ++i) {
    const double one = processor_seconds(alone), other = processor_seconds(together);
    ratios.push_back(one / other);
    rates.push_back(count / other);
  }
  std::sort(ratios.begin(), ratios.end());
  std::sort(rates.begin(), rates.end());
  fmt::print("{:<52} {:6.2f} ({:.2f} to {:.2f}), {:.0f} motions/s together\n",
             what,
             ratios[kRounds / 2],
             ratios.front(),
             ratios.back(),
             rates[kRounds / 2]);
}

// steps of one tolerance, and the same with all states kept and the drift watched
void bare_runs(const BodyModel& model, const std::vector<State>& starts, double duration) {
  constexpr double kTolerance = 1e-9;
  const StepperInfo& method = find_stepper("dop853");
  const std::unique_ptr<Stepper> stepper =
      method.make(model, momentum_scale(model, starts.front()));
  const auto walk = [&](long i) {
    State s = starts[static_cast<std::size_t>(i)];
    const double first = first_step(model, s, kTolerance, method.order);
    walk_adaptive(
        method, *stepper, s, duration, kTolerance, first, {}, [](double, const State&) {});
  };
  const auto keep = [&](long i) {
    integrate_adaptive(method, model, starts[static_cast<std::size_t>(i)], duration, kTolerance);
  };
  const auto count = static_cast<long>(starts.size());
  compare(
      "steps of dop853, tolerance 1e-9",
      static_cast<int>(count),
      [&] { parallel_for(count, 1, walk); },
      [&] { parallel_in_convoys(count, 1, walk); });
  compare(
      "the same, with states kept and drift watched",
      static_cast<int>(count),
      [&] { parallel_for(count, 1, keep); },
      [&] { parallel_in_convoys(count, 1, keep); });
}

// members of an ensemble, refined and judged: each by the method that is cheapest for it
void ensembles(const BodyModel& model, const MotionSpec& motion, double accuracy_rad) {
  const std::vector<MotionSpec> members = ensemble_of(model, motion);
  const auto count = static_cast<long>(members.size());
  const auto solve = [&](long i) {
    simulate(model, members[static_cast<std::size_t>(i)], NumericsSpec{}, accuracy_rad);
  };
  compare(
      fmt::format("ensemble within {:g} rad, {:g} s", accuracy_rad, motion.duration),
      static_cast<int>(count),
      [&] { parallel_for(count, 1, solve); },
      [&] { simulate_ensemble(model, members, NumericsSpec{}, accuracy_rad, 1); });
}

void sections(const BodyModel& model, const State& start) {
  const SectionSurface surface(model, start);
  std::vector<State> starts;
  for (const Vec2& at : surface.spread(32))
    starts.push_back(surface.state_at(at.x(), at.y()).value());
  const auto trace = [&](long i) {
    trace_section(surface, starts[static_cast<std::size_t>(i)], 100);
  };
  compare(
      "section, 100 crossings",
      32,
      [&] { parallel_for(32, 1, trace); },
      [&] { parallel_in_convoys(32, 1, trace); });
}

}  // namespace
}  // namespace polhode::bench

int main() {
  using namespace polhode;
  const BodyModel model = bench::brick();
  MotionSpec motion = bench::many_bricks();
  std::vector<State> starts;
  for (const MotionSpec& member : ensemble_of(model, motion))
    starts.push_back(start_state(model, member));
  fmt::print("motions in convoys, speed over that of motions alone\n");
  bench::bare_runs(model, starts, motion.duration);
  for (const double accuracy_rad : {1e-3, 1e-4}) {
    bench::ensembles(model, motion, accuracy_rad);
  }
  motion.duration = 4.0;
  bench::ensembles(model, motion, 1e-6);
  bench::sections(model, starts.front());
  return 0;
}
