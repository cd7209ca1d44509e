// SPDX-License-Identifier: MIT
// What a step and an evaluation cost. A timing is a benchmark, never a test.
#include <benchmark/benchmark.h>

#include "math/so3.h"
#include "motion/exact/exact.h"
#include "motion/stepper_table.h"
#include "support/motions.h"
#include "support/on_table.h"
#include "support/tops.h"

namespace polhode {
namespace {

// one step of each method on the free asymmetric body I = (1, 2, 3), omega = (0.3, 1, 0.2)
void step(benchmark::State& run, const StepperInfo& method) {
  BodySpec body;
  body.moments = Vec3(1, 2, 3);
  const BodyModel model = make_model(body, false, Vec3::Zero());
  State state;
  state.y = Vec3(0.3, 2.0, 0.6);
  state.q = turn_between(state.y, Vec3::UnitZ());  // away from the poles of angles
  const std::unique_ptr<Stepper> stepper = method.make(model, state.y.norm());
  for (auto _ : run) {
    stepper->step(0.0, 0.01, state);
    benchmark::DoNotOptimize(state);
  }
}

// one random-access evaluation of a closed form
void exact(benchmark::State& run, const test::Problem& problem, const char* model) {
  std::unique_ptr<Trajectory> trajectory;
  for (const SolutionMethod& row : solution_methods()) {
    if (row.name == model) trajectory = row.make(problem.model, problem.start);
  }
  double t = 0.0;
  for (auto _ : run) {
    t += 0.37;
    benchmark::DoNotOptimize(trajectory->at(t));
  }
}

test::Problem symmetric_top() {
  const BodyModel model = make_model(test::prolate_body(), false, Vec3::Zero());
  return {model, start_state(model, test::wobbling())};
}

// a coin that rolls in a circle and wobbles, scenes/rolling_coin.toml
MotionSpec rolling_coin() {
  MotionSpec spec = test::on_table(6.0, test::rolling());
  spec.attitude.zxz = Vec3(0, 80.0 * kPi / 180.0, 0);
  spec.spin.rates = Vec3(3, 0, 30);
  return spec;
}

// its whole motion by steps
void rolls(benchmark::State& run) {
  for (auto _ : run)
    benchmark::DoNotOptimize(
        test::integrated(test::disc_body(0.0125, 0.008), rolling_coin(), 1e-9));
}

// one state of it
void rolls_at(benchmark::State& run) {
  const Integration coin = test::integrated(test::disc_body(0.0125, 0.008), rolling_coin(), 1e-9);
  double t = 0.0;
  for (auto _ : run) {
    t = std::fmod(t + 0.37, 6.0);
    benchmark::DoNotOptimize(coin.trajectory->at(t));
  }
}

// What its quadrature evaluates at each point: the spins are combinations of two of Gauss's series
// in sin(tilt / 2)^2 (Appell; Korteweg 1899). For a uniform disc both coefficients are real:
// n (n + 1) + 4/3 over (n + 1)^2 from one term to the next.
void gauss_series(benchmark::State& run) {
  const auto series = [](double x) {
    double sum = 1.0, term = 1.0;
    for (int n = 0; std::abs(term) > 1e-16 * sum; ++n) {
      const double next = n + 1.0;
      term *= (n * next + 4.0 / 3.0) / (next * next) * x;
      sum += term;
    }
    return sum;
  };
  double tilt = 0.4;
  for (auto _ : run) {
    tilt = 0.4 + std::fmod(tilt, 1.0);
    const double half = std::sin(0.5 * tilt);
    benchmark::DoNotOptimize(series(half * half) + series(1.0 - half * half));
  }
}

}  // namespace
}  // namespace polhode

int main(int argc, char** argv) {
  for (const polhode::StepperInfo& method : polhode::stepper_table()) {
    if (method.only_table) continue;
    benchmark::RegisterBenchmark(("step/" + method.name).c_str(),
                                 [&method](benchmark::State& run) { polhode::step(run, method); });
  }
  const auto add = [](const char* name, const polhode::test::Problem& problem) {
    benchmark::RegisterBenchmark(
        (std::string("exact/") + name).c_str(),
        [=](benchmark::State& run) { polhode::exact(run, problem, name); });
  };
  add("symmetric", polhode::symmetric_top());
  add("asymmetric", polhode::test::hairer_vilmart());
  add("heavy_symmetric", polhode::test::gni_heavy_top());
  benchmark::RegisterBenchmark("table/rolling_coin_of_6_s", polhode::rolls);
  benchmark::RegisterBenchmark("table/rolling_coin_at_t", polhode::rolls_at);
  benchmark::RegisterBenchmark("table/gauss_series", polhode::gauss_series);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
