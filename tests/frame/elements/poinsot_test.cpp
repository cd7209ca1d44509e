// SPDX-License-Identifier: MIT
// What is drawn of Poinsot's and Binet's pictures, against mechanics.
#include <algorithm>
#include <cmath>
#include <string>

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

// the curves of other motions reach farther than omega does, with or without their ellipsoid
TEST(Poinsot, OtherPolhodesStayInThePicture) {
  constexpr double kWidth = 640.0, kHeight = 360.0;
  for (const Vec3& spin : kSpins) {
    MotionSpec spec = test::wobbling();
    spec.spin.body = spin;
    ShowSpec show = test::show_only("polhodes");
    show["omega"] = true;
    show.vector_length = 2.5;
    const BodySpec body = test::brick_body();
    const Composer picture(test::moving(body, spec), body, CameraSpec{}, show, {}, {640, 360});
    for (const double t : {0.0, 0.9, 2.9}) {
      const Camera camera = picture.camera_at(t);
      int curves = 0;
      for (const MeshGlyph& glyph : picture.glyphs_at(picture.scenery().motion.at(t)).meshes) {
        if (!glyph.ellipsoid) continue;
        ++curves;
        for (const Vertex& vertex : glyph.mesh->vertices) {
          const Vec2 p = camera.project(glyph.space_from_mesh * to_eigen(vertex.position));
          ASSERT_TRUE(p.x() > 0.0 && p.x() < kWidth && p.y() > 0.0 && p.y() < kHeight)
              << p.transpose() << " at " << t << " s";
        }
      }
      EXPECT_GT(curves, 10);
    }
  }
}

// A plane below the ellipsoid has the shadow of it: from what is dark, a ray to the lamp meets the
// ellipsoid or passes as near as the lamp's size allows. The lamp is above: one overhead has none.
TEST(Poinsot, TheEllipsoidThrowsItsShadowOnThePlaneBelow) {
  for (const Vec3& spin : kSpins) {
    for (const double side : {-1.0, 1.0}) {
      MotionSpec spec = test::wobbling();
      spec.spin.body = side * spin;
      const BodySpec body = test::brick_body();
      ShowSpec show = test::show_only("plane");
      show["ellipsoid"] = true;
      const Composer picture(test::moving(body, spec), body, CameraSpec{}, show, {}, {640, 360});
      const Sample now = picture.scenery().motion.at(0.7);
      const DrawList list = picture.at(0.7);
      const auto shadow = std::find_if(list.translucent.begin(),
                                       list.translucent.end(),
                                       [](const DrawItem& item) { return item.material.soft; });
      ASSERT_EQ(shadow != list.translucent.end(), now.L_S.z() < 0.0);
      if (shadow == list.translucent.end()) continue;
      const Glyphs glyphs = picture.glyphs_at(now);
      const Placement& ellipsoid = glyphs.shells.front().space_from_mesh;
      const Placement& plane = glyphs.sheets.front().mesh.space_from_mesh;
      const Vec3 to_light = to_eigen(list.view.key_light);
      int dark = 0;
      for (const Vertex& vertex : shadow->mesh->vertices) {
        if (vertex.normal.z < 0.05f) continue;
        ++dark;
        const Vec3 from = ellipsoid.inverse() * (plane * to_eigen(vertex.position));
        const Vec3 ray = (ellipsoid.linear().inverse() * to_light).normalized();
        const double nearest = (from - from.dot(ray) * ray).norm();
        EXPECT_LT(nearest, 1.3) << spin.transpose();
      }
      EXPECT_GT(dark, 50);
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

// the ball is where they touch; each name is beside what it names
TEST(Poinsot, ContactAndNamesAreInTheirPlaces) {
  for (const Vec3& spin : kSpins) {
    const Composer picture = picture_of(test::brick_body(), spin);
    const double size = picture.scenery().scale.body;
    for (const double t : {1.6, 2.9}) {
      const Sample now = picture.scenery().motion.at(t);
      const Glyphs glyphs = picture.glyphs_at(now);
      const Vec3 tip = omega_tip(picture.scenery(), now);
      EXPECT_TRUE(std::any_of(glyphs.meshes.begin(), glyphs.meshes.end(), [&](const auto& glyph) {
        return glyph.mesh == picture.scenery().ball &&
               (glyph.space_from_mesh.translation() - tip).norm() < 1e-9 * size;
      }));
      const SheetGlyph& plane = glyphs.sheets.front();
      const Placement& ellipsoid = glyphs.shells.front().space_from_mesh;
      int found = 0;
      for (const LabelGlyph& label : glyphs.labels) {
        const Vec3 foot = label.at - label.away;
        const auto is = [&](const char* name) {
          return label.markup == name;
        };
        found += is("polhode") || is("herpolhode") || is("invariable plane") ? 1 : 0;
        if (is("polhode")) {
          // on the ellipsoid, and as far from the centre of Binet's as the contact
          const BodyModel& model = picture.scenery().motion.model();
          const auto momentum = [&](const Vec3& point) {
            const Vec3 w_P =
                model.R_BP.transpose() * (now.q_SB.conjugate() * Vec3(point - now.reference_S));
            return model.moments.cwiseProduct(w_P).norm();
          };
          EXPECT_NEAR((ellipsoid.inverse() * foot).norm(), 1.0, 1e-9);
          EXPECT_NEAR(momentum(foot) / momentum(tip), 1.0, 1e-9);
        } else if (is("herpolhode") || is("invariable plane")) {
          EXPECT_NEAR((foot - plane.point).dot(plane.normal), 0.0, 1e-6 * size);
        }
      }
      EXPECT_EQ(found, 3);
    }
  }
}

// seen from the body the curve stands still, and so does its name
TEST(Poinsot, TheNameOfThePolhodeStandsStillInBodyAxes) {
  for (const Vec3& spin : {Vec3(0.9, 0.15, 0.55), Vec3(0.3, 0.2, 1.9), Vec3(-2.0, 0.4, -0.2)}) {
    MotionSpec spec = test::wobbling();
    spec.spin.body = spin;
    ShowSpec show;
    show["ellipsoid"] = show["polhode"] = true;
    CameraSpec camera;
    camera.follow = "body";
    const BodySpec body = test::brick_body();
    const Composer picture(test::moving(body, spec), body, camera, show, {}, {640, 360});
    const auto place = [&](double t) {
      for (const SeenLabel& label : picture.label_view(t, 4.0).labels)
        if (label.markup == "polhode") return label.at;
      ADD_FAILURE() << "no name";
      return Vec2(0.0, 0.0);
    };
    for (const double t : {0.5, 1.0, 2.0})
      EXPECT_LT((place(t) - place(0.0)).norm(), 0.01) << t;
  }
}

// L is vertical in the picture unless the camera is given, whichever way it points in space
TEST(Poinsot, IsSeenWithLVertical) {
  const auto lean = [](const CameraSpec& camera, const char* shown, const Vec3& spin) {
    MotionSpec spec = test::wobbling();
    spec.spin.body = spin;
    const BodySpec body = test::brick_body();
    ShowSpec show;
    show[shown] = true;
    const Composer picture(test::moving(body, spec), body, camera, show, {}, {640, 360});
    const Sample now = picture.scenery().motion.at(1.3);
    const Camera seen = picture.camera_at(1.3);
    const Vec2 along =
        seen.project(momentum_tip(picture.scenery(), now)) - seen.project(now.reference_S);
    return std::abs(along.x()) / along.norm();
  };
  CameraSpec given;
  given.direction = kDefaultDirection;
  for (const Vec3& spin : {Vec3(1.0, 0.8, 2.0), Vec3(-1.5, -0.6, -1.9), Vec3(2.0, 0.5, 0.3)}) {
    EXPECT_GT(lean(given, "plane", spin), 0.02);
    // as upright as perspective lets a line beside the middle be
    for (const char* shown : {"plane", "herpolhode"})
      EXPECT_LT(lean({}, shown, spin), 0.02) << shown;
    EXPECT_GT(lean({}, "ellipsoid", spin), 0.02) << "nothing lies on a plane";
  }
}

}  // namespace
}  // namespace polhode
