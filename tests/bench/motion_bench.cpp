// SPDX-License-Identifier: MIT
// What a step and an evaluation cost. A timing is a benchmark, never a test.
#include <benchmark/benchmark.h>

#include "math/so3.h"
#include "motion/exact/exact.h"
#include "motion/stepper_table.h"
#include "support/motions.h"
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
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
