// SPDX-License-Identifier: MIT
#include "base/at_place.h"

#include "support/expect_error.h"

namespace polhode {
namespace {

TEST(AtPlace, gives_back_what_the_work_gives) {
  EXPECT_EQ(at_place({}, [] { return 7; }), 7);
}

TEST(AtPlace, fills_in_what_is_unknown) {
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

TEST(AtPlace, leaves_interruptions_alone) {
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
