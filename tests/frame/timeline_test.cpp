// SPDX-License-Identifier: MIT
#include "frame/timeline.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace polhode {
namespace {

StoryStep step(double at,
               double hold,
               std::vector<std::string> show = {},
               std::vector<std::string> hide = {}) {
  StoryStep one;
  one.at = at;
  one.hold = hold;
  one.show = std::move(show);
  one.hide = std::move(hide);
  return one;
}

TEST(Timeline, WithoutAStoryIsTheMotionsClock) {
  const Timeline timeline({}, 10.0, 0.25);
  EXPECT_DOUBLE_EQ(timeline.film_duration(), 40.0);
  EXPECT_DOUBLE_EQ(timeline.motion_time(8.0), 2.0);
  EXPECT_DOUBLE_EQ(timeline.film_time(2.0), 8.0);
  EXPECT_EQ(timeline.presence("omega", 3.0), 1.0);
  EXPECT_FALSE(timeline.caption(3.0));
}

// the motion never runs backwards or jumps, and stands still exactly while it is held
TEST(Timeline, HoldsTheMotion) {
  const Timeline timeline({step(2.0, 3.0), step(1.0, 0.5), step(2.0, 1.0)}, 4.0, 0.5);
  EXPECT_DOUBLE_EQ(timeline.film_duration(), 8.0 + 4.5);
  double last = 0.0;
  for (double film = 0.0; film <= timeline.film_duration(); film += 0.01) {
    const double now = timeline.motion_time(film);
    EXPECT_GE(now, last - 1e-12);
    EXPECT_LE(now, last + 0.5 * 0.01 + 1e-9);
    last = now;
  }
  EXPECT_DOUBLE_EQ(timeline.motion_time(2.3), 1.0);
  EXPECT_DOUBLE_EQ(timeline.motion_time(8.4), 2.0);
  EXPECT_DOUBLE_EQ(timeline.first_film_time(2.0), 4.5);
  EXPECT_DOUBLE_EQ(timeline.film_time(2.0), 8.5);
  for (const double t : {0.0, 0.7, 1.0, 2.0, 3.9})
    EXPECT_NEAR(timeline.motion_time(timeline.film_time(t)), t, 1e-12);
}

TEST(Timeline, ThingsComeAndGo) {
  const Timeline timeline(
      {step(1.0, 0.0, {"omega"}), step(2.0, 0.0, {"momentum"}, {"omega"})}, 4.0, 1.0);
  EXPECT_EQ(timeline.presence("body", 0.0), 1.0);
  EXPECT_EQ(timeline.presence("omega", 0.9), 0.0);
  EXPECT_NEAR(timeline.presence("omega", 1.25), 0.5, 1e-9);  // half of a fade of half a second
  EXPECT_EQ(timeline.presence("omega", 1.5), 1.0);
  EXPECT_EQ(timeline.presence("omega", 3.0), 0.0);
  EXPECT_EQ(timeline.presence("momentum", 1.9), 0.0);
  EXPECT_EQ(timeline.presence("momentum", 3.0), 1.0);
}

TEST(Timeline, AStepBehindTheEndIsRefused) {
  test::expect_error([] { Timeline({step(5.0, 1.0)}, 4.0, 1.0); },
                     Fault::input,
                     "story[0].at",
                     "within the motion");
}

TEST(Timeline, AStepCannotShowAndHideOneThing) {
  StoryStep step;
  step.show = {"trail", "omega"};
  step.hide = {"omega"};
  test::expect_input_error(
      [&] { Timeline({step}, 1.0, 1.0); }, "story[0].hide", "'omega' is shown and hidden at once");
}

}  // namespace
}  // namespace polhode
