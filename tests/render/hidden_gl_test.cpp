// SPDX-License-Identifier: MIT
// Hidden parts of lines against rays: a ball covers a rod through its middle and nothing else.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "frame/arrow.h"
#include "frame/camera.h"
#include "render/renderer.h"

namespace polhode {
namespace {

constexpr PictureSize kHiddenSize{1280, 960};
constexpr double kRod = 0.06;  // its radius
constexpr double kBall = 0.5;

// A red rod along X through a ball that is black, and what is seen of it.
class HiddenLine : public testing::Test {
 protected:
  HiddenLine()
      : camera_(Vec3(0.3, -6.0, 1.5), Vec3::Zero(), 0.4, kHiddenSize, Vec3::Zero(), 2.0),
        context_(open_context("osmesa")),
        renderer_(*context_, {kHiddenSize.width, kHiddenSize.height, 0, false}) {}

  Image drawn(float hidden, float dashes, bool covers = true, bool thin = false) {
    DrawList list;
    list.view = camera_.view(DrawingFrame{Vec3::Zero(), 1.0});
    Material red;
    red.color = {1, 0, 0};
    red.flat = true;
    red.hidden = hidden;
    red.dashes = dashes;
    add_tube(list.opaque, arrow_meshes(32, 32), Vec3(-1, 0, 0), Vec3(1, 0, 0), kRod, red);
    Material black;
    black.color = {0, 0, 0};
    black.flat = true;
    black.covers = covers;
    black.thin = thin;
    list.opaque.push_back(ball(black));
    Image image;
    renderer_.draw(list, image);
    return image;
  }

  // a black ball about the origin
  static DrawItem ball(const Material& black) {
    return {std::make_shared<const Mesh>(unit_sphere(128)),
            to_glm(Eigen::Matrix4d(Eigen::Vector4d(kBall, kBall, kBall, 1.0).asDiagonal())),
            black,
            Faces::front};
  }

  // red, 0..255, in the plane through the rod and across the line of sight, at this x; `beside` the
  // rod's middle
  int red_at(const Image& image, double x, double beside = 0.0) const {
    const Vec3 across = Vec3::UnitX().cross(camera_.eye()).normalized();
    const Vec2 at = camera_.project(Vec3(x, 0, 0) + beside * across);
    return image.at(static_cast<int>(at.x()), static_cast<int>(at.y()))[0];
  }

  // whether the ball lies on the ray to that point of the rod
  bool covered(double x) const {
    const Vec3 eye = camera_.eye(), ray = (Vec3(x, 0, 0) - eye).normalized();
    const double along = -eye.dot(ray);
    const double off2 = eye.squaredNorm() - along * along;
    return off2 < kBall * kBall &&
           along - std::sqrt(kBall * kBall - off2) < (Vec3(x, 0, 0) - eye).norm() - 0.06;
  }

  Camera camera_;
  std::unique_ptr<Context> context_;
  Renderer renderer_;
};

TEST_F(HiddenLine, IsSeenThroughTheBodyWhereRaysSaySo) {
  const Image image = drawn(0.4f, 0.0f);
  int hidden = 0;
  for (double x = -0.95; x < 0.96; x += 0.01) {
    if (std::abs(std::abs(x) - kBall) < 0.08) continue;  // too near the edge to judge
    EXPECT_NEAR(red_at(image, x), covered(x) ? 0.4 * 255 : 255, 2) << x;
    hidden += covered(x) ? 1 : 0;
  }
  EXPECT_GT(hidden, 50);
}

TEST_F(HiddenLine, IsNotSeenUnlessAskedFor) {
  EXPECT_EQ(red_at(drawn(0.0f, 0.0f), 0.1), 0);
  // nor through what is no body, such as another line
  EXPECT_EQ(red_at(drawn(0.4f, 0.0f, false), 0.1), 0);
}

// thin rods of a body would cut a vector beside them to pieces: it is drawn over them
TEST_F(HiddenLine, IsWholeInFrontOfAndBehindWhatIsThin) {
  const Image image = drawn(0.4f, 1.0f, true, true);
  for (double x = -0.95; x < 0.96; x += 0.01)
    EXPECT_EQ(red_at(image, x), 255) << x;
  const Vec2 beside = camera_.project(Vec3(0, 0, 0.3));
  EXPECT_EQ(image.at(static_cast<int>(beside.x()), static_cast<int>(beside.y()))[3], 255)
      << "the ball is there";
  EXPECT_EQ(red_at(drawn(0.0f, 0.0f, true, true), 0.1), 0) << "others are hidden as ever";
}

TEST_F(HiddenLine, HasDashesOfEqualLengthsFromItsFootOn) {
  const Image image = drawn(0.4f, 1.0f);
  // a dash and a gap take 0.09 (frame/arrow.h), and the foot is at x = -1
  int changes = 0;
  for (double x = -0.4; x < 0.4; x += 0.005) {
    const double phase = std::fmod((x + 1.0) / 0.09, 1.0);
    const double edge = std::min({phase, 1.0 - phase, std::abs(phase - 0.5)});
    if (edge < 0.12) continue;
    EXPECT_NEAR(red_at(image, x), phase < 0.5 ? 0.4 * 255 : 0, 4) << x;
    ++changes;
  }
  EXPECT_GT(changes, 60);
}

// A rod along Z through the ball, and through a table on which its middle lies: what is below it
// and what is in the ball are seen alike, once.
TEST_F(HiddenLine, IsSeenThroughATable) {
  for (const bool covers : {true, false}) {
    DrawList list;
    list.view = camera_.view(DrawingFrame{Vec3::Zero(), 1.0});
    Material red;
    red.color = {1, 0, 0};
    red.flat = true;
    red.hidden = 0.4f;
    add_tube(list.opaque, arrow_meshes(32, 32), Vec3(0, 0, -1), Vec3(0, 0, 1), kRod, red);
    Material black;
    black.color = {0, 0, 0};
    black.flat = true;
    black.covers = true;
    list.opaque.push_back(ball(black));
    Mesh square;
    for (const glm::vec2 corner : {glm::vec2(-5, -5), {5, -5}, {5, 5}, {-5, 5}})
      square.vertices.push_back({{corner, 0.0f}, {0, 0, 1}});
    square.indices = {0, 1, 2, 0, 2, 3};
    Material table = black;
    table.soft = true;
    table.covers = covers;
    list.translucent.push_back(
        {std::make_shared<const Mesh>(square), glm::mat4(1.0f), table, Faces::front});
    Image image;
    renderer_.draw(list, image);
    const auto red_of = [&](double z) {
      const Vec2 at = camera_.project(Vec3(0, 0, z));
      return image.at(static_cast<int>(at.x()), static_cast<int>(at.y()))[0];
    };
    for (double z = -0.95; z < -0.1; z += 0.05)
      EXPECT_NEAR(red_of(z), covers ? 0.4 * 255 : 0.0, 2) << z;
    for (double z = 0.1; z < 0.4; z += 0.05)
      EXPECT_NEAR(red_of(z), 0.4 * 255, 2) << z << ": in the ball";
    for (double z = 0.65; z < 0.95; z += 0.05)
      EXPECT_EQ(red_of(z), 255) << z;
  }
}

TEST_F(HiddenLine, HasNarrowerDashes) {
  const auto red_beside = [&](double dashes, double beside) {
    int most = 0;
    const Image image = drawn(0.4f, static_cast<float>(dashes));
    for (double x = -0.2; x < 0.2; x += 0.005)
      most = std::max(most, red_at(image, x, beside));
    return most;
  };
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(red_beside(1.0, side * kRod * (kDashBreadth - 0.1)), 0.4 * 255, 4);
    EXPECT_EQ(red_beside(1.0, side * kRod * (kDashBreadth + 0.1)), 0);
    EXPECT_NEAR(red_beside(0.0, side * kRod * 0.9), 0.4 * 255, 4) << "without dashes as in front";
  }
}

// from column to column of the picture, at both edges of each dash: no stairs, but as much red as
// the edge leaves of the pixel
TEST_F(HiddenLine, HasDashesWithSmoothEdges) {
  const Image image = drawn(0.4f, 1.0f);
  const Vec3 across = Vec3::UnitX().cross(camera_.eye()).normalized();
  int partly = 0;
  for (double x = -0.3; x < 0.3; x += 0.003) {
    const double phase = std::fmod((x + 1.0) / 0.09, 1.0);
    if (phase < 0.15 || phase > 0.35) continue;
    for (const double side : {-1.0, 1.0}) {
      const Vec2 edge = camera_.project(Vec3(x, 0, 0) + side * kDashBreadth * kRod * across);
      const Vec2 inside = camera_.project(Vec3(x, 0, 0));
      const int inwards = inside.y() > edge.y() ? 1 : -1;
      for (int k = 0; k < 3; ++k) {
        const int row = static_cast<int>(edge.y()) + k * inwards;
        const double depth = (row + 0.5 - edge.y()) * inwards;  // px inside the edge
        const int red = image.at(static_cast<int>(edge.x()), row)[0];
        EXPECT_NEAR(red, 0.4 * 255 * std::clamp(depth, 0.0, 1.0), 0.25 * 0.4 * 255)
            << x << ' ' << depth;
        partly += red > 10 && red < 92 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(partly, 60);
}

}  // namespace
}  // namespace polhode
