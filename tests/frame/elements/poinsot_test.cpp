// SPDX-License-Identifier: MIT
// What is drawn of Poinsot's and Binet's pictures, against mechanics.
#include <cmath>

#include <gtest/gtest.h>

#include "frame/compose.h"
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

}  // namespace
}  // namespace polhode
