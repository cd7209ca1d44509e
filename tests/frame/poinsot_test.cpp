// SPDX-License-Identifier: MIT
// What is drawn of Poinsot's and Binet's pictures, against mechanics.
#include <cmath>

#include <gtest/gtest.h>

#include "frame/compose.h"
#include "frame/elements/parts.h"
#include "math/so3.h"
#include "support/motions.h"
#include "support/show_only.h"

namespace polhode {
namespace {

ShowSpec poinsot() {
  ShowSpec show;
  for (const char* name : {"ellipsoid", "plane", "polhode", "herpolhode", "binet", "polhodes"})
    show[name] = true;
  return show;
}

Composer picture_of(const BodySpec& body, const Vec3& spin) {
  MotionSpec spec = test::wobbling();
  spec.spin.body = spin;
  return {test::moving(body, spec), body, CameraSpec{}, poinsot(), {}, {640, 360}};
}

const Vec3 kSpins[] = {{1.0, 0.8, 2.0}, {2.0, 0.5, 0.3}, {0.1, 1.5, 0.1}};

// the ellipsoid touches the plane at the tip of omega, and lies on one side of it
TEST(Poinsot, TheEllipsoidTouchesThePlaneAtTheTipOfOmega) {
  for (const Vec3& spin : kSpins) {
    const Composer picture = picture_of(test::brick_body(), spin);
    for (const double t : {0.0, 0.7, 2.9}) {
      const Sample now = picture.scenery().motion.at(t);
      const Glyphs glyphs = picture.glyphs_at(now);
      const SheetGlyph& plane = glyphs.sheets.front();
      const Placement& ellipsoid = glyphs.shells.front().space_from_mesh;
      const Vec3 tip = omega_tip(picture.scenery(), now);
      const double size = picture.scenery().scale.body;
      EXPECT_NEAR((tip - plane.point).dot(plane.normal), 0.0, 1e-9 * size);
      EXPECT_NEAR((ellipsoid.inverse() * tip).norm(), 1.0, 1e-9);
      // the farthest point of an ellipsoid A x along n is A A^T n / |A^T n|
      const Vec3 a = ellipsoid.linear().transpose() * plane.normal;
      const Vec3 farthest = ellipsoid.translation() + ellipsoid.linear() * a / a.norm();
      EXPECT_NEAR((farthest - tip).norm(), 0.0, 1e-7 * size);
    }
  }
}

// rolling without slipping: the body's point at the contact is at rest, as omega passes through it
TEST(Poinsot, TheContactDoesNotSlip) {
  const Composer picture = picture_of(test::brick_body(), kSpins[0]);
  const Motion& motion = picture.scenery().motion;
  const double h = 1e-4;
  for (const double t : {0.4, 1.9}) {
    const Sample now = motion.at(t);
    const Vec3 contact_S = omega_tip(picture.scenery(), now) - now.reference_S;
    const Vec3 contact_B = now.q_SB.conjugate() * contact_S;
    const Vec3 moved =
        (motion.at(t + h).q_SB * contact_B - motion.at(t - h).q_SB * contact_B) / (2.0 * h);
    EXPECT_LT(moved.norm(), 1e-6 * contact_S.norm() * now.w_S.norm());
  }
}

// and so for the two cones of a symmetric body, all along their common line
TEST(Cones, TouchAlongOmegaAndRoll) {
  const BodySpec body = test::prolate_body();
  ShowSpec show;
  show["space_cone"] = show["body_cone"] = true;
  const Composer picture(
      test::moving(body, test::wobbling()), body, CameraSpec{}, show, {}, {640, 360});
  for (const double t : {0.0, 1.3, 3.7}) {
    const Sample now = picture.scenery().motion.at(t);
    const Glyphs glyphs = picture.glyphs_at(now);
    ASSERT_EQ(glyphs.cones.size(), 2U);
    for (const Cone& cone : glyphs.cones)
      EXPECT_NEAR(angle_between(cone.axis, now.w_S), cone.half_angle, 1e-9);
    // both axes and omega are in one plane
    EXPECT_NEAR(
        glyphs.cones[0].axis.cross(glyphs.cones[1].axis).dot(now.w_S.normalized()), 0.0, 1e-9);
  }
}

double off_surfaces(const Vec3& moments, const Vec3& w, const Vec3& start) {
  const double energy = moments.dot(w.cwiseProduct(w)) / moments.dot(start.cwiseProduct(start));
  const double momentum =
      moments.cwiseProduct(w).squaredNorm() / moments.cwiseProduct(start).squaredNorm();
  return std::max(std::abs(energy - 1.0), std::abs(momentum - 1.0));
}

// every point of a polhode has the energy and |L| of its motion, and the motion stays on it
TEST(Polhode, IsWhereEnergyAndMomentumKeepTheirValues) {
  const Vec3 moments(1.0, 2.0, 3.5);
  for (const Vec3& start : {Vec3(0.3, 0.2, 1.0),
                            Vec3(1.0, -0.3, 0.2),
                            Vec3(-0.2, 0.9, 0.3),
                            Vec3(0.01, 1.0, 0.01),
                            Vec3(0.5, 0.5, -2.0)}) {
    const std::vector<Vec3> curve = polhode(moments, start, 360);
    ASSERT_EQ(curve.size(), 360U);
    double nearest = 1e9;
    for (const Vec3& w : curve) {
      EXPECT_LT(off_surfaces(moments, w, start), 1e-9);
      nearest = std::min(nearest, (w - start).norm());
    }
    EXPECT_LT(nearest, 0.05 * start.norm());
  }
}

TEST(Polhode, OfASteadySpinIsNoCurve) {
  EXPECT_TRUE(polhode({1, 2, 3}, {0, 0, 2}, 100).empty());
  EXPECT_TRUE(polhode({1, 2, 3}, {2, 0, 0}, 100).empty());
  EXPECT_TRUE(polhode({1, 2, 3}, {0, 0, 0}, 100).empty());
  EXPECT_TRUE(polhode({2, 2, 2}, {0.3, 1, 2}, 100).empty());
}

// straight pieces stay within the tolerance of the curve
TEST(Curves, AreAsFineAsTheToleranceAsks) {
  const auto spiral = [](double s) {
    return Vec3(std::cos(7 * s), std::sin(7 * s), 0.3 * s);
  };
  for (const double tolerance : {1e-2, 1e-4}) {
    const Path path = sampled(spiral, 0.0, 3.0, 40, tolerance);
    double worst = 0.0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      for (int k = 1; k < 8; ++k) {
        const double s =
            path.parameters[i - 1] + (path.parameters[i] - path.parameters[i - 1]) * k / 8.0;
        const Vec3 from = path.points[i - 1];
        const Vec3 along = (path.points[i] - from).normalized();
        const Vec3 off = spiral(s) - from;
        worst = std::max(worst, (off - off.dot(along) * along).norm());
      }
    }
    EXPECT_LT(worst, 2.0 * tolerance);
    EXPECT_LT(path.points.size(), 40.0 / std::sqrt(tolerance));
  }
}

// revealed up to any time, a trail ends where the point is
TEST(Trails, EndWhereThePointIs) {
  const BodySpec body = test::prolate_body();
  ShowSpec show;
  show["trail"] = true;
  const Composer picture(
      test::moving(body, test::wobbling()), body, CameraSpec{}, show, {}, {640, 360});
  const Scenery& scenery = picture.scenery();
  for (const double t : {0.3, 1.234, 4.0}) {
    const Sample now = scenery.motion.at(t);
    const Vec3 tip =
        now.reference_S + kTrailRadius * scenery.scale.body * (now.q_SB * figure_axis_B(scenery));
    const std::vector<MeshPtr> meshes = scenery.paths.axis.part(0.0, t);
    ASSERT_FALSE(meshes.empty());
    // the last ring of the tube is around the tip
    Vec3 middle = Vec3::Zero();
    const std::vector<Vertex>& vertices = meshes.back()->vertices;
    for (std::size_t i = vertices.size() - 8; i < vertices.size(); ++i)
      middle += to_eigen(vertices[i].position) / 8.0;
    EXPECT_LT((scenery.paths.axis.place() * middle - tip).norm(), 2e-3 * scenery.scale.body) << t;
  }
}

// the sums that make components what they are
TEST(Components, AddUpToOmega) {
  for (const char* name : {"omega_components", "euler_rates"}) {
    const BodySpec body = test::brick_body();
    const Composer picture(test::moving(body, test::wobbling()),
                           body,
                           CameraSpec{},
                           test::show_only(name),
                           {},
                           {640, 360});
    const Sample now = picture.scenery().motion.at(1.1);
    Vec3 sum = Vec3::Zero();
    for (const ArrowGlyph& arrow : picture.glyphs_at(now).arrows)
      sum += arrow.tip - arrow.from;
    EXPECT_LT((sum - picture.scenery().scale.omega * now.w_S).norm(), 1e-12) << name;
  }
}

// dL/dt is the torque that is drawn
TEST(Torque, IsTheRateOfL) {
  const BodySpec body = test::cone_body();
  const Composer picture(test::moving(body, test::spinning_on_pivot()),
                         body,
                         CameraSpec{},
                         test::show_only("torque"),
                         {},
                         {640, 360});
  const Motion& motion = picture.scenery().motion;
  const double h = 1e-5;
  for (const double t : {0.3, 1.0}) {
    const Vec3 rate = (motion.at(t + h).L_S - motion.at(t - h).L_S) / (2.0 * h);
    const ArrowGlyph arrow = picture.glyphs_at(motion.at(t)).arrows.at(0);
    const Vec3 drawn = (arrow.tip - arrow.from) / picture.scenery().scale.torque;
    EXPECT_LT((drawn - rate).norm(), 1e-6 * rate.norm());
  }
}

}  // namespace
}  // namespace polhode
