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

// Times of frames are sums and quotients. Wherever a film begins, and whatever was held before, a
// step begins with the frame of its time, and the motion is then at that time and not a rounding
// before it.
TEST(Timeline, StepsBeginWithTheFrameOfTheirTime) {
  int looked_at = 0;
  for (const int rate : {10, 24, 25, 30, 50, 60}) {
    for (int from = 0; from < 300; from += 7) {
      for (int at = from + 1; at <= 300; at += 11) {
        if ((at - from) * rate % 100 != 0) continue;
        ++looked_at;
        const double hold = from % 3 == 0 ? 1.3 : 0.0;
        StoryStep says = step(at / 100.0, 0.0, {"omega"});
        says.caption = "here";
        const Timeline timeline({step(0.3, hold), says}, 3.0, 1.0);
        const double first = timeline.first_film_time(from / 100.0);
        const bool held = hold > 0.0 && from <= 30 && at >= 30;
        const int frame = (at - from) * rate / 100;
        if (held && 13 * rate % 10 != 0) continue;
        const int index = frame + (held ? 13 * rate / 10 : 0);
        const double film = first + index / static_cast<double>(rate);
        EXPECT_EQ(timeline.caption(film), "here") << rate << ' ' << from << ' ' << at;
        EXPECT_EQ(timeline.motion_time(film), at / 100.0) << rate << ' ' << from << ' ' << at;
        const double before = first + (index - 1) / static_cast<double>(rate);
        EXPECT_FALSE(timeline.caption(before)) << rate << ' ' << from << ' ' << at;
      }
    }
  }
  EXPECT_GT(looked_at, 500);
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
