// SPDX-License-Identifier: MIT
#include "frame/compose.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "frame/composers.h"
#include "math/so3.h"
#include "support/motions.h"
#include "support/show_only.h"

namespace polhode {
namespace {

using test::composer;
using test::cone_body;
using test::kSize;
using test::moving;
using test::prolate_body;
using test::show_only;
using test::spinning_on_pivot;
using test::wobbling;

// far side, then near side; cones would not know where to go
TEST(Compose, BodiesThatAreSeenThroughHaveTwoSides) {
  ShowSpec show = show_only("body");
  show.body_opacity = 0.4;
  const DrawList list = composer(prolate_body(), wobbling(), show).at(0.3);
  EXPECT_TRUE(list.opaque.empty());
  ASSERT_EQ(list.translucent.size(), 2u);
  EXPECT_EQ(list.translucent[0].faces, Faces::back);
  EXPECT_EQ(list.translucent[1].faces, Faces::front);
  show["space_cone"] = true;
  try {
    composer(prolate_body(), wobbling(), show);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().key, "show.body_opacity");
  }
}

// a frame is a function of its time alone
TEST(Compose, AFrameIsAFunctionOfItsTime) {
  const Composer picture = composer(cone_body(), spinning_on_pivot());
  const DrawList first = picture.at(1.234);
  picture.at(0.1);
  const DrawList again = picture.at(1.234);
  ASSERT_EQ(first.opaque.size(), again.opaque.size());
  for (std::size_t i = 0; i < first.opaque.size(); ++i) {
    EXPECT_EQ(first.opaque[i].world_from_mesh, again.opaque[i].world_from_mesh);
  }
}

// what is drawn stays inside the frame for the whole film
TEST(Compose, AutomaticCameraKeepsEverythingInside) {
  for (const bool heavy : {false, true}) {
    const BodySpec body = heavy ? cone_body() : prolate_body();
    const MotionSpec spec = heavy ? spinning_on_pivot() : wobbling();
    const Composer picture = composer(body, spec);
    for (double t = 0.0; t <= spec.duration; t += 0.0613) {
      const DrawList list = picture.at(t);
      for (const DrawItem& item : list.opaque) {
        for (const Vertex& v : item.mesh->vertices) {
          const glm::vec4 clip =
              list.view.clip_from_world * item.world_from_mesh * glm::vec4(v.position, 1.0f);
          ASSERT_TRUE(std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w);
        }
      }
    }
  }
}

TEST(Compose, CameraInsideItsTargetIsAnError) {
  CameraSpec camera;
  camera.eye = Vec3(1, 1, 1);
  camera.target = Vec3(1, 1, 1);
  EXPECT_THROW(composer(prolate_body(), wobbling(), {}, camera), Error);
}

// a thing that comes is drawn over what is there, and leaves it as it was when it is not there yet
TEST(Compose, WhatIsNotThereYetIsNotDrawn) {
  const BodySpec body = test::prolate_body();
  const Motion motion = test::moving(body, test::wobbling());
  StoryStep omega_comes;
  omega_comes.at = omega_comes.hold = 1.0;
  omega_comes.show = {"omega"};
  const Staging staging{CameraSpec{}, {}, Timeline({omega_comes}, motion.duration(), 1.0), {}};
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
TEST(Compose, CamerasKeepEverythingInTheFrame) {
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
TEST(Compose, FollowingTheBodyLeavesItWhereItIs) {
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

TEST(Compose, CamerasLookAlongL) {
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
TEST(Compose, MovesAreSmoothAndCutsAreNot) {
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

// turning the body by the tolerance moves no drawn point by more than the pixels it was made from
TEST(Compose, AttitudeToleranceIsAnUpperBoundInPixels) {
  const BodySpec body = prolate_body();
  CameraSpec own;
  own.eye = Vec3(1.2, 0.4, 0.3);
  own.target = Vec3::Zero();
  for (const CameraSpec& camera : {CameraSpec{}, own}) {
    const Composer picture = composer(body, wobbling(), {}, camera);
    const double tolerance = attitude_tolerance(camera, 0.1, picture.scenery().scale.body, kSize);
    EXPECT_GT(tolerance, 1e-5);
    const Sample s = moving(body, wobbling()).at(1.0);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
      const Quat error(Eigen::AngleAxisd(tolerance, axis));
      for (const Vec3& tip :
           {momentum_tip(picture.scenery(), s), omega_tip(picture.scenery(), s)}) {
        const Vec2 moved = picture.camera().project(error * tip) - picture.camera().project(tip);
        EXPECT_LE(moved.norm(), 0.1);
      }
    }
  }
}

}  // namespace
}  // namespace polhode
