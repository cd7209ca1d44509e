// SPDX-License-Identifier: MIT
#include "motion/method_costs.h"

#include <algorithm>
#include <cmath>

#include "motion/stepper_table.h"

namespace polhode {

ProblemKind problem_kind(const BodyModel& model) {
  if (model.with_translation) return ProblemKind::six;
  if (model.loads.turn_body()) return ProblemKind::loaded;
  if (model.chi_P.squaredNorm() == 0.0) return ProblemKind::free;
  return center_on_symmetry_axis(model) ? ProblemKind::top : ProblemKind::heavy;
}

const std::vector<MethodCost>& method_costs() {
  using enum ProblemKind;
  static const std::vector<MethodCost> table = {
#include "motion/method_costs.inc"
  };
  return table;
}

std::vector<MethodCost> cheapest_methods(const BodyModel& model,
                                         const NumericsSpec& numerics,
                                         double accuracy_rad,
                                         bool splittings_only) {
  const ProblemKind kind = problem_kind(model);
  // the coarsest accuracy measured that is good enough, else the finest
  double measured = 0.0;
  double finest = 1.0;
  for (const MethodCost& row : method_costs()) {
    if (row.kind != kind) continue;
    finest = std::min(finest, row.accuracy_rad);
    if (row.accuracy_rad <= accuracy_rad * (1.0 + 1e-9))
      measured = std::max(measured, row.accuracy_rad);
  }
  if (measured == 0.0) measured = finest;
  std::vector<MethodCost> able;
  for (const MethodCost& row : method_costs()) {
    if (row.kind != kind || row.accuracy_rad != measured) continue;
    const StepperInfo& method = find_stepper(row.method);
    // one step of it is the closed form, and integrates nothing
    if (method.exact_when_free && kind == ProblemKind::free) continue;
    if ((splittings_only && !method.symplectic) || !why_not(method, model).empty()) continue;
    able.push_back(row);
  }
  const auto uses_no = [&](const MethodCost& row) {
    const bool adaptive = find_stepper(row.method).adaptive;
    return adaptive ? numerics.step.has_value() : numerics.tolerance.has_value();
  };
  if (!std::all_of(able.begin(), able.end(), uses_no)) std::erase_if(able, uses_no);
  std::stable_sort(able.begin(), able.end(), [](const MethodCost& a, const MethodCost& b) {
    return a.ns_per_rad < b.ns_per_rad;
  });
  return able;
}

}  // namespace polhode
