// SPDX-License-Identifier: MIT
#include "frame/mesh.h"

#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/units.h"
#include "frame/body_look.h"
#include "model/solids.h"

namespace polhode {
namespace {

// signed volume of a closed mesh by the divergence theorem: positive when triangles face outwards
double signed_volume(const Mesh& mesh) {
  double six = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = mesh.vertices[mesh.indices[i]].position;
    const glm::dvec3 b = mesh.vertices[mesh.indices[i + 1]].position;
    const glm::dvec3 c = mesh.vertices[mesh.indices[i + 2]].position;
    six += glm::dot(a, glm::cross(b, c));
  }
  return six / 6.0;
}

// how many directed edges have no partner that runs the other way (0 for a closed surface)
int open_edges(const Mesh& mesh) {
  const auto key = [](const glm::vec3& p) {
    return std::array<long, 3>{
        std::lround(p.x * 1e6), std::lround(p.y * 1e6), std::lround(p.z * 1e6)};
  };
  std::map<std::pair<std::array<long, 3>, std::array<long, 3>>, int> balance;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = key(mesh.vertices[mesh.indices[i + k]].position);
      const auto b = key(mesh.vertices[mesh.indices[i + (k + 1) % 3]].position);
      if (a == b) continue;
      ++balance[{a, b}];
      --balance[{b, a}];
    }
  }
  int open = 0;
  for (const auto& [edge, count] : balance)
    open += count != 0 ? 1 : 0;
  return open;
}

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

class EverySolid : public ::testing::TestWithParam<std::string> {};

// the drawn body is the body whose mass is computed: same volume, closed, facing outwards
TEST_P(EverySolid, MeshIsClosedAndHasTheVolumeOfTheSolid) {
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

TEST_P(EverySolid, NormalsAreUnitAndPointOutwards) {
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
INSTANTIATE_TEST_SUITE_P(Solids, EverySolid, ::testing::ValuesIn(names()), [](const auto& row) {
  return row.param;
});

TEST(Lathe, OutlineDrawnDownwardsLooksTheSame) {
  SolidSpec down = example("lathe");
  std::reverse(down.profile.begin(), down.profile.end());
  EXPECT_NEAR(
      signed_volume(solid_mesh(down, 64)), signed_volume(solid_mesh(example("lathe"), 64)), 1e-6);
}

// corners outside, middles of chords inside, both by at most a quarter of a pixel
TEST(CircleSegments, DrawnCirclesAreWithinAQuarterPixel) {
  const auto farthest = [](int n, double radius) {
    const Mesh disc = unit_disc(n);
    const glm::vec3 corner = disc.vertices[1].position;
    const glm::vec3 middle = 0.5f * (corner + disc.vertices[2].position);
    const double outside = glm::length(corner) - 1.0;
    const double inside = 1.0 - glm::length(middle);
    EXPECT_NEAR(outside, inside, 1e-6);
    return radius * std::max(outside, inside);
  };
  for (const double radius : {20.0, 100.0, 540.0, 2160.0}) {
    const int n = circle_segments(radius);
    EXPECT_LE(farthest(n, radius), 0.25 + 2e-3) << radius;
    if (n > 16) {
      EXPECT_GT(farthest(n - 1, radius), 0.25) << "wasteful at " << radius;
    }
  }
}

}  // namespace
}  // namespace polhode
