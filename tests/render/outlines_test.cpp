// SPDX-License-Identifier: MIT
// Outlines against geometry; no OpenGL: what a rasteriser would draw is computed here.
#include "render/outlines.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "frame/camera.h"
#include "frame/to_glm.h"

namespace polhode {
namespace {

int seen_edges(const Mesh& mesh, const glm::vec3& eye) {
  int count = 0;
  MeshEdges(mesh).each_seen(eye, [&](const glm::vec3&, const glm::vec3&) { ++count; });
  return count;
}

// of a box one sees the four edges of a face, the seven of two, or the nine of three
TEST(Outlines, EdgesOfABoxAreThoseOfTheFacesThatOneSees) {
  const Mesh mesh = box({1, 1, 1});
  EXPECT_EQ(seen_edges(mesh, {0, 0, 9}), 4);
  EXPECT_EQ(seen_edges(mesh, {9, 9, 0}), 7);
  EXPECT_EQ(seen_edges(mesh, {9, -9, 9}), 9);
  EXPECT_FLOAT_EQ(MeshEdges(mesh).reach(), 0.5f);
}

// from an eye at distance d of its centre, the contour of the unit sphere is where x.e = 1 / d
TEST(Outlines, OfASphereAreItsContour) {
  const glm::vec3 eye(1.0f, -2.0f, 1.5f);
  const float distance = glm::length(eye);
  int count = 0;
  MeshEdges(unit_sphere(128)).each_seen(eye, [&](const glm::vec3& a, const glm::vec3& b) {
    for (const glm::vec3& end : {a, b})
      EXPECT_NEAR(glm::dot(end, eye) / distance, 1.0f / distance, 0.05f);
    ++count;
  });
  EXPECT_GT(count, 100);
}

// the rim of a surface that is open is an outline from both sides
TEST(Outlines, BordersAreSeenFromBothSides) {
  const Mesh disc = unit_disc(40);
  EXPECT_EQ(seen_edges(disc, {0, 0, 3}), 40);
  EXPECT_EQ(seen_edges(disc, {0, 0, -3}), 40);
}

constexpr int kWidth = 96, kHeight = 64;

// A square of side 2 in the plane x = 0, turned in it, seen from +x; as a rasteriser with one
// sample draws it: white on black.
struct Square {
  explicit Square(double angle) : turn(angle) {
    item.mesh = std::make_shared<const Mesh>(box({1e-4, 2.0, 2.0}));
    Placement place = Placement::Identity();
    place.linear() = Eigen::AngleAxisd(turn, Vec3::UnitX()).toRotationMatrix();
    item.world_from_mesh = to_glm(place.matrix());
    image.wipe(kWidth, kHeight, {0, 0, 0, 255});
    depth.assign(static_cast<std::size_t>(kWidth * kHeight), 1.0f);
    const glm::vec4 clip = camera.view().clip_from_world * glm::vec4(0, 0, 0, 1);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (!inside(x + 0.5, y + 0.5)) continue;
        std::fill_n(image.at(x, y), 4, std::uint8_t{255});
        depth[static_cast<std::size_t>(y * kWidth + x)] = 0.5f + 0.5f * clip.z / clip.w;
      }
    }
  }

  bool inside(double x, double y) const {
    const double metre = camera.pixels_per_metre(Vec3::Zero());
    const double u = (x - 0.5 * kWidth) / metre, v = (0.5 * kHeight - y) / metre;
    const double along = std::cos(turn) * u + std::sin(turn) * v;
    const double across = -std::sin(turn) * u + std::cos(turn) * v;
    return std::abs(along) < 1.0 && std::abs(across) < 1.0;
  }
  // how much of a pixel is inside, to a thousandth
  double coverage(int x, int y) const {
    constexpr int kParts = 64;
    int count = 0;
    for (int i = 0; i < kParts * kParts; ++i)
      count += inside(x + (i % kParts + 0.5) / kParts, y + (i / kParts + 0.5) / kParts) ? 1 : 0;
    return static_cast<double>(count) / (kParts * kParts);
  }
  // is a corner of the square within three pixels?
  bool near_corner(int x, int y) const {
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-1.0, 1.0}) {
        const Vec3 corner(
            0.0, std::cos(turn) * a - std::sin(turn) * b, std::sin(turn) * a + std::cos(turn) * b);
        if ((camera.project(corner) - Vec2(x + 0.5, y + 0.5)).norm() < 3.0) return true;
      }
    }
    return false;
  }
  void smooth() {
    OutlineSmoother smoother;
    smoother.begin(camera.view(), {0, 0, kWidth, kHeight});
    smoother.add(MeshEdges(*item.mesh), item);
    boxes = smoother.covered();
    smoother.smooth({0, 0, kWidth, kHeight}, depth, image);
  }

  double turn;
  Camera camera{Vec3(5.13, 0, 0), Vec3::Zero(), 0.6, {kWidth, kHeight}, Vec3::Zero(), 1.5};
  DrawItem item;
  Image image;
  std::vector<float> depth;
  std::vector<PixelBox> boxes;
};

// each pixel gets the colour of the area that is covered, whatever the slope of the edge
TEST(Outlines, PixelsGetTheShareThatIsCovered) {
  for (const double turn : {0.0, 0.1, 0.35, 0.7}) {
    Square square(turn);
    square.smooth();
    int partly = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (square.near_corner(x, y)) continue;
        const double wanted = 255.0 * square.coverage(x, y);
        ASSERT_NEAR(square.image.at(x, y)[1], wanted, 6.0) << turn << ": " << x << ' ' << y;
        partly += wanted > 20.0 && wanted < 235.0 ? 1 : 0;
      }
    }
    EXPECT_GT(partly, 50) << turn;
  }
}

// a floor below the eye that reaches behind it covers all that is below the horizon
TEST(Outlines, AFloorThatReachesBehindTheEyeIsCovered) {
  Mesh floor;
  for (const auto& [x, y] : {std::pair(-9.0f, -9.0f), {9.0f, -9.0f}, {9.0f, 9.0f}, {-9.0f, 9.0f}})
    floor.vertices.push_back({{x, y, 0.0f}, {0.0f, 0.0f, 1.0f}});
  floor.indices = {0, 1, 2, 0, 2, 3};
  DrawItem item;
  item.mesh = std::make_shared<const Mesh>(floor);
  const Camera camera(Vec3(5, 1, 1), Vec3(0, 0.3, 0), 0.6, {kWidth, kHeight}, Vec3::Zero(), 1.0);
  OutlineSmoother smoother;
  smoother.begin(camera.seeing_farther(8.0).view(), {0, 0, kWidth, kHeight});
  smoother.add(MeshEdges(floor), item);
  const std::vector<PixelBox> boxes = smoother.covered();
  for (int y = kHeight / 2; y < kHeight; ++y) {
    for (const int x : {0, kWidth / 2, kWidth - 1}) {
      EXPECT_TRUE(std::any_of(boxes.begin(),
                              boxes.end(),
                              [&](const PixelBox& box) {
                                return x >= box.x && x < box.right() && y >= box.y &&
                                       y < box.bottom();
                              }))
          << x << ' ' << y;
    }
  }
}

// an outline behind something nearer does not show
TEST(Outlines, WhatIsHiddenStaysHidden) {
  Square square(0.35);
  const Image before = square.image;
  std::fill(square.depth.begin(), square.depth.end(), 0.0f);
  square.smooth();
  EXPECT_EQ(square.image.pixels, before.pixels);
}

// depths are left as they were, and every pixel of the thing lies in the boxes
TEST(Outlines, BoxesHoldEverythingThatIsDrawn) {
  Square square(0.35);
  const std::vector<float> before = square.depth;
  square.smooth();
  EXPECT_EQ(square.depth, before);
  long area = 0;
  for (const PixelBox& one : square.boxes)
    area += static_cast<long>(one.width) * one.height;
  EXPECT_LT(area, kWidth * kHeight) << "less than the whole picture";
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (square.image.at(x, y)[1] == 0) continue;
      const auto holds = [&](const PixelBox& one) {
        return x >= one.x && x < one.right() && y >= one.y && y < one.bottom();
      };
      ASSERT_EQ(std::count_if(square.boxes.begin(), square.boxes.end(), holds), 1);
    }
  }
}

}  // namespace
}  // namespace polhode
