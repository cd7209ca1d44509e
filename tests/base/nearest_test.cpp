// SPDX-License-Identifier: MIT
#include "base/nearest.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

const std::vector<std::string> kNames = {"moments", "tensor", "mass", "radius", "radius_cm"};

TEST(NearestName, MendsOneSlipOfEachKind) {
  EXPECT_EQ(nearest_name("momemts", kNames), "moments");    // change
  EXPECT_EQ(nearest_name("moment", kNames), "moments");     // missing
  EXPECT_EQ(nearest_name("moomments", kNames), "moments");  // too many
  EXPECT_EQ(nearest_name("omments", kNames), "moments");    // swapped
  EXPECT_EQ(nearest_name("MOMENTS", kNames), "moments");    // case
}

TEST(NearestName, TakesTheLeastDistanceAndTheFirstOfEquals) {
  EXPECT_EQ(nearest_name("radius_cn", kNames), "radius_cm");
  EXPECT_EQ(nearest_name("radiu", kNames), "radius");
  EXPECT_EQ(nearest_name("ab", {"ac", "ad"}), "ac");
}

TEST(NearestName, KnowsAWordOfALongerName) {
  EXPECT_EQ(nearest_name("axes", {"axis", "semi_axes"}), "axis");
  EXPECT_EQ(nearest_name("axes", {"radius", "semi_axes"}), "semi_axes");
  EXPECT_EQ(nearest_name("xes", {"radius", "semi_axes"}), "");
}

TEST(NearestName, IsSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("xylophone", kNames), "");
  EXPECT_EQ(nearest_name("mass", {}), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'm'), kNames), "");
  EXPECT_EQ(nearest_name("", kNames), "");
}

TEST(IsAlmost, IsOneSlipOfThePen) {
  for (const char* name : {"notes", "note", "Notes", "ntoes", "nots", "notees"})
    EXPECT_TRUE(is_almost(name, "notes")) << name;
  for (const char* name : {"notice", "box", "", "not"})
    EXPECT_FALSE(is_almost(name, "notes")) << name;
  EXPECT_FALSE(is_almost(std::string(100000, 'm'), "m"));
}

TEST(Suggestion, IsANameOrTheList) {
  EXPECT_EQ(suggestion("mas", kNames), " (did you mean 'mass'?)");
  EXPECT_EQ(suggestion("xylophone", {"a", "b"}), " (known: a, b)");
  EXPECT_EQ(suggestion("xylophone", {}), " (there are none)");
}

}  // namespace
}  // namespace polhode
