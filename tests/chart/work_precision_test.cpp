// SPDX-License-Identifier: MIT
#include "chart/work_precision.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "chart/work_points.h"
#include "motion/stepper_table.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

WorkOptions quick() {
  WorkOptions options;
  options.least_work_s = 1e-4;
  options.most_run_s = 0.03;
  return options;
}

WorkProblem free_problem() {
  const Problem p = upright(hairer_vilmart());
  return {p.model, p.start, 10.0};
}

// the slope of the drawn points is the order, for methods of every kind
TEST(WorkPrecision, PointsFollowTheOrder) {
  const WorkProblem p = free_problem();
  const ReferenceSolution reference(p.model, p.start, p.duration);
  for (const char* name : {"rk4", "symmetric_remainder2", "cf4", "gauss6", "dmv8"}) {
    const StepperInfo& method = find_stepper(name);
    std::vector<WorkPoint> good;
    for (const WorkPoint& point : work_precision(method, p, reference, quick())) {
      if (point.status == kPointOk && point.error_rad < 1e-3 && point.error_rad > 1e-11)
        good.push_back(point);
    }
    ASSERT_GE(good.size(), 2U) << name;
    const double slope = std::log(good.front().error_rad / good.back().error_rad) /
                         std::log(good.front().step / good.back().step);
    EXPECT_NEAR(slope, method.order, 0.5) << name;
    for (std::size_t i = 1; i < good.size(); ++i)
      EXPECT_LT(good[i].step, good[i - 1].step) << name;
  }
}

TEST(WorkPrecision, EveryMethodGivesPointsAndEnds) {
  const WorkProblem p = free_problem();
  const ReferenceSolution reference(p.model, p.start, p.duration);
  for (const StepperInfo& method : stepper_table()) {
    if (method.only_table) continue;
    const std::vector<WorkPoint> points = work_precision(method, p, reference, quick());
    EXPECT_GE(points.size(), 3U) << method.name;
    for (const WorkPoint& point : points) {
      EXPECT_EQ(point.method, method.name);
      if (point.status != kPointOk && point.status != kPointBelowReference) continue;
      EXPECT_GT(point.time_us, 0.0) << method.name;
      EXPECT_GT(point.evaluations, 0) << method.name;
      EXPECT_EQ(point.status == kPointBelowReference, point.error_rad < reference.least_error());
    }
  }
}

// steps without a solution and charts at their poles are rows, not numbers
TEST(WorkPrecision, FailuresAreTold) {
  const Problem pole = hairer_vilmart();  // upright third axis: Euler angles have no rates
  const WorkProblem p{pole.model, pole.start, 10.0};
  const ReferenceSolution reference(p.model, p.start, p.duration);
  for (const WorkPoint& point :
       work_precision(find_stepper("rk4_euler_angles"), p, reference, quick()))
    EXPECT_EQ(point.status, "no_solution");
  const std::vector<WorkPoint> dmv = work_precision(find_stepper("dmv2"), p, reference, quick());
  EXPECT_EQ(dmv.front().status, "no_solution");
  EXPECT_TRUE(std::isnan(dmv.front().error_rad));
  EXPECT_EQ(dmv.back().status, kPointOk);
}

TEST(WorkPrecision, TheCheapestIsTheFastestThatIsKnownToBeGoodEnough) {
  const std::vector<WorkPoint> points = {drawn("rk4", 5.0, 1e-3, kPointOk),
                                         drawn("rk4", 50.0, 1e-7, kPointOk),
                                         drawn("gauss4", 1.0, NAN, "no_judge"),
                                         drawn("dop853", 20.0, 1e-15, kPointBelowReference),
                                         drawn("cf4", 2.0, 1e-2, kPointOk)};
  EXPECT_EQ(cheapest(points, 1e-1)->method, "cf4");
  EXPECT_EQ(cheapest(points, 1e-3)->method, "rk4");
  EXPECT_EQ(cheapest(points, 1e-4)->method, "dop853");
  EXPECT_EQ(cheapest(points, 1e-16), nullptr);
  // what the reference cannot judge hides what finer steps of the other would cost
  EXPECT_EQ(cheapest({drawn("gauss6", 90.0, 8e-10, kPointBelowReference),
                      drawn("dop853", 3.0, 5e-9, kPointBelowReference)},
                     1e-9),
            nullptr);
}

}  // namespace
}  // namespace polhode::test
