// SPDX-License-Identifier: MIT
#include "base/at_place.h"

#include "support/expect_error.h"

namespace polhode {
namespace {

TEST(AtPlace, GivesBackWhatTheWorkGives) {
  EXPECT_EQ(at_place({}, [] { return 7; }), 7);
}

TEST(AtPlace, FillsInWhatIsUnknown) {
  test::expect_input_error(
      [] {
        at_place({{}, 0, "--size"}, [] { throw input_error("is bad"); });
      },
      "--size",
      "is bad");
  const auto knows_more = [] {
    throw input_error("is bad").at({{}, 0, "video.size"});
  };
  test::expect_input_error(
      [&] {
        at_place({{}, 0, "--size"}, knows_more);
      },
      "video.size",
      "is bad");
}

TEST(AtPlace, LeavesInterruptionsAlone) {
  const auto interrupted = [] {
    throw Error(Fault::interrupted, "interrupted");
  };
  test::expect_error(
      [&] {
        at_place({{}, 0, "--size"}, interrupted);
      },
      Fault::interrupted,
      "",
      "interrupted");
}

}  // namespace
}  // namespace polhode
