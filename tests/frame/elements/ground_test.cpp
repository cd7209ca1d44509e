// SPDX-License-Identifier: MIT
// The body, where it was, and what it stands on.
#include <algorithm>

#include <gtest/gtest.h>

#include "frame/compose.h"
#include "support/motions.h"
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
    EXPECT_LT((ghosts[i].space_from_mesh.matrix() - body.space_from_mesh.matrix()).norm(), 1e-12);
    if (i == 0) continue;
    EXPECT_GT(ghosts[i].material.alpha, ghosts[i - 1].material.alpha);
  }
  EXPECT_EQ(picture.glyphs_at(motion.at(0.7)).ghosts.size(), 2u) << "none before the start";
}

// the stand's apex is the pivot, and it stands on the floor
TEST(Ground, TheStandReachesFromTheFloorToThePivot) {
  ShowSpec show = test::show_only("pivot");
  show["floor"] = true;
  const Composer picture = picture_of(test::cone_body(), test::spinning_on_pivot(), show);
  const Sample now = picture.scenery().motion.at(0.3);
  const std::vector<MeshGlyph> meshes = picture.glyphs_at(now).meshes;
  ASSERT_EQ(meshes.size(), 2u);
  const Vec3 apex = meshes[0].space_from_mesh * Vec3::UnitZ();
  EXPECT_LT((apex - now.reference_S).norm(), 1e-15);
  const Vec3 foot = meshes[0].space_from_mesh * Vec3::Zero();
  const Vec3 floor = meshes[1].space_from_mesh.translation();
  EXPECT_NEAR(foot.z(), floor.z(), 1e-15);
  EXPECT_LT(foot.z(), apex.z());
}

// the shadow stays under the body, and is paler and wider the higher the body is
TEST(Ground, TheShadowFollowsTheBody) {
  MotionSpec motion = test::wobbling();
  motion.velocity = Vec3(0.2, 0.1, 0.1);
  const Composer picture = picture_of(test::prolate_body(), motion, test::show_only("floor"));
  const Motion& solution = picture.scenery().motion;
  const auto shade_at = [&](double t) {
    return picture.glyphs_at(solution.at(t)).shades.at(0);
  };
  const MeshGlyph early = shade_at(0.0), late = shade_at(4.0);
  const Vec3 moved = late.space_from_mesh.translation() - early.space_from_mesh.translation();
  EXPECT_NEAR(moved.x(), 0.8, 0.02);
  EXPECT_NEAR(moved.y(), 0.4, 0.02);
  EXPECT_NEAR(moved.z(), 0.0, 1e-12);
  EXPECT_LT(late.material.alpha, early.material.alpha);
  EXPECT_GT(late.space_from_mesh.linear().determinant(),
            early.space_from_mesh.linear().determinant());
}

}  // namespace
}  // namespace polhode
