// SPDX-License-Identifier: MIT
#include "motion/stepper_table.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/tops.h"

namespace polhode::test {
namespace {

using Methods = std::vector<const StepperInfo*>;

TEST(StepperTable, FindsByNameAndSuggestsTheNearest) {
  EXPECT_EQ(find_stepper("rk4").order, 4);
  EXPECT_EQ(&find_stepper(stepper_table().back().name), &stepper_table().back());
  expect_input_error([] { find_stepper("rk44"); }, "", "unknown method 'rk44'");
  expect_input_error([] { find_stepper("rk44"); }, "", "'rk4'");
}

// names are words of a scene file and of file names; the rest is shown by `list methods`
TEST(StepperTable, EveryRowIsWhole) {
  std::set<std::string> names, titles;
  for (const StepperInfo& row : stepper_table()) {
    SCOPED_TRACE(row.name);
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_TRUE(titles.insert(row.title).second);
    EXPECT_EQ(row.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
              std::string::npos);
    EXPECT_GT(row.order, 0);
    EXPECT_FALSE(row.cost.empty());
    EXPECT_FALSE(row.source.empty());
    ASSERT_NE(row.make, nullptr);
    if (!row.only_table) {
      EXPECT_NE(row.make(free_body({1, 2, 2.5}), 1.0), nullptr);
    }
    // an angle of the step belongs to a limit in words
    EXPECT_EQ(row.limit_of != StepLimit::none, row.limit_turn > 0.0);
    EXPECT_TRUE(row.limit_turn == 0.0 || !row.limit.empty());
  }
  EXPECT_EQ(names.count("auto") + names.count("exact"), 0U) << "words of numerics.method";
}

// Hairer and Wanner, Solving ODEs II, IV.2: RK4 is stable on the imaginary axis up to 2 sqrt 2
TEST(StepperTable, TheLimitOfRk4IsThatOfTheBook) {
  EXPECT_NEAR(find_stepper("rk4").limit_turn, std::sqrt(8.0), 1e-7);
}

TEST(ParseMethods, AreTheNamedOnesInTheirOrderOrAll) {
  EXPECT_EQ(parse_methods("rk4,dmv2,rk2"),
            (Methods{&find_stepper("rk4"), &find_stepper("dmv2"), &find_stepper("rk2")}));
  const Methods all = parse_methods("");
  ASSERT_EQ(all.size(), stepper_table().size());
  EXPECT_EQ(all.front(), &stepper_table().front());
  EXPECT_EQ(all.back(), &stepper_table().back());
  expect_input_error([] { parse_methods("rk4,dopri55"); }, "--methods", "'dopri5'");
  expect_input_error([] { parse_methods("rk4,,rk2"); }, "--methods", "unknown method ''");
}

// the reason names the method, what it cannot do, and methods of high order that can
TEST(WhyNot, SaysWhatTheMethodCannotDoAndWhichCan) {
  const std::string heavy = why_not(find_stepper("dmv6"), heavy_body({1, 1, 2}, Vec3(0, 0, 0.5)));
  EXPECT_EQ(heavy.rfind("dmv6 takes free bodies only", 0), 0U) << heavy;
  EXPECT_NE(heavy.find("; taylor16, taylor10, dop853, gauss6 can, and others"), std::string::npos)
      << heavy << "; of one order the first of the table";
  EXPECT_EQ(heavy.find("dmv10"), std::string::npos) << "it cannot either";

  const std::string rotator = why_not(find_stepper("three_rotations"), free_body({1, 1, 0}));
  EXPECT_NE(rotator.find("all its mass on a line"), std::string::npos) << rotator;
}

// what can be stepped with gravity or loads can be stepped without
TEST(WhyNot, AFreeBodyIsTakenByEveryMethod) {
  for (const StepperInfo& row : stepper_table())
    EXPECT_EQ(why_not(row, free_body({1, 2, 2.5})).empty(), !row.only_table) << row.name;
}

TEST(WhyNot, ABodyThatIsPushedNeedsAMethodThatTakesLoads) {
  BodyModel pushed = free_body({1, 2, 2.5});
  pushed.with_translation = true;
  for (const StepperInfo& row : stepper_table()) {
    const std::string reason = why_not(row, pushed);
    if (row.only_table) continue;
    EXPECT_EQ(reason.empty(), row.takes_loads) << row.name;
    EXPECT_EQ(reason.find("no torques or forces") == std::string::npos, row.takes_loads);
    EXPECT_EQ(reason.find("rk4_euler_angles,"), std::string::npos) << "it cannot either";
  }
}

}  // namespace
}  // namespace polhode::test
