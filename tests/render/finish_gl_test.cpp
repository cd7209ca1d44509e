// SPDX-License-Identifier: MIT
// Finishes of surfaces against the same picture drawn larger: what is finer than pixels must be
// gone, not become rings and stripes.
#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "frame/camera.h"
#include "frame/to_glm.h"
#include "render/renderer.h"

namespace polhode {
namespace {

constexpr int kMetalSide = 160;    // pixels of the small picture
constexpr int kMetalMargin = 16;   // pixels of it that are not looked at
constexpr int kTimesLarger = 4;    // times as many in the large one
constexpr double kMetalFov = 0.5;  // rad

// a square face upwards with this middle, of small pieces, so that what is interpolated hardly
// bends
MeshPtr face(const Vec3& middle, double side) {
  constexpr int kPieces = 64;
  Mesh mesh;
  for (int y = 0; y <= kPieces; ++y) {
    for (int x = 0; x <= kPieces; ++x) {
      const Vec3 away(x - 0.5 * kPieces, y - 0.5 * kPieces, 0.0);
      mesh.vertices.push_back({to_glm(Vec3(middle + side / kPieces * away)), {0.0f, 0.0f, 1.0f}});
    }
  }
  for (std::uint32_t y = 0; y < kPieces; ++y) {
    for (std::uint32_t x = 0; x < kPieces; ++x) {
      const std::uint32_t a = y * (kPieces + 1) + x, d = a + kPieces + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
    }
  }
  return std::make_shared<const Mesh>(std::move(mesh));
}

// A face of metal that fills the picture, seen along `towards_eye` from so far (m) that the pixels
// of the small picture are that large in units of the finish. No part of its mark is seen.
Image metal_face(bool turned, const Vec3& towards_eye, double pixel, int larger) {
  const PictureSize size{larger * kMetalSide, larger * kMetalSide};
  const double across = pixel * kMetalSide;
  const Vec3 target(8.0 * across, 6.0 * across, 0.0);
  const double far = across / (2.0 * std::tan(0.5 * kMetalFov));
  const Camera camera(
      target + far * towards_eye.normalized(), target, kMetalFov, size, target, far);
  DrawList list;
  list.view = camera.view();
  list.background = glm::vec3(1.0f, 0.0f, 0.0f);
  DrawItem item;
  item.mesh = face(target, 6.0 * across);
  item.material.color = glm::vec3(0.6f);
  item.material.grain = 1.0f;
  item.material.finish = Finish::metal;
  item.material.turned = turned;
  list.opaque.push_back(item);
  const std::unique_ptr<Context> context = open_context("osmesa");
  Renderer renderer(*context, {size.width, size.height, 0, false, Edges::samples});
  Image image;
  renderer.draw(list, image);
  return image;
}

// Differences, in levels of 0..255, between the means of `block` x `block` pixels of a picture and
// of what the large one has there.
struct Off {
  double mean = 0.0, largest = 0.0;
};
Off off_means(const Image& image, const Image& large, int block) {
  const auto mean_of = [](const Image& of, int x, int y, int side) {
    double mean = 0.0;
    for (int k = 0; k < side * side; ++k)
      mean += of.at(side * x + k % side, side * y + k / side)[1];
    return mean / (side * side);
  };
  Off off;
  // not near the edges, where triangles are clipped and the rasteriser is less exact
  const int first = kMetalMargin / block, end = (kMetalSide - kMetalMargin) / block;
  for (int y = first; y < end; ++y) {
    for (int x = first; x < end; ++x) {
      const double here =
          std::abs(mean_of(image, x, y, block) - mean_of(large, x, y, kTimesLarger * block));
      off.mean += here / ((end - first) * (end - first));
      off.largest = std::max(off.largest, here);
    }
  }
  return off;
}

// the most that a pixel of the middle row differs from the mean of those six to the left and right
double roughness(const Image& image) {
  double most = 0.0;
  const int y = image.height / 2;
  for (int x = kMetalMargin; x < image.width - kMetalMargin; ++x) {
    const double around = 0.5 * (image.at(x - 6, y)[1] + image.at(x + 6, y)[1]);
    most = std::max(most, std::abs(image.at(x, y)[1] - around));
  }
  return most;
}

// Moire is coarser than pixels, so it is in the means of some of them; single pixels may differ by
// strokes that are about to fade.
TEST(Finish, BrushedMetalHasNoMoireAtAnySize) {
  for (const bool turned : {false, true}) {
    for (const Vec3& towards_eye :
         {Vec3(0.02, -0.01, 1), Vec3(0.7, 0.5, 0.5), Vec3(-1, 0.3, 0.6)}) {
      for (double pixel = 0.01; pixel < 1.0; pixel *= 1.37) {
        const Image image = metal_face(turned, towards_eye, pixel, 1);
        const Image large = metal_face(turned, towards_eye, pixel, kTimesLarger);
        const Off pixels = off_means(image, large, 1);
        const Off blocks = off_means(image, large, 8);
        SCOPED_TRACE(::testing::Message()
                     << turned << ' ' << towards_eye.transpose() << ' ' << pixel);
        EXPECT_LT(pixels.mean, 2.2);
        EXPECT_LT(pixels.largest, 6.0);
        EXPECT_LT(blocks.mean, 0.3);
        EXPECT_LT(blocks.largest, 0.7);
      }
    }
  }
}

// the strokes are there, but calm; far away the metal is smooth
TEST(Finish, BrushedMetalIsCalm) {
  const Vec3 above(0.02, -0.01, 1);
  for (const double pixel : {0.01, 0.02, 0.04}) {
    const double seen = roughness(metal_face(false, above, pixel, 1));
    EXPECT_GE(seen, 3.0) << pixel;
    EXPECT_LE(seen, 12.0) << pixel;
  }
  EXPECT_LE(roughness(metal_face(false, above, 0.8, 1)), 1.0);
}

}  // namespace
}  // namespace polhode
