// SPDX-License-Identifier: MIT
#include "motion/method_costs.h"

#include <set>

#include <gtest/gtest.h>

#include "motion/simulate.h"
#include "motion/stepper_table.h"
#include "support/loads.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

TEST(MethodCosts, EveryRowIsOfAMethodThatCanTakeItsKind) {
  std::set<std::tuple<ProblemKind, double, std::string>> seen;
  for (const MethodCost& row : method_costs()) {
    const StepperInfo& method = find_stepper(row.method);
    EXPECT_GT(row.ns_per_rad, 1.0) << row.method;
    EXPECT_LT(row.ns_per_rad, 1e8) << row.method;
    EXPECT_TRUE(seen.emplace(row.kind, row.accuracy_rad, row.method).second) << row.method;
    if (row.kind >= ProblemKind::loaded) {
      EXPECT_TRUE(method.takes_loads) << row.method;
    } else if (row.kind != ProblemKind::free) {
      EXPECT_TRUE(method.takes_heavy) << row.method;
    }
  }
  EXPECT_GT(seen.size(), 200U);
}

TEST(MethodCosts, KindsAreToldApart) {
  EXPECT_EQ(problem_kind(free_body({1, 2, 3})), ProblemKind::free);
  EXPECT_EQ(problem_kind(heavy_body({1, 1, 0.5}, Vec3::UnitZ())), ProblemKind::top);
  EXPECT_EQ(problem_kind(heavy_body({1, 1, 0.5}, Vec3::UnitX())), ProblemKind::heavy);
  EXPECT_EQ(problem_kind(heavy_body({1, 2, 2.5}, Vec3::UnitZ())), ProblemKind::heavy);
  MotionSpec spec = spun({1, 0, 0});
  spec.torque = {load("constant")};
  spec.torque[0].body = Vec3(0, 0, 0.1);
  EXPECT_EQ(problem_kind(make_model(body_with({1, 1.3, 1.6}), spec)), ProblemKind::loaded);
}

// whatever is asked, somebody answers, cheaper when less is asked, and splittings when asked for
TEST(MethodCosts, TheCheapestFirstAtEveryAccuracy) {
  MotionSpec spec = spun({1, 0, 0});
  spec.torque = {load("constant")};
  spec.torque[0].body = Vec3(0, 0, 0.1);
  for (const BodyModel& model : {free_body({1, 2, 3}),
                                 free_body({1, 1, 0}),
                                 heavy_body({1, 1, 0.5}, Vec3::UnitZ()),
                                 heavy_asymmetric().model,
                                 make_model(body_with({1, 1.3, 1.6}), spec)}) {
    double last = 0.0;
    for (const double accuracy : {1.0, 3e-3, 1e-4, 1e-7, 1e-10, 1e-13}) {
      const std::vector<MethodCost> able = cheapest_methods(model, {}, accuracy, false);
      ASSERT_FALSE(able.empty());
      for (std::size_t i = 1; i < able.size(); ++i)
        EXPECT_LE(able[i - 1].ns_per_rad, able[i].ns_per_rad);
      EXPECT_GE(able[0].ns_per_rad, 0.8 * last);
      last = able[0].ns_per_rad;
    }
  }
  for (const MethodCost& row : cheapest_methods(heavy_asymmetric().model, {}, 1e-6, true))
    EXPECT_TRUE(find_stepper(row.method).symplectic) << row.method;
}

TEST(MethodCosts, TheReportExplainsTheChoice) {
  const Problem p = heavy_asymmetric();
  MotionSpec spec = spun({1, 0.4, -0.9}, 2.0);
  NumericsSpec numerics;
  for (const char* model : {"auto", "ode"}) {
    numerics.model = model;
    const SimulationReport report = simulate(p.model, spec, numerics, 1e-6).report;
    const bool splits = report.model == "splitting";
    const std::vector<MethodCost> able = cheapest_methods(p.model, {}, 1e-6, splits);
    EXPECT_EQ(report.method, able[0].method);
    EXPECT_NE(report.method_reason.find("ns per radian"), std::string::npos);
    EXPECT_NE(report.method_reason.find(able[1].method), std::string::npos);
    EXPECT_LE(report.error_estimate_rad.value(), 1e-6);
  }
}

}  // namespace
}  // namespace polhode::test
