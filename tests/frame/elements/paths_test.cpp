// SPDX-License-Identifier: MIT
// Paths that a film reveals, and the curves of a whole film.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "frame/compose.h"
#include "frame/elements/parts.h"
#include "support/motions.h"
#include "support/show_only.h"

namespace polhode {
namespace {

// revealed up to any time, a trail ends where the point is
TEST(Paths, TrailEndsWhereThePointIs) {
  const BodySpec body = test::prolate_body();
  ShowSpec show;
  show["trail"] = true;
  const Composer picture(
      test::moving(body, test::wobbling()), body, CameraSpec{}, show, {}, {640, 360});
  const Scenery& scenery = picture.scenery();
  for (const double t : {0.3, 1.234, 4.0}) {
    const Sample now = scenery.motion.at(t);
    const Vec3 tip = now.reference_S + kTrailRadius * scenery.scale.body *
                                           (now.q_SB * figure_axis_B(scenery.motion.model()));
    const std::vector<MeshPtr> meshes = scenery.paths.axis.part(0.0, t);
    ASSERT_FALSE(meshes.empty());
    // the last ring of the tube is around the tip
    Vec3 middle = Vec3::Zero();
    const std::vector<Vertex>& vertices = meshes.back()->vertices;
    for (std::size_t i = vertices.size() - 8; i < vertices.size(); ++i)
      middle += to_eigen(vertices[i].position) / 8.0;
    EXPECT_LT((scenery.paths.axis.place() * middle - tip).norm(), 2e-3 * scenery.scale.body) << t;
    // and the axis of the body reaches as far
    const std::vector<RodGlyph> rods = picture.glyphs_at(now).rods;
    ASSERT_EQ(rods.size(), 1u);
    EXPECT_LT((rods[0].from - now.reference_S).norm(), 1e-12);
    EXPECT_LT((rods[0].to - tip).norm(), 1e-12);
  }
}

// a ball that is dropped leaves no path in the air: it begins where the ball has come down to a
// hundredth of its radius, and goes on to the end
TEST(Paths, OfTheContactBeginWhereTheBodyTouches) {
  const double radius = 0.1, fall = 0.2, g = 9.80665;
  MotionSpec spec;
  spec.hold = "table";
  spec.duration = 0.6;
  spec.position = Vec3(0.0, 0.0, radius + fall);
  spec.velocity = Vec3(0.3, 0.0, 0.0);
  const BodySpec body = test::ellipsoid_body(Vec3::Constant(radius));
  const Composer picture(test::moving(body, spec),
                         body,
                         CameraSpec{},
                         test::show_only("contact_trail"),
                         {},
                         {640, 360});
  const Scenery& scenery = picture.scenery();
  ASSERT_EQ(scenery.paths.contact.size(), 1u);
  const Path& path = scenery.paths.contact.front().path();
  const double near = std::sqrt(2.0 * (fall - 0.01 * scenery.scale.body) / g);
  EXPECT_NEAR(path.parameters.front(), near, 1e-6);
  EXPECT_NEAR(path.points.front().x(), 0.3 * near, 1e-6);
  EXPECT_EQ(path.parameters.back(), spec.duration);
  const auto is_drawn = [&](double t) {
    const std::vector<PathGlyph> paths = picture.glyphs_at(scenery.motion.at(t)).paths;
    return std::any_of(paths.begin(), paths.end(), [](const PathGlyph& one) {
      return !one.trail->part(one.from, one.to).empty();
    });
  };
  EXPECT_FALSE(is_drawn(0.9 * near));
  EXPECT_TRUE(is_drawn(0.5));
}

// the tips of vectors are on their paths at any time, to half a pixel
TEST(Paths, TipsOfVectorsDrawTheirPaths) {
  const BodySpec body = test::cone_body();
  ShowSpec show = test::show_only("omega");
  show.trail_tips = {"omega", "momentum"};
  const Composer picture(
      test::moving(body, test::spinning_on_pivot()), body, CameraSpec{}, show, {}, {640, 360});
  const Scenery& scenery = picture.scenery();
  const auto off_path = [&](const Trail& trail, const Vec3& tip) {
    const std::vector<Vec3>& points = trail.path().points;
    double least = 1e300;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec3 way = points[i] - points[i - 1];
      const double part = std::clamp((tip - points[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (points[i - 1] + part * way - tip).norm());
    }
    return least;
  };
  const double half_pixel = 0.5 / picture.camera().pixels_per_metre(Vec3::Zero());
  for (double t = 0.0; t < scenery.motion.duration(); t += 0.013) {
    const Sample now = scenery.motion.at(t);
    EXPECT_LT(off_path(scenery.paths.omega_tip, omega_tip(scenery, now)), half_pixel) << t;
    EXPECT_LT(off_path(scenery.paths.momentum_tip, momentum_tip(scenery, now)), half_pixel) << t;
  }
}

// `trail_length` seconds back and no farther: each corner of the tube is on that part of the path
TEST(Paths, TrailIsAsLongAsTheSceneAsks) {
  const BodySpec body = test::prolate_body();
  ShowSpec show = test::show_only("trail");
  show.trail_s = 0.5;
  const Composer picture(
      test::moving(body, test::wobbling()), body, CameraSpec{}, show, {}, {640, 360});
  const Scenery& scenery = picture.scenery();
  const double now = 2.0;
  const auto tip = [&](double t) {
    const Sample s = scenery.motion.at(t);
    return Vec3(s.reference_S + kTrailRadius * scenery.scale.body *
                                    (s.q_SB * figure_axis_B(scenery.motion.model())));
  };
  const Glyphs glyphs = picture.glyphs_at(scenery.motion.at(now));
  ASSERT_EQ(glyphs.paths.size(), 1u);
  const PathGlyph& path = glyphs.paths.front();
  const Placement space_from_mesh = path.space_from_path * path.trail->place();
  double earliest = now, farthest = 0.0;
  for (const MeshPtr& mesh : path.trail->part(path.from, path.to)) {
    for (const Vertex& vertex : mesh->vertices) {
      const Vec3 point = space_from_mesh * to_eigen(vertex.position);
      double nearest = 1e9, at = now;
      for (double t = now - 1.0; t <= now; t += 0.005) {
        const double distance = (tip(t) - point).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        at = t;
      }
      earliest = std::min(earliest, at);
      farthest = std::max(farthest, nearest);
    }
  }
  EXPECT_NEAR(earliest, now - 0.5, 0.02);
  EXPECT_LT(farthest, 2.0 * kRimRadius * scenery.scale.body);
}

// the body's curve is the polhode of its start, in the scale of omega
TEST(Paths, PolhodeIsThatOfTheStart) {
  const BodySpec body = test::brick_body();
  const Composer picture(test::moving(body, test::wobbling()),
                         body,
                         CameraSpec{},
                         test::show_only("polhode"),
                         {},
                         {640, 360});
  const Scenery& scenery = picture.scenery();
  const BodyModel& model = scenery.motion.model();
  const Vec3 start = principal_rate(model, scenery.motion.at(0.0));
  const double energy2 = twice_the_energy(model, start);
  const MeshPtr mesh = scenery.paths.polhode;
  ASSERT_TRUE(mesh);
  for (const Vertex& vertex : mesh->vertices) {
    // from a corner of the tube to the curve along the normal
    const Vec3 w = scenery.scale.body / scenery.scale.omega *
                   (to_eigen(vertex.position) - kCurveRadius * to_eigen(vertex.normal));
    EXPECT_NEAR(twice_the_energy(model, w) / energy2, 1.0, 1e-5);
  }
}

}  // namespace
}  // namespace polhode
