// SPDX-License-Identifier: MIT
// Measures what each method costs on motions of each kind and prints src/motion/method_costs.inc:
//   cmake --build --preset release --target method_costs
//   build/release/tests/method_costs > src/motion/method_costs.inc
#include "motion/method_costs.h"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "chart/work_precision.h"
#include "motion/scales.h"
#include "motion/solution_method.h"
#include "motion/stepper_table.h"
#include "support/loads.h"
#include "support/tops.h"

namespace polhode {
namespace {

constexpr double kAccuracies[] = {1e-2, 1e-4, 1e-6, 1e-8, 1e-10};
constexpr double kTurned_rad = 100.0;  // over each motion
constexpr const char* kKindNames[] = {"free", "top", "heavy", "loaded", "six"};

WorkProblem problem(const BodyModel& model, const State& start) {
  return {model, start, kTurned_rad / typical_rate(model, start)};
}

// two of each kind that are unlike each other
std::vector<WorkProblem> problems() {
  const Quat tilted = exp_rotation({0.4, 0.9, -0.3});
  std::vector<WorkProblem> all;
  const auto add = [&](const BodyModel& model, const Vec3& y) {
    State start;
    start.q = tilted;
    start.y = y;
    all.push_back(problem(model, start));
  };
  add(test::free_body({1, 2, 3}), {0.3, 2.0, 0.6});
  add(test::free_body({0.6, 0.8, 1.0}), {1.8, 0.4, -0.9});
  add(test::heavy_body({1, 1, 0.5}, 2.0 * Vec3::UnitZ()), {0.2, 0.1, 4.0});
  add(test::heavy_body({0.5, 0.5, 1.0}, Vec3::UnitZ()), {0.2, 1.0, 0.4});
  add(test::heavy_body({0.6, 0.8, 1.0}, {0.3, -0.5, 0.7}), {1.0, 0.4, -0.9});
  add(test::heavy_body({1, 2, 2.5}, {0.4, 0.2, 0.3}), {0.5, 3.0, 4.0});
  const auto add_loaded = [&](const Vec3& moments, const std::vector<LoadSpec>& loads) {
    MotionSpec spec = test::spun({0.7, 1.9, 1.1});
    spec.torque = loads;
    const BodyModel model = with_needed_degrees(make_model(test::body_with(moments), spec));
    all.push_back(problem(model, start_state(model, spec)));
  };
  LoadSpec constant = test::load("constant");
  constant.body = Vec3(0.3, -0.2, 0.4);
  LoadSpec swinging = constant;
  swinging.rate = 3.0;
  LoadSpec damping = test::load("damping");
  damping.c = 0.02;
  add_loaded({1, 1.3, 1.6}, {swinging});
  add_loaded({0.6, 0.8, 1.0}, {constant, damping});
  LoadSpec spring = test::load("spring");
  spring.at = Vec3(0.4, 0.1, 0.2);
  spring.to = Vec3(0, 0, 2);
  spring.k = 3.0;
  add_loaded({1, 1.3, 1.6}, {spring});
  spring.k = 0.5;
  add_loaded({0.3, 0.5, 0.6}, {spring});
  return all;
}

}  // namespace
}  // namespace polhode

int main() {
  using namespace polhode;
  // sums of logarithms of costs, and how many
  std::map<std::tuple<int, std::size_t, std::string>, std::pair<double, int>> costs;
  std::map<int, int> problems_of_kind;
  for (const WorkProblem& p : problems()) {
    const int kind = static_cast<int>(problem_kind(p.model));
    ++problems_of_kind[kind];
    const ReferenceSolution reference(p.model, p.start, p.duration);
    for (const StepperInfo& method : stepper_table()) {
      if (!why_not(method, p.model).empty()) continue;
      const std::vector<WorkPoint> points = work_precision(method, p, reference);
      for (std::size_t i = 0; i < std::size(kAccuracies); ++i) {
        const WorkPoint* best = cheapest(points, kAccuracies[i]);
        if (best == nullptr) continue;
        auto& [sum, count] = costs[{kind, i, method.name}];
        sum += std::log(1e3 * best->time_us / kTurned_rad);
        ++count;
      }
    }
  }
  fmt::print(
      "// Written by tests/bench/method_costs.cpp: kind, attitude error in rad, method, ns per "
      "radian turned.\n");
  for (const auto& [key, cost] : costs) {
    const auto& [kind, accuracy, method] = key;
    if (cost.second < problems_of_kind[kind]) continue;  // not on all of them
    fmt::print("{{{}, {:g}, \"{}\", {:.3g}}},\n",
               kKindNames[kind],
               kAccuracies[accuracy],
               method,
               std::exp(cost.first / cost.second));
  }
  return 0;
}
