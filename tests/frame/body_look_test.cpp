// SPDX-License-Identifier: MIT
#include "frame/body_look.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "base/units.h"
#include "frame/mesh_measures.h"
#include "math/so3.h"
#include "model/solids.h"
#include "support/expect_error.h"
#include "support/motions.h"

namespace polhode {
namespace {

using test::open_edges;
using test::signed_volume;

SolidSpec example(const std::string& kind) {
  SolidSpec s;
  s.kind = kind;
  s.mass = 1.0;
  if (kind == "box") s.size = Vec3(1, 2, 3);
  if (kind == "ellipsoid") s.semi_axes = Vec3(1, 2, 3);
  if (kind == "sphere" || kind == "cylinder" || kind == "cone" || kind == "disc" ||
      kind == "ring") {
    s.radius = 1.5;
  }
  if (kind == "cylinder" || kind == "cone") s.height = 2.0;
  if (kind == "disc") s.thickness = 0.4;
  if (kind == "ring") s.tube = 0.3;
  if (kind == "rod") {
    s.length = 2.0;
    s.radius = 0.2;
  }
  if (kind == "mesh") {
    s.file = "wing_nut.obj";
    s.mesh = std::make_shared<const TriangleMesh>(
        load_solid_mesh(POLHODE_SOURCE_DIR "/scenes/wing_nut.obj", 1.0));
  }
  if (kind == "lathe") s.profile = {{0, 0}, {1, 0.5}, {0.3, 1.0}, {0.5, 1.6}};
  return s;
}

class BodyLookOfEverySolid : public ::testing::TestWithParam<std::string> {};

// the drawn body is the body whose mass is computed: same volume, closed, facing outwards
TEST_P(BodyLookOfEverySolid, MeshIsClosedAndHasTheVolumeOfTheSolid) {
  const SolidSpec solid = example(GetParam());
  check_dimensions(solid, "solid");
  const Mesh mesh = solid_mesh(solid, 256);
  EXPECT_EQ(open_edges(mesh), 0);
  double volume = 0.0;
  for (const SolidKind& kind : solid_kinds()) {
    if (kind.name == solid.kind) volume = kind.volume(solid);
  }
  ASSERT_GT(volume, 0.0);
  // a polygon of n sides has 1 - 2/3 (pi/n)^2 of the circle's area: 1e-4 at 256; a torus tube has
  // 64
  EXPECT_NEAR(signed_volume(mesh) / volume, 1.0, 2e-3);
}

TEST_P(BodyLookOfEverySolid, NormalsAreUnitAndPointOutwards) {
  const Mesh mesh = solid_mesh(example(GetParam()), 64);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vertex& a = mesh.vertices[mesh.indices[i]];
    const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
    const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
    const glm::vec3 face = glm::cross(b.position - a.position, c.position - a.position);
    if (glm::length(face) < 1e-9f) continue;
    for (const Vertex* v : {&a, &b, &c}) {
      EXPECT_NEAR(glm::length(v->normal), 1.0f, 1e-5f);
      EXPECT_GT(glm::dot(v->normal, glm::normalize(face)), 0.5f);
    }
  }
}

std::vector<std::string> names() {
  return solid_names();
}
INSTANTIATE_TEST_SUITE_P(Solids,
                         BodyLookOfEverySolid,
                         ::testing::ValuesIn(names()),
                         [](const auto& row) { return row.param; });

TEST(BodyLook, ALatheDrawnDownwardsLooksTheSame) {
  SolidSpec down = example("lathe");
  std::reverse(down.profile.begin(), down.profile.end());
  EXPECT_NEAR(
      signed_volume(solid_mesh(down, 64)), signed_volume(solid_mesh(example("lathe"), 64)), 1e-6);
}

// a smooth outline has eight pieces between two points; most are too short to be seen
TEST(BodyLook, ALatheHasNoNeedlessBands) {
  SolidSpec vase = example("lathe");
  vase.smooth = true;
  for (const int segments : {64, 128}) {
    SCOPED_TRACE(segments);
    const std::vector<Vec2> outline = lathe_outline(vase);
    double reach = 0.0;
    for (const Vec2& point : outline)
      reach = std::max(reach, point.norm());
    const Mesh mesh = solid_mesh(vase, segments);
    std::set<float> heights;
    for (const Vertex& vertex : mesh.vertices)
      heights.insert(vertex.position.z);
    EXPECT_LT(heights.size(), outline.size());
    // no point of the outline is farther from the drawn one than a circle's pieces from the circle
    const double allowed = reach * (1.0 - std::cos(kPi / segments));
    std::vector<Vec2> corners;
    for (const Vertex& vertex : mesh.vertices)
      corners.emplace_back(std::hypot(vertex.position.x, vertex.position.y), vertex.position.z);
    std::sort(
        corners.begin(), corners.end(), [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
    for (const Vec2& point : outline) {
      double nearest = reach;
      for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const Vec2 along = corners[i + 1] - corners[i], out = point - corners[i];
        const double share = along.squaredNorm() > 0.0
                                 ? std::clamp(out.dot(along) / along.squaredNorm(), 0.0, 1.0)
                                 : 0.0;
        nearest = std::min(nearest, (out - share * along).norm());
      }
      // beside it, corners stand as far outside as the middles of pieces stand inside
      EXPECT_LT(nearest, 1.6 * allowed) << point.transpose();
    }
  }
}

std::vector<LookPart> look_of(const BodySpec& body, const BodyModel& model) {
  return body_look(body, model, themes().front(), 64);
}

// bare moments look like the homogeneous ellipsoid that has them: the moments of a drawn ellipsoid
// give it back
TEST(BodyLook, BareMomentsLookLikeTheirEllipsoid) {
  const Vec3 axes(0.1, 0.15, 0.2);
  const BodyModel model = make_model(test::ellipsoid_body(axes), test::wobbling());
  const std::vector<LookPart> look = look_of(BodySpec{}, model);
  ASSERT_EQ(look.size(), 1u);
  Vec3 reach = Vec3::Zero();
  for (const Vec3& point : points_of(look))
    reach = reach.cwiseMax(point.cwiseAbs());
  EXPECT_LT((reach - axes).cwiseQuotient(axes).cwiseAbs().maxCoeff(), 5e-3) << reach.transpose();
}

// balls where the points are, as large as the cube root of their mass
TEST(BodyLook, PointsAreBallsWithTheVolumeOfTheirMass) {
  BodySpec body;
  body.points.resize(2);
  body.points[0].m = 1.0;
  body.points[0].at = Vec3(0.8, 0, 0);
  body.points[1].m = 8.0;
  body.points[1].at = Vec3(-0.1, 0, 0);
  const BodyModel model = make_model(body, test::wobbling());
  std::vector<LookPart> balls;
  for (const LookPart& part : look_of(body, model)) {
    if (part.material.mark_width > 0.0f) balls.push_back(part);
  }
  ASSERT_EQ(balls.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT((balls[i].body_from_mesh.translation() - body.points[i].at).norm(), 1e-15);
  const double volumes = balls[1].body_from_mesh.linear().determinant() /
                         balls[0].body_from_mesh.linear().determinant();
  EXPECT_NEAR(volumes, 8.0, 1e-12);
}

// One strip for the whole body: on the rim of a wheel, not on its spokes, axle and hub.
TEST(BodyLook, TheMarkOfAWheelIsOnItsRim) {
  BodySpec body;
  body.parts = {example("ring"), example("rod"), example("cylinder"), example("rod")};
  body.parts[1].radius = body.parts[2].radius = 0.1;
  body.parts[3].radius = 0.05;
  body.parts[3].turn = Vec3(0.0, 0.5 * kPi, 0.0);
  const std::vector<LookPart> look = look_of(body, make_model(body, test::wobbling()));
  ASSERT_EQ(look.size(), 4u);
  EXPECT_NEAR(look[0].material.mark_width, 0.13 * 1.8, 0.01);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(look[i].material.mark_width, 0.0f) << i;
    EXPECT_GT(look[i].material.grain, 0.0f) << i;
  }
}

// Parts about one axis carry the same strip, however they are turned together; a part that is
// turned against the others carries none.
TEST(BodyLook, PartsAboutOneAxisHaveOneMark) {
  for (const Vec3& turn : {Vec3(0, 0, 0), Vec3(0, 0.5 * kPi, 0), Vec3(0.3, -1.0, 2.0)}) {
    SCOPED_TRACE(turn.transpose());
    BodySpec body;
    body.parts = {example("cylinder"), example("disc"), example("disc")};
    body.parts[1].radius = 1.2;
    for (SolidSpec& part : body.parts)
      part.turn = turn;
    const Vec3 axis = from_xyz_turns(turn) * Vec3::UnitZ();
    body.parts[1].at = 2.0 * axis;
    body.parts[2].turn += Vec3(0.0, 0.0, 0.4);
    const std::vector<LookPart> look = look_of(body, make_model(body, test::wobbling()));
    EXPECT_NEAR(look[0].material.mark_width, 0.13 * 1.5, 0.01);
    EXPECT_EQ(look[1].material.mark_width, look[0].material.mark_width);
    EXPECT_EQ(look[2].material.mark_width, 0.0f);
  }
}

// a body of arms alone shows by itself how it turns, and a single solid is always marked
TEST(BodyLook, TheMarkNeverCoversAnArm) {
  BodySpec handle;
  handle.parts = {example("rod"), example("rod")};
  handle.parts[0].turn = Vec3(0.0, 0.5 * kPi, 0.0);
  for (const LookPart& part : look_of(handle, make_model(handle, test::wobbling())))
    EXPECT_EQ(part.material.mark_width, 0.0f);

  BodySpec plank;
  plank.solid = example("box");
  plank.solid->size = Vec3(3.0, 0.2, 1.0);
  const LookPart part = look_of(plank, make_model(plank, test::wobbling())).at(0);
  EXPECT_GT(part.material.mark_width, 0.0f);
  EXPECT_LE(part.material.mark_width, 0.1f / 3.0f + 1e-6f);
}

// in every direction the hull reaches as far as all vertices do
TEST(BodyLook, TheHullReachesAsFarAsTheBody) {
  const BodySpec body = test::brick_body();
  const std::vector<LookPart> look = look_of(body, make_model(body, test::wobbling()));
  const std::vector<Vec3> hull = hull_of(look);
  const auto reach = [](const std::vector<Vec3>& points, const Vec3& direction) {
    double most = -1e9;
    for (const Vec3& point : points)
      most = std::max(most, point.dot(direction));
    return most;
  };
  for (const Vec3& direction :
       {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.3, 0.5, -0.8), Vec3(-1, 2, 3)}) {
    const double all = reach(points_of(look), direction.normalized());
    EXPECT_NEAR(reach(hull, direction.normalized()), all, 1e-3 * all);
  }
  // half the diagonal of the box
  EXPECT_NEAR(body_radius(look, make_model(body, test::wobbling())),
              0.5 * Vec3(0.3, 0.2, 0.06).norm(),
              1e-7);
}

// a rod may be a plate: its corners do not grow in number with its width
TEST(BodyLook, ARodThickerThanLongIsNoFinerThanACylinder) {
  BodySpec body;
  SolidSpec rod;
  rod.kind = "rod";
  rod.mass = 1.0;
  rod.length = 1.0;
  rod.radius = 1e9;
  body.solid = rod;
  const BodyModel model = make_model(body, {});
  const std::vector<LookPart> look = body_look(body, model, make_theme({}), 96);
  EXPECT_LT(points_of(look).size(), 5000U);
}

TEST(BodyLook, ALookHasNoMass) {
  BodySpec body = test::brick_body();
  body.look = body.solid;
  const BodyModel model = make_model(test::brick_body(), test::wobbling());
  test::expect_input_error([&] { look_of(body, model); }, "body.look.mass", "no mass");
}

}  // namespace
}  // namespace polhode
