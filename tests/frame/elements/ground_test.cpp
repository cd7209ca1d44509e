// SPDX-License-Identifier: MIT
// The body, where it was, and what it stands on.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "frame/compose.h"
#include "frame/elements/parts.h"
#include "frame/to_glm.h"
#include "support/motions.h"
#include "support/on_table.h"
#include "support/show_only.h"

namespace polhode {
namespace {

Composer picture_of(const BodySpec& body, const MotionSpec& motion, const ShowSpec& show) {
  return {test::moving(body, motion), body, CameraSpec{}, show, ThemeSpec{}, {640, 360}};
}

// a point of the body is drawn where mechanics says that it is
TEST(Ground, TheBodyIsWhereItsPointsAre) {
  MotionSpec motion = test::wobbling();
  motion.velocity = Vec3(0.1, -0.2, 0.3);
  const Composer picture = picture_of(test::prolate_body(), motion, test::show_only("body"));
  const Motion& solution = picture.scenery().motion;
  for (const double t : {0.0, 1.7}) {
    const Sample now = solution.at(t);
    const MeshGlyph body = picture.glyphs_at(now).meshes.at(0);
    for (const Vec3& point_B : {Vec3(0.1, 0, 0), Vec3(0, 0.02, -0.15)}) {
      const Vec3 wanted = point_position(solution.model(), now, point_B);
      EXPECT_LT((body.space_from_mesh * point_B - wanted).norm(), 1e-12);
    }
  }
}

// ghosts are the body at equal times back, the oldest first and palest
TEST(Ground, GhostsAreTheBodyOfEarlierMoments) {
  ShowSpec show = test::show_only("ghosts");
  show["body"] = true;
  show.ghost_s = 0.3;
  show.ghost_count = 4;
  const Composer picture = picture_of(test::prolate_body(), test::wobbling(), show);
  const Motion& motion = picture.scenery().motion;
  const std::vector<MeshGlyph> ghosts = picture.glyphs_at(motion.at(2.0)).ghosts;
  ASSERT_EQ(ghosts.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const double then = 2.0 - 0.3 * (4.0 - static_cast<double>(i));
    const MeshGlyph body = picture.glyphs_at(motion.at(then)).meshes.at(0);
    // a hair smaller about the centre of mass, so that no face is in the body's own
    const Placement shrunk = body.space_from_mesh.inverse() * ghosts[i].space_from_mesh;
    EXPECT_LT((shrunk.linear() - 0.996 * Mat3::Identity()).norm(), 1e-12);
    EXPECT_LT(shrunk.translation().norm(), 1e-12) << "the centre of mass is the origin here";
    if (i == 0) continue;
    EXPECT_GT(ghosts[i].material.alpha, ghosts[i - 1].material.alpha);
  }
  EXPECT_EQ(picture.glyphs_at(motion.at(0.7)).ghosts.size(), 2u) << "none before the start";
  const std::vector<MeshGlyph> coming = picture.glyphs_at(motion.at(0.63)).ghosts;
  ASSERT_EQ(coming.size(), 2u);
  EXPECT_NEAR(coming[0].material.fade, 1.0 / 3.0, 1e-6) << "it comes gently";
  EXPECT_EQ(coming[1].material.fade, 1.0f);
}

// the fixed point of a body that hangs is seen through the body
TEST(Ground, AHingeIsAtThePivot) {
  MotionSpec hanging = test::spinning_on_pivot();
  hanging.attitude.zxz = Vec3(0.0, 2.5, 0.0);
  const Composer picture = picture_of(test::cone_body(), hanging, test::show_only("hinge"));
  const MeshGlyph ball = picture.glyphs_at(picture.scenery().motion.at(0.3)).meshes.at(0);
  EXPECT_LT(ball.space_from_mesh.translation().norm(), 1e-12);
  EXPECT_GT(ball.material.hidden, 0.0f);
}

// what shows that a turntable turns goes round with it, about its middle
TEST(Ground, ATurntableCarriesItsSector) {
  MotionSpec motion = test::on_table(1.0, test::rolling());
  motion.position = Vec3(0.05, 0.02, 0.0);
  const auto sector_at = [&](double t) {
    const Composer picture = picture_of(test::ball_body(), motion, test::show_only("floor"));
    return picture.glyphs_at(picture.scenery().motion.at(t)).floors.at(0).sector;
  };
  EXPECT_EQ(sector_at(0.5).mesh, nullptr) << "at rest";
  motion.friction->turntable = 2.0;
  for (const double t : {0.0, 0.7}) {
    const MeshGlyph sector = sector_at(t);
    ASSERT_NE(sector.mesh, nullptr);
    const std::vector<Vertex>& corners = sector.mesh->vertices;
    const Vec3 tip = sector.space_from_mesh * to_eigen(corners.front().position);
    EXPECT_LT(tip.norm(), 1e-6);
    Vec3 middle = Vec3::Zero();
    for (const Vertex& corner : corners)
      middle += sector.space_from_mesh * to_eigen(corner.position);
    EXPECT_NEAR(std::remainder(std::atan2(middle.y(), middle.x()) - 2.0 * t, 2.0 * kPi), 0.0, 0.06);
  }
}

// the tip of the stand is the pivot, and it stands on the floor; so does its shadow
TEST(Ground, TheStandReachesFromTheFloorToThePivot) {
  ShowSpec show = test::show_only("pivot");
  show["floor"] = true;
  const Composer picture = picture_of(test::cone_body(), test::spinning_on_pivot(), show);
  const Sample now = picture.scenery().motion.at(0.3);
  const std::vector<MeshGlyph> meshes = picture.glyphs_at(now).meshes;
  ASSERT_EQ(meshes.size(), 1u);
  const Vec3 floor = picture.glyphs_at(now).floors.at(0).place.translation();
  ASSERT_NE(meshes[0].rough, nullptr);
  for (const MeshPtr& mesh : {meshes[0].mesh, meshes[0].rough}) {
    Vec3 tip = floor;
    double foot = now.reference_S.z();
    for (const Vertex& vertex : mesh->vertices) {
      const Vec3 point = meshes[0].space_from_mesh * to_eigen(vertex.position);
      if (point.z() > tip.z()) tip = point;
      foot = std::min(foot, point.z());
    }
    EXPECT_LT((tip - now.reference_S).norm(), 1e-15);
    EXPECT_NEAR(foot, floor.z(), 1e-7 * picture.scenery().scale.body);
  }
}

// The outer gimbal contains the vertical and the line of nodes, the inner one the line of nodes and
// the axle of the body; rods are the axle and the bearings of the inner ring; the outer one stands
// on the floor.
TEST(Ground, GimbalsTurnByTheAnglesOfEuler) {
  ShowSpec show = test::show_only("gimbals");
  show["floor"] = true;
  const Composer picture = picture_of(test::cone_body(), test::spinning_on_pivot(), show);
  const double size = picture.scenery().scale.body;
  for (const double t : {0.0, 0.3, 1.7}) {
    const Sample now = picture.scenery().motion.at(t);
    const Glyphs glyphs = picture.glyphs_at(now);
    const Vec3 up = Vec3::UnitZ(), axle = now.q_SB * Vec3::UnitZ();
    const Vec3 nodes = up.cross(axle).normalized();
    ASSERT_EQ(glyphs.meshes.size(), 3u);
    // a ring is where two of its diameters are: a direction on its circle has radius 1 in its plane
    const auto on_ring = [&](const MeshGlyph& ring, const Vec3& from_center) {
      const Vec3 at = ring.space_from_mesh.inverse() * (now.reference_S + from_center);
      return std::abs(at.z()) + std::abs(at.head<2>().norm() - 1.0);
    };
    const MeshGlyph &outer = glyphs.meshes[0], &inner = glyphs.meshes[1], &stand = glyphs.meshes[2];
    EXPECT_LT(on_ring(outer, kOuterGimbal * size * up), 1e-12);
    EXPECT_LT(on_ring(outer, kOuterGimbal * size * nodes), 1e-12);
    EXPECT_LT(on_ring(inner, kInnerGimbal * size * nodes), 1e-12);
    EXPECT_LT(on_ring(inner, kInnerGimbal * size * axle), 1e-12);
    const Vec3 tip = stand.space_from_mesh.translation();
    EXPECT_LT((tip - now.reference_S + kOuterGimbal * size * up).norm(), 1e-12);
    const Vec3 floor = glyphs.floors.at(0).place.translation();
    EXPECT_NEAR((tip - floor).z(), kStandHeight * size, 1e-12);

    ASSERT_EQ(glyphs.rods.size(), 3u);
    EXPECT_LT((glyphs.rods[0].to - glyphs.rods[0].from).cross(axle).norm(), 1e-12);
    for (const std::size_t i : {1u, 2u}) {
      const RodGlyph& bearing = glyphs.rods[i];
      EXPECT_LT((bearing.from - now.reference_S).cross(nodes).norm(), 1e-12);
      EXPECT_NEAR((bearing.to - bearing.from).norm(), (kOuterGimbal - kInnerGimbal) * size, 1e-12);
    }
  }
}

// the floor stays where it is, and the body's shadow moves over it
TEST(Ground, TheShadowFollowsTheBody) {
  MotionSpec motion = test::wobbling();
  motion.velocity = Vec3(0.2, 0.1, 0.0);
  ShowSpec show = test::show_only("floor");
  show["body"] = true;
  const Composer picture = picture_of(test::prolate_body(), motion, show);
  // the middle of the darkness, S
  const auto shade_at = [&](double t) {
    const Sample sample = picture.scenery().motion.at(t);
    const Placement floor = picture.glyphs_at(sample).floors.at(0).place;
    Vec3 sum = Vec3::Zero();
    double dark = 0.0;
    const DrawItem shadow = picture.at(t).translucent.at(2);  // after the floor and its dial
    for (const Vertex& vertex : shadow.mesh->vertices) {
      sum += vertex.normal.z * (floor * to_eigen(vertex.position));
      dark += vertex.normal.z;
    }
    return Vec3(sum / dark);
  };
  const Sample before = picture.scenery().motion.at(0.0), after = picture.scenery().motion.at(0.3);
  EXPECT_EQ(picture.glyphs_at(before).floors.at(0).place.matrix(),
            picture.glyphs_at(after).floors.at(0).place.matrix());
  const Vec3 moved = shade_at(0.3) - shade_at(0.0);
  const Vec3 body = after.center_S - before.center_S;
  EXPECT_LT((moved - body).norm(), 0.2 * body.norm());
}

// the weight of a body that stands ends above the floor, that of one that hangs is as long as ever
TEST(Ground, TheWeightEndsAboveTheFloor) {
  for (const double tilt : {0.2, 1.2, 2.9}) {
    SCOPED_TRACE(tilt);
    MotionSpec motion = test::spinning_on_pivot();
    motion.attitude.zxz = Vec3(0.0, tilt, 0.0);
    ShowSpec show = test::show_only("gravity");
    show["floor"] = true;
    const Composer picture = picture_of(test::cone_body(), motion, show);
    const Glyphs glyphs = picture.glyphs_at(picture.scenery().motion.at(0.0));
    const ArrowGlyph& weight = glyphs.arrows.at(0);
    const double floor = glyphs.floors.at(0).place.translation().z();
    const double length = (weight.tip - weight.from).norm() / picture.scenery().scale.body;
    if (tilt < 1.5) {
      EXPECT_GT(weight.tip.z(), floor);
      EXPECT_LE(length, kForceLength);
    } else {
      EXPECT_NEAR(length, kForceLength, 1e-12);
    }
  }
}

// a floor belongs to a body that stands or hovers above it
TEST(Ground, AFloorIsShownUnderWhatStandsOrHovers) {
  ThemeSpec theme;
  theme.theme = "light";
  const auto has_floor = [&](const BodySpec& body, const MotionSpec& motion) {
    const Composer picture(
        test::moving(body, motion), body, CameraSpec{}, ShowSpec{}, theme, {640, 360});
    return !picture.glyphs_at(picture.scenery().motion.at(0.0)).floors.empty();
  };
  MotionSpec hanging = test::spinning_on_pivot();
  hanging.attitude.zxz = Vec3(0.0, 2.9, 0.0);
  EXPECT_TRUE(has_floor(test::cone_body(), test::spinning_on_pivot()));
  EXPECT_FALSE(has_floor(test::cone_body(), hanging));

  EXPECT_TRUE(has_floor(test::prolate_body(), test::wobbling()));
  MotionSpec downwards = test::wobbling();
  downwards.spin.body = Vec3(0.3, 0.0, -3.0);
  downwards.attitude.zxz = Vec3::Zero();
  EXPECT_FALSE(has_floor(test::prolate_body(), downwards)) << "its vectors would go through it";
  MotionSpec thrown = test::wobbling();
  thrown.velocity = Vec3(0.5, 0.0, 0.0);
  EXPECT_FALSE(has_floor(test::prolate_body(), thrown));
  EXPECT_FALSE(has_floor(test::ellipsoid_body({30, 30, 60}), test::wobbling())) << "asteroids";
  theme.theme = "dark";
  EXPECT_FALSE(has_floor(test::prolate_body(), test::wobbling())) << "no shadow would be seen";
  EXPECT_TRUE(has_floor(test::cone_body(), test::spinning_on_pivot()));
}

// a floor would turn about a camera that turns with the body or with L
TEST(Ground, NoFloorTurns) {
  const auto has_floor = [](const char* follow) {
    CameraSpec camera;
    camera.follow = follow;
    const BodySpec body = test::prolate_body();
    ThemeSpec theme;
    theme.theme = "light";
    const Composer picture(
        test::moving(body, test::wobbling()), body, camera, ShowSpec{}, theme, {640, 480});
    return picture.shows("floor");
  };
  EXPECT_TRUE(has_floor("auto"));
  EXPECT_TRUE(has_floor("center"));
  EXPECT_FALSE(has_floor("body"));
  EXPECT_FALSE(has_floor("momentum"));
}

// a wheel that hangs from a stand does not reach the floor: the stand is higher
TEST(Ground, TheStandIsAsHighAsTheBodyNeeds) {
  MotionSpec motion = test::spinning_on_pivot();
  motion.attitude.zxz = Vec3(0.0, 1.5, 0.0);
  ShowSpec show = test::show_only("floor");
  show["body"] = show["pivot"] = true;
  const BodySpec body = test::cone_body();
  const Composer picture = picture_of(body, motion, show);
  const double size = picture.scenery().scale.body;
  EXPECT_GT(picture.scenery().stand_height, kStandHeight);
  bool near = false;
  for (double t = 0.0; t <= motion.duration; t += 0.01) {
    const Sample sample = picture.scenery().motion.at(t);
    const double floor = picture.glyphs_at(sample).floors.at(0).place.translation().z();
    for (const Vec3& corner : picture.scenery().hull_B) {
      const double height = (body_placement(picture.scenery(), sample) * corner).z() - floor;
      EXPECT_GT(height, 0.0) << t;
      near = near || height < 0.15 * size;
    }
  }
  EXPECT_TRUE(near) << "and no higher";
}

// the shadow of a vector lies where the light through it falls
TEST(Ground, VectorsThrowShadows) {
  ShowSpec show = test::show_only("floor");
  const auto darkness = [&](bool omega) {
    show["omega"] = omega;
    const Composer picture = picture_of(test::prolate_body(), test::wobbling(), show);
    const DrawList list = picture.at(0.4);
    double dark = 0.0;
    for (std::size_t i = 2; i < list.translucent.size(); ++i) {  // after the floor and its dial
      for (const Vertex& vertex : list.translucent[i].mesh->vertices)
        dark += vertex.normal.z;
    }
    return dark;
  };
  EXPECT_EQ(darkness(false), 0.0);
  EXPECT_GT(darkness(true), 0.0);
}

}  // namespace
}  // namespace polhode
