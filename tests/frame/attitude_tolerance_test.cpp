// SPDX-License-Identifier: MIT
#include "frame/attitude_tolerance.h"

#include <gtest/gtest.h>

#include "frame/composers.h"
#include "support/motions.h"

namespace polhode {
namespace {

using test::composer;
using test::kSize;
using test::moving;
using test::prolate_body;
using test::wobbling;

// turning the body by the tolerance moves no drawn point by more than the pixels it was made from
TEST(AttitudeTolerance, IsAnUpperBoundInPixels) {
  const BodySpec body = prolate_body();
  CameraSpec own;
  own.eye = Vec3(1.2, 0.4, 0.3);
  own.target = Vec3::Zero();
  for (const CameraSpec& camera : {CameraSpec{}, own}) {
    const Composer picture = composer(body, wobbling(), {}, camera);
    const double tolerance =
        attitude_tolerance(camera, 0.1, {picture.scenery().scale.body, 0.0}, kSize);
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

// a point far outside of the body moves farther than the tips of vectors
TEST(AttitudeTolerance, KnowsThePointsOfTheScene) {
  CameraSpec camera;
  camera.eye = Vec3(6.0, 2.0, 1.5);
  camera.target = Vec3::Zero();
  const Camera seen(*camera.eye, *camera.target, camera.fov, kSize, Vec3::Zero(), 5.0);
  const double body = 0.2;
  for (const double far : {0.1, 0.5, 2.0, 5.0}) {
    const double tolerance = attitude_tolerance(camera, 0.1, {body, far}, kSize);
    for (const Vec3& point : {Vec3(far, 0, 0), Vec3(0, far, 0), Vec3(0, 0, -far)}) {
      for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        const Quat error(Eigen::AngleAxisd(tolerance, axis));
        EXPECT_LE((seen.project(error * point) - seen.project(point)).norm(), 0.1) << far;
      }
    }
  }
  EXPECT_EQ(attitude_tolerance(camera, 0.1, {body, 0.1}, kSize),
            attitude_tolerance(camera, 0.1, {body, 0.0}, kSize));
}

}  // namespace
}  // namespace polhode
