// SPDX-License-Identifier: MIT
// GCC 12 sees members without a value where the whole struct is written by its initializer
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "frame/glyphs.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "frame/composers.h"
#include "frame/to_glm.h"
#include "math/so3.h"

namespace polhode {
namespace {

using test::drawn;

const GlyphMeshes kMeshes{arrow_meshes(16, 16), arrow_meshes(8, 8), cone_meshes(32)};

MeshGlyph disc_at(const Vec3& center, float alpha) {
  MeshGlyph glyph{std::make_shared<const Mesh>(unit_disc(16)), Placement::Identity(), {}};
  glyph.space_from_mesh.translation() = center;
  glyph.material.alpha = alpha;
  return glyph;
}

DrawList items_of(const Glyphs& glyphs, const Vec3& eye, const DrawingFrame& frame = {}) {
  DrawList list;
  add_items(glyphs, kMeshes, frame, eye, list);
  return list;
}

// an arc runs in the plane of its two directions, on its circle, at a constant rate
TEST(Glyphs, AnArcIsPartOfACircle) {
  const Vec3 from(1, 0, 0), to = Vec3(-0.5, 1, 0.3).normalized();
  const ArcGlyph arc{Vec3(1, 2, 3), from, to, 0.7, 0.01, {}};
  EXPECT_LT((point_of(arc, 0.0) - arc.center - 0.7 * from).norm(), 1e-15);
  EXPECT_LT((point_of(arc, 1.0) - arc.center - 0.7 * to).norm(), 1e-15);
  for (const double part : {0.25, 0.5, 0.9}) {
    const Vec3 out = point_of(arc, part) - arc.center;
    EXPECT_NEAR(out.norm(), 0.7, 1e-15);
    EXPECT_NEAR(out.dot(from.cross(to)), 0.0, 1e-15);
    EXPECT_NEAR(angle_between(from, out), part * angle_between(from, to), 1e-12);
  }
}

// A point of an ellipsoid is on the near side if the way from it to the eye leaves the ellipsoid.
TEST(Glyphs, CurvesOnAnEllipsoidKnowTheirFarSide) {
  Placement ellipsoid = Placement::Identity();
  ellipsoid.linear() =
      Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()) * Vec3(0.3, 0.5, 0.8).asDiagonal();
  ellipsoid.translation() = Vec3(0.2, -0.1, 0.4);
  Placement mesh = Placement::Identity();
  mesh.linear() = 0.5 * Eigen::AngleAxisd(-1.1, Vec3::UnitY()).toRotationMatrix();
  mesh.translation() = Vec3(0.1, 0.3, 0.2);
  const DrawingFrame frame{Vec3(0.2, 0.0, 0.1), 0.4};
  Glyphs glyphs;
  glyphs.meshes.push_back({std::make_shared<const Mesh>(unit_disc(8)), mesh, {}, {}, ellipsoid});
  int near_ones = 0, all = 0;
  for (const Vec3& eye : {Vec3(3, 1, 0.5), Vec3(-0.4, 1.5, 2), Vec3(0, 0, -9)}) {
    const glm::vec4 plane = items_of(glyphs, eye, frame).opaque.front().material.near_side;
    for (const double up : {-0.9, -0.4, 0.1, 0.7}) {
      for (int k = 0; k < 12; ++k) {
        const double across = std::sqrt(1.0 - up * up);
        const Vec3 on_ball(across * std::cos(0.5 * k), across * std::sin(0.5 * k), up);
        const Vec3 point = ellipsoid * on_ball;
        const Vec3 a_little_on = ellipsoid.inverse() * (point + 1e-4 * (eye - point));
        const Vec3 in_mesh = mesh.inverse() * point;
        const double side = in_mesh.dot(Vec3(plane.x, plane.y, plane.z)) + plane.w;
        EXPECT_EQ(side > 0.0, a_little_on.norm() > 1.0) << on_ball.transpose();
        near_ones += side > 0.0 ? 1 : 0;
        ++all;
      }
    }
  }
  EXPECT_GT(near_ones, all / 5);
  EXPECT_LT(near_ones, all / 2) << "less than half of a ball is seen";
}

// the items are where the glyphs are, in the frame's own coordinates
TEST(Glyphs, ItemsAreMovedAndScaledIntoTheFrame) {
  const DrawingFrame frame{Vec3(1000, 0, 0), 1e-3};
  Glyphs glyphs;
  glyphs.arrows.push_back({Vec3(1000, 0, 0), Vec3(1000, 0, 2e-3), {1e-5, 3e-5, 9e-5}, {}});
  glyphs.meshes.push_back(disc_at(Vec3(1000, 1e-3, 0), 1.0f));
  const DrawList list = items_of(glyphs, Vec3(1001, 0, 0), frame);
  ASSERT_EQ(list.opaque.size(), 3u);
  EXPECT_LT((drawn(list.opaque[0], Vec3::Zero()) - Vec3(0, 1, 0)).norm(), 1e-6);
  EXPECT_LT((drawn(list.opaque[0], Vec3::UnitX()) - Vec3(1000, 1, 0)).norm(), 1e-3);
  EXPECT_LT((drawn(list.opaque[2], Vec3::UnitZ()) - Vec3(0, 0, 2)).norm(), 1e-6);
}

// everything that is drawn lies within the box of the points that the camera frames
TEST(Glyphs, ExtentReachesAsFarAsWhatIsDrawn) {
  Glyphs glyphs;
  glyphs.arrows.push_back({Vec3(-1, 0, 0), Vec3(0, 3, 0), {1e-4, 3e-4, 9e-4}, {}});
  glyphs.arcs.push_back({Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), 2.0, 1e-4, {}});
  Cone cone;
  cone.axis = Vec3(0, -1, 0);
  cone.half_angle = 0.5;
  cone.slant = 2.0;
  cone.rim_radius = 1e-4;
  glyphs.cones.push_back(cone);
  std::vector<Vec3> points;
  add_extent(glyphs, points);
  Vec3 low = Vec3::Constant(1e9), high = -low;
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  EXPECT_LT((high - Vec3(2, 3, 2)).norm(), 1e-6);
  EXPECT_NEAR(low.y(), -2.0 * std::cos(0.5), 1e-12);
  EXPECT_NEAR(low.x(), -1.0, 1e-12);
  EXPECT_NEAR(low.z(), -2.0 * std::sin(0.5), 1e-12);
}

// a sheet is drawn before what it stands behind and after what it stands in front of
TEST(Glyphs, SheetsAreDrawnBehindOrInFrontOfTheRest) {
  Glyphs glyphs;
  glyphs.middle = Vec3::Zero();
  glyphs.shells.push_back(disc_at(Vec3::Zero(), 0.5f));
  glyphs.sheets.push_back({disc_at(Vec3(0, 0, -2), 0.25f), Vec3(0, 0, -2), Vec3::UnitZ()});
  const auto sheet_at = [&](const Vec3& eye) {
    const DrawList list = items_of(glyphs, eye);
    EXPECT_EQ(list.translucent.size(), 3u);  // two sides of the shell
    const auto sheet =
        std::find_if(list.translucent.begin(), list.translucent.end(), [](const DrawItem& item) {
          return item.material.alpha == 0.25f;
        });
    return sheet - list.translucent.begin();
  };
  EXPECT_EQ(sheet_at(Vec3(0, 0, 9)), 0) << "seen from the side of the rest";
  EXPECT_EQ(sheet_at(Vec3(0, 0, -9)), 2) << "seen from beyond the sheet";
}

// what comes or goes is blended, and only what was added since
TEST(Glyphs, OnlyNewOnesFade) {
  Glyphs glyphs;
  glyphs.meshes.push_back(disc_at(Vec3::Zero(), 1.0f));
  glyphs.labels.push_back({});
  const GlyphCounts before(glyphs);
  glyphs.meshes.push_back(disc_at(Vec3::UnitX(), 1.0f));
  glyphs.sheets.push_back({disc_at(Vec3::UnitY(), 0.5f), Vec3::UnitY(), Vec3::UnitZ()});
  glyphs.labels.push_back({});
  fade_new(glyphs, before, 0.25);
  EXPECT_EQ(glyphs.meshes[0].material.fade, 1.0f);
  EXPECT_EQ(glyphs.meshes[1].material.fade, 0.25f);
  EXPECT_EQ(glyphs.sheets[0].mesh.material.fade, 0.25f);
  EXPECT_EQ(glyphs.labels[0].fade, 1.0f);
  EXPECT_EQ(glyphs.labels[1].fade, 0.25f);
  const DrawList list = items_of(glyphs, Vec3(0, 0, 9));
  EXPECT_EQ(list.opaque.size(), 1u);
  ASSERT_EQ(list.translucent.size(), 2u);
  EXPECT_EQ(list.translucent[1].material.alpha, 1.0f)
      << "the opaque one that comes, over the sheet";
}

}  // namespace
}  // namespace polhode
