// SPDX-License-Identifier: MIT
#include "frame/camera.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include "frame/to_glm.h"

namespace polhode {
namespace {

constexpr PictureSize kPicture{640, 360};

std::vector<Vec3> random_points(unsigned seed, double spread) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-spread, spread);
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i) {
    points.emplace_back(uniform(random), 0.5 * uniform(random), 2.0 + uniform(random));
  }
  return points;
}

// the matrix that OpenGL gets and the function that tests trust must be the same projection
TEST(Camera, ClipMatrixAndProjectAgree) {
  const Camera camera(Vec3(3, -2, 1.5), Vec3(0.2, 0.1, 0.3), 0.6, kPicture, Vec3::Zero(), 1.0);
  for (const Vec3& point : random_points(1, 0.4)) {
    const glm::vec4 clip = camera.view().clip_from_world * glm::vec4(to_glm(point), 1.0f);
    const Vec2 pixel = camera.project(point);
    EXPECT_NEAR((clip.x / clip.w + 1.0) * 0.5 * kPicture.width, pixel.x(), 2e-3);
    EXPECT_NEAR((1.0 - clip.y / clip.w) * 0.5 * kPicture.height, pixel.y(), 2e-3);
  }
}

TEST(Camera, UpIsUpAndTheTargetIsInTheMiddle) {
  const Camera camera(Vec3(5, 0, 0), Vec3::Zero(), 0.6, kPicture, Vec3::Zero(), 1.0);
  EXPECT_NEAR((camera.project(Vec3::Zero()) - Vec2(320, 180)).norm(), 0.0, 1e-9);
  EXPECT_LT(camera.project(Vec3(0, 0, 0.1)).y(), 180.0);
  // seen from +X with +Z up, +Y is to the right
  EXPECT_GT(camera.project(Vec3(0, 0.1, 0)).x(), 320.0);
}

TEST(Camera, PixelsPerMetreMatchesProject) {
  const Camera camera(Vec3(5, 0, 0), Vec3::Zero(), 0.6, kPicture, Vec3::Zero(), 1.0);
  const double step = 1e-3;
  const double moved = (camera.project(Vec3(0, step, 0)) - camera.project(Vec3::Zero())).norm();
  EXPECT_NEAR(moved / step, camera.pixels_per_metre(Vec3::Zero()), 1e-6 * moved / step);
}

// of balls all over: none of which a point is seen counts as outside, and those that do are shown
// the way by the pixel of their middle
TEST(Camera, TheWayToABallIsThatToItsPixel) {
  const Camera camera(Vec3(5, 0, 0), Vec3::Zero(), 0.6, kPicture, Vec3::Zero(), 20.0);
  const Vec2 middle(0.5 * kPicture.width, 0.5 * kPicture.height);
  const std::vector<Vec3> directions = random_points(2, 1.0);
  int outside = 0;
  for (const Vec3& center : random_points(3, 3.0)) {
    constexpr double kRadius = 0.3;
    const std::optional<Vec2> way = camera.way_to({center, kRadius});
    const bool any_seen =
        std::any_of(directions.begin(), directions.end(), [&](const Vec3& direction) {
          return camera.sees(center + kRadius * direction.normalized());
        });
    EXPECT_FALSE(any_seen && way) << center.transpose();
    if (!way) continue;
    ++outside;
    EXPECT_NEAR(way->norm(), 1.0, 1e-12);
    if (center.x() >= 5.0 - kRadius) continue;
    EXPECT_NEAR((*way - (camera.project(center) - middle).normalized()).norm(), 0.0, 1e-9);
  }
  EXPECT_GT(outside, 20);
}

TEST(Camera, ABallIsOutsideWhenItsRimIs) {
  const Camera camera(Vec3(5, 0, 0), Vec3::Zero(), 0.6, kPicture, Vec3::Zero(), 1.0);
  // the tangent from the eye to the ball passes the upper edge
  const double edge = 0.3, radius = 0.2;
  const double height = radius / std::cos(edge) + 5.0 * std::tan(edge);
  EXPECT_FALSE(camera.way_to({Vec3(0, 0, height - 1e-9), radius}));
  const std::optional<Vec2> way = camera.way_to({Vec3(0, 0, height + 1e-9), radius});
  ASSERT_TRUE(way);
  EXPECT_NEAR((*way - Vec2(0, -1)).norm(), 0.0, 1e-12);
  // behind the eye: whither the camera would have to turn
  const std::optional<Vec2> behind = camera.way_to({Vec3(9, 0.5, 0), radius});
  ASSERT_TRUE(behind);
  EXPECT_NEAR((*behind - Vec2(1, 0)).norm(), 0.0, 1e-12);
  EXPECT_TRUE(camera.way_to({Vec3(9, 0, 0), radius}));
  EXPECT_TRUE(camera.way_to({Vec3(-50, 0, 0), radius})) << "beyond the clip planes";
}

TEST(Camera, ZoomMagnifiesAboutTheMiddle) {
  const Camera camera(Vec3(5, 0, 0), Vec3::Zero(), 0.6, kPicture, Vec3::Zero(), 1.0);
  const Vec2 middle(0.5 * kPicture.width, 0.5 * kPicture.height);
  for (const double zoom : {0.4, 1.0, 3.0}) {
    for (const Vec3& point : {Vec3(0.1, 0.2, 0.3), Vec3(-0.4, 0.1, -0.2)}) {
      const Vec2 wanted = middle + zoom * (camera.project(point) - middle);
      EXPECT_LT((camera.zoomed(zoom).project(point) - wanted).norm(), 1e-9);
    }
  }
}

class CameraFraming : public ::testing::TestWithParam<int> {};

// everything is inside the margins, and two opposite sides are touched: no nearer camera would do
TEST_P(CameraFraming, HoldsEveryPointAndWastesNothing) {
  const std::vector<Vec3> points = random_points(static_cast<unsigned>(GetParam()), 1.0);
  const Vec3 directions[] = {{1, 0, 0}, {0.82, 0.46, 0.34}, {0, -1, 0.2}, {0, 0, 1}, {-1, 2, -3}};
  for (const Vec3& direction : directions) {
    const Camera camera =
        framing_camera(points, {}, direction, 0.5, kPicture, {0.05, 0.05, 0.05, 0.05});
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Vec3& point : points) {
      const Vec2 p = camera.project(point);
      left = std::min(left, p.x());
      right = std::max(right, p.x());
      top = std::min(top, p.y());
      bottom = std::max(bottom, p.y());
    }
    const double mx = 0.05 * kPicture.width;
    const double my = 0.05 * kPicture.height;
    EXPECT_GE(left, mx - 1e-6);
    EXPECT_LE(right, kPicture.width - mx + 1e-6);
    EXPECT_GE(top, my - 1e-6);
    EXPECT_LE(bottom, kPicture.height - my + 1e-6);
    const bool wide = left < mx + 1e-6 && right > kPicture.width - mx - 1e-6;
    const bool tall = top < my + 1e-6 && bottom > kPicture.height - my - 1e-6;
    EXPECT_TRUE(wide || tall);
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, CameraFraming, ::testing::Range(1, 6));

TEST(Camera, OnePointCanBeFramed) {
  const Camera camera =
      framing_camera({Vec3(1, 2, 3)}, {}, Vec3(1, 0, 0), 0.5, kPicture, {0.05, 0.05, 0.05, 0.05});
  EXPECT_NEAR((camera.project(Vec3(1, 2, 3)) - Vec2(320, 180)).norm(), 0.0, 1e-6);
}

}  // namespace
}  // namespace polhode
