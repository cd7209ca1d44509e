// SPDX-License-Identifier: MIT
#include "frame/timeline.h"

#include <gtest/gtest.h>

#include "frame/compose.h"
#include "support/expect_error.h"
#include "support/motions.h"

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

// a thing that comes is drawn over what is there, and leaves it as it was when it is not there yet
TEST(Story, WhatIsNotThereYetIsNotDrawn) {
  const BodySpec body = test::prolate_body();
  const Motion motion = test::moving(body, test::wobbling());
  const Staging staging{
      CameraSpec{}, {}, Timeline({step(1.0, 1.0, {"omega"})}, motion.duration(), 1.0), {}};
  const Composer told(motion, body, staging, {}, {}, {320, 180});
  const auto count = [&](double film) {
    return told.camera_view(film, 4.0).list.opaque.size();
  };
  EXPECT_EQ(count(0.5) + 2, count(1.8));  // shaft and head
  const CameraView fading = told.camera_view(1.2, 4.0);
  EXPECT_EQ(fading.list.opaque.size(), count(0.5));
  EXPECT_LT(fading.list.translucent.front().material.fade, 1.0f);
}

// wherever the camera goes, and whatever it moves with, all that is shown stays in the frame
TEST(Cameras, KeepEverythingInTheFrame) {
  const PictureSize size{640, 360};
  const BodySpec body = test::cone_body();
  for (const char* follow : {"none", "center", "body", "momentum"}) {
    for (const double orbit : {0.0, 0.8}) {
      CameraSpec camera;
      camera.follow = follow;
      camera.orbit = orbit;
      MotionSpec spec = test::spinning_on_pivot();
      spec.duration = 1.0;
      const Composer picture(test::moving(body, spec), body, camera, {}, {}, size);
      for (double film = 0.0; film <= 1.0; film += 0.0371) {
        const Camera now = picture.camera_at(film);
        const Sample sample = picture.scenery().motion.at(film);
        std::vector<Vec3> points;
        add_extent(picture.glyphs_at(sample), points);
        for (const Vec3& point : points) {
          const Vec2 pixel = now.project(point);
          EXPECT_GT(pixel.x(), -2.0) << follow << ' ' << orbit << ' ' << film;
          EXPECT_LT(pixel.x(), size.width + 2.0);
          EXPECT_GT(pixel.y(), -2.0);
          EXPECT_LT(pixel.y(), size.height + 2.0);
        }
      }
    }
  }
}

// riding on the body, the body stands still in the picture
TEST(Cameras, FollowingTheBodyLeavesItWhereItIs) {
  const BodySpec body = test::prolate_body();
  CameraSpec camera;
  camera.follow = "body";
  const Composer picture(test::moving(body, test::wobbling()), body, camera, {}, {}, {640, 360});
  const Vec3 point_B(0.03, 0.05, 0.15);
  const auto pixel = [&](double t) {
    const Sample now = picture.scenery().motion.at(t);
    return picture.camera_at(t).project(now.reference_S + now.q_SB * point_B);
  };
  for (const double t : {0.6, 1.7, 3.9})
    EXPECT_LT((pixel(t) - pixel(0.0)).norm(), 1e-6);
}

TEST(Cameras, LookAlongL) {
  const BodySpec body = test::prolate_body();
  CameraSpec camera;
  camera.follow = "momentum";
  const Composer picture(test::moving(body, test::wobbling()), body, camera, {}, {}, {640, 360});
  const Sample now = picture.scenery().motion.at(2.0);
  const Camera along = picture.camera_at(2.0);
  // the line of L through the eye's middle is nearly a point
  EXPECT_LT(
      (along.project(momentum_tip(picture.scenery(), now)) - along.project(now.reference_S)).norm(),
      25.0);
}

// smooth moves begin and end at their cameras and do not jump; cuts do
TEST(Cameras, MovesAreSmoothAndCutsAreNot) {
  const BodySpec body = test::prolate_body();
  const Motion motion = test::moving(body, test::wobbling());
  ShotSpec moved, cut;
  moved.at = 1.0;
  moved.move = 1.0;
  moved.camera.direction = Vec3(-0.5, 1.0, 0.2);
  cut.at = 3.0;
  cut.camera.direction = Vec3(1.0, 0.0, 0.9);
  const Staging staging{CameraSpec{}, {moved, cut}, Timeline({}, motion.duration(), 1.0), {}};
  const Composer picture(motion, body, staging, {}, {}, {640, 360});
  const double h = 0.01;
  for (double film = 0.0; film + h < 4.0; film += h) {
    const double jump = (picture.camera_at(film + h).eye() - picture.camera_at(film).eye()).norm();
    const bool at_cut = film <= 3.0 && film + h >= 3.0 - 1e-9;
    const bool moving = film > 1.0 - 2 * h && film < 2.0 + h;
    if (at_cut) continue;
    EXPECT_LT(jump, moving ? 0.08 : 1e-12) << film;
  }
  EXPECT_GT((picture.camera_at(3.0).eye() - picture.camera_at(2.99).eye()).norm(), 0.1);
}

}  // namespace
}  // namespace polhode
