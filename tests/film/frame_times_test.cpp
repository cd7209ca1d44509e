// SPDX-License-Identifier: MIT
#include "film/frame_times.h"

#include <gtest/gtest.h>

#include "film/small_films.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::small_scene;

FrameTimes times_of(const Scene& scene, const TimeRange& range = {}) {
  return plan_frame_times(solve(scene), range);
}

TimeRange range(double from, double to) {
  return {from, to, {}, false};
}

TimeRange picture_at(double t) {
  return {{}, {}, t, true};
}

TEST(FrameTimes, AWholeFilmHasItsDurationTimesItsRate) {
  Scene scene = small_scene();
  EXPECT_EQ(times_of(scene).count, 10);
  EXPECT_NEAR(times_of(scene).film_time(7), 0.7, 1e-15);
  scene.video.time_scale = 0.1;
  EXPECT_EQ(times_of(scene).count, 100);
  scene.video.fps = {30000, 1001};
  scene.video.time_scale = 1.0;
  EXPECT_EQ(times_of(scene).count, 30) << "the last of 29.97 frames is begun";
  scene.video.fps = {100, 1};
  scene.motion.duration = 0.28;
  EXPECT_EQ(times_of(scene).count, 28) << "no frame for the round-off of 28.000000000000004";
}

TEST(FrameTimes, ARangeBeginsAndEndsInTheMotion) {
  Scene scene = small_scene();
  scene.video.time_scale = 0.5;
  const FrameTimes frames = times_of(scene, range(0.2, 0.7));
  EXPECT_EQ(frames.count, 10) << "half a second of motion is a second of film";
  EXPECT_NEAR(frames.first, 0.4, 1e-12);
  EXPECT_EQ(frames.from, 0.2);
  EXPECT_EQ(frames.to, 0.7);
  for (int i = 0; i < frames.count; ++i)
    EXPECT_NEAR(frames.timeline.motion_time(frames.film_time(i)), 0.2 + 0.05 * i, 1e-12);
}

// three times 0.7 s is a little less than 2.1 s
TEST(FrameTimes, TheEndIsInTheMotionWhateverRoundOffSays) {
  Scene scene = small_scene();
  scene.motion.duration = 0.7 + 0.7 + 0.7;
  ASSERT_LT(scene.motion.duration, 2.1);
  EXPECT_EQ(times_of(scene, range(0.0, 2.1)).to, scene.motion.duration);
  EXPECT_EQ(times_of(scene, picture_at(2.1)).to, scene.motion.duration);
  EXPECT_NO_THROW(check_time_range(scene, range(0.0, 2.1)));
  test::expect_input_error(
      [&] { check_time_range(scene, range(0.0, 2.1000001)); }, "--to", "within the motion");
}

// two films that follow each other show each pause once
TEST(FrameTimes, APauseBelongsToTheFilmThatBeginsWithIt) {
  const Scene scene = small_scene("[[story]]\nat = 0.3\nhold = 0.5\n");
  EXPECT_EQ(times_of(scene).count, 15);
  EXPECT_EQ(times_of(scene, range(0.0, 0.3)).count, 3);
  const FrameTimes rest = times_of(scene, range(0.3, 1.0));
  EXPECT_EQ(rest.count, 12);
  EXPECT_NEAR(rest.timeline.motion_time(rest.film_time(4)), 0.3, 1e-12) << "still held";
  EXPECT_NEAR(rest.timeline.motion_time(rest.film_time(6)), 0.4, 1e-12);
}

// of a pause the end: everything that comes in it is there
TEST(FrameTimes, OnePictureIsOfTheLastMomentThatShowsItsTime) {
  const Scene scene = small_scene("[[story]]\nat = 0.3\nhold = 0.5\n");
  const FrameTimes frames = times_of(scene, picture_at(0.3));
  EXPECT_EQ(frames.count, 1);
  EXPECT_NEAR(frames.first, 0.8, 1e-12);
  EXPECT_EQ(frames.from, 0.3);
  EXPECT_EQ(frames.to, 0.3);
  EXPECT_EQ(times_of(scene, {0.6, {}, {}, true}).from, 0.6)
      << "--from serves where no time is said";
}

// a top that spins about its own axis is back after each turn, here between two frames
TEST(FrameTimes, ALoopEndsOneStepBeforeItsFirstFrame) {
  Scene scene = small_scene("loop = true\n");
  const double turn = 0.731;
  scene.motion.spin.body = Vec3(0.0, 0.0, 2.0 * kPi / turn);
  const FrameTimes frames = times_of(scene);
  ASSERT_TRUE(frames.loop);
  EXPECT_NEAR(frames.loop->duration, turn, 1e-6);
  EXPECT_EQ(frames.count, 7);
  EXPECT_NEAR(frames.to, turn, 1e-6);
  EXPECT_NEAR(frames.timeline.motion_time(frames.film_time(6)), turn * 6.0 / 7.0, 1e-6);
  EXPECT_FALSE(times_of(small_scene()).loop);
}

// a step that the motion reaches and the loop does not: the error says where the loop ends
TEST(FrameTimes, AStepBehindTheLoopIsToldItsEnd) {
  Scene scene = small_scene("loop = true\n[[story]]\nat = 0.5\n[[story]]\nat = 0.9\n");
  scene.motion.spin.body = Vec3(0.0, 0.0, 2.0 * kPi / 0.731);
  test::expect_input_error(
      [&] { times_of(scene); }, "story[1].at", "the loop closes after 0.731 s");
  scene.story[1].at = 0.7;
  EXPECT_NO_THROW(times_of(scene));
  scene.story[1].at = 1.5;
  test::expect_input_error([&] { times_of(scene); }, "story[1].at", "within the motion");
  // so does a time that is asked for
  scene.story.clear();
  const Solved solved = solve(scene);
  const auto refused = [&](const TimeRange& range, const char* option) {
    test::expect_input_error(
        [&] { plan_frame_times(solved, range); },
        option,
        "the loop closes after 0.731 s of the motion, so the film never shows");
  };
  refused({0.8, {}, {}, false}, "--from");
  refused({{}, 0.9, {}, false}, "--to");
  refused({{}, {}, 0.8, true}, "--still");
  EXPECT_EQ(plan_frame_times(solved, {{}, 0.4, {}, false}).count, 4);
}

TEST(FrameTimes, TimesOutsideTheMotionNameTheirOption) {
  const Scene scene = small_scene();
  const auto refused = [&](const TimeRange& asked, const char* option, const char* words) {
    test::expect_input_error([&] { check_time_range(scene, asked); }, option, words);
  };
  refused({-0.1, {}, {}, false}, "--from", "0 to 1 s, got -0.1");
  refused({std::nan(""), {}, {}, false}, "--from", "0 to 1 s");
  refused({{}, 1.01, {}, false}, "--to", "got 1.01");
  refused(range(0.5, 0.5), "--to", "later than --from (0.5 s)");
  refused(picture_at(1.5), "--still", "got 1.5");
  refused({{}, 0.5, {}, true}, "--to", "a picture shows one time");
  refused({0.2, {}, 0.5, true}, "--from", "--still says");
  EXPECT_NO_THROW(check_time_range(scene, {0.2, {}, {}, true}));
  EXPECT_NO_THROW(check_time_range(scene, range(0.0, 1.0)));
  EXPECT_NO_THROW(check_time_range(scene, picture_at(1.0)));
}

TEST(FrameTimes, AFilmWithoutEndIsRefusedBeforeAnyWork) {
  Scene scene = small_scene();
  scene.video.time_scale = 1e-7;
  test::expect_input_error([&] { check_time_range(scene, {}); }, "", "1e+08 frames");
  EXPECT_NO_THROW(check_time_range(scene, range(0.0, 0.05)));
  // holds count, too
  const Scene held = small_scene("[[story]]\nat = 0.5\nhold = 2e6\n");
  EXPECT_NO_THROW(check_time_range(held, {}));
  test::expect_input_error([&] { times_of(held); }, "", "2e+07 frames");
}

}  // namespace
}  // namespace polhode
