// SPDX-License-Identifier: MIT
#include "frame/mesh.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/units.h"
#include "frame/mesh_measures.h"

namespace polhode {
namespace {

// corners outside, middles of chords inside, both by at most a quarter of a pixel
TEST(Mesh, DrawnCirclesAreWithinAQuarterPixel) {
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

// the unit shapes have the volumes of geometry, within what their polygons lack, and no holes
TEST(Mesh, UnitShapesAreClosedAndHaveTheirVolumes) {
  struct Case {
    const char* name;
    Mesh mesh;
    double volume;
  };
  const Case cases[] = {{"sphere", unit_sphere(128), 4.0 / 3.0 * kPi},
                        {"cylinder", unit_cylinder(128), kPi},
                        {"cone", unit_cone(128), kPi / 3.0},
                        {"torus", torus(1.0, 0.25, 128), 2.0 * kPi * kPi * 0.0625},
                        {"box", box({1, 2, 3}), 6.0},
                        {"scaled", scaled(unit_sphere(128), {1, 2, 3}), 8.0 * kPi}};
  for (const Case& shape : cases) {
    EXPECT_EQ(test::open_edges(shape.mesh), 0) << shape.name;
    EXPECT_NEAR(test::signed_volume(shape.mesh) / shape.volume, 1.0, 4e-3) << shape.name;
  }
}

// a coarser mesh is about as large, and closed where the fine one is
TEST(Mesh, ClusteringKeepsTheShape) {
  const Mesh fine = scaled(unit_sphere(512), {1, 2, 0.01});
  const Mesh coarse = clustered(fine, 32);
  EXPECT_LT(coarse.indices.size(), fine.indices.size() / 10);
  EXPECT_NEAR(test::signed_volume(coarse) / test::signed_volume(fine), 1.0, 0.1);
  EXPECT_EQ(test::open_edges(coarse), 0);
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  for (const Vertex& vertex : coarse.vertices) {
    const Vec3 at(vertex.position.x, vertex.position.y, vertex.position.z);
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  EXPECT_LT((high - low - Vec3(2, 4, 0.02)).cwiseQuotient(Vec3(2, 4, 0.02)).norm(), 0.1);
  // where every vertex has a cell of its own, nothing changes
  EXPECT_EQ(clustered(unit_cone(8), 64).indices.size(), unit_cone(8).indices.size());
}

// between two rays from the tip, up to where the floor ends, where it has faded
TEST(Mesh, ASectorOfAFloorReachesFromItsTipToTheRim) {
  const Vec2 tip(0.3, -0.2);
  const Mesh sector = floor_sector(tip, 2.0, 0.1);
  double farthest = 0.0;
  for (const Vertex& vertex : sector.vertices) {
    const Vec2 p(vertex.position.x, vertex.position.y);
    farthest = std::max(farthest, p.norm());
    EXPECT_NEAR(vertex.normal.z, p.norm() < 0.5 ? 1.0 : vertex.normal.z, 1e-6);
    if (p.norm() > 0.999) {
      EXPECT_LT(vertex.normal.z, 1e-4f);
    }
    const Vec2 from = p - tip;
    if (from.norm() < 1e-6) continue;
    EXPECT_NEAR(
        std::abs(std::remainder(std::atan2(from.y(), from.x()) - 2.0, 2.0 * kPi)), 0.1, 1e-5);
  }
  EXPECT_NEAR(farthest, 1.0, 1e-6);
}

// of a mesh in a plane z = const
double area_of(const Mesh& mesh) {
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec3& a = mesh.vertices[mesh.indices[i]].position;
    const glm::vec3& b = mesh.vertices[mesh.indices[i + 1]].position;
    const glm::vec3& c = mesh.vertices[mesh.indices[i + 2]].position;
    area += 0.5 * std::abs(glm::cross(b - a, c - a).z);
  }
  return area;
}

// lines of both directions, at equal distances, up to the rim, where they are gone
TEST(Mesh, AGridIsOfLinesThatFadeOutwards) {
  const double spacing = 0.3, width = 0.01;
  const Mesh lines = floor_grid(Vec2(0.05, -0.1), 0.4, spacing, width);
  const Vec2 along(std::cos(0.4), std::sin(0.4)), across(-along.y(), along.x());
  const auto off_lines = [&](double x) {
    return std::abs(x - spacing * std::round(x / spacing));
  };
  for (const Vertex& vertex : lines.vertices) {
    const Vec2 p(vertex.position.x, vertex.position.y);
    const Vec2 from = p - Vec2(0.05, -0.1);
    const double off = std::min(off_lines(from.dot(along)), off_lines(from.dot(across)));
    EXPECT_LT(off, 1.001 * width);
    EXPECT_LT(p.norm(), 1.02);
    if (p.norm() > 0.999) {
      EXPECT_LT(vertex.normal.z, 1e-4f);
    }
  }
  double length = 0.0;  // of lines of both directions
  for (const Vec2& normal : {along, across}) {
    for (int k = -10; k <= 10; ++k) {
      const double away = normal.dot(Vec2(0.05, -0.1)) + k * spacing;
      if (std::abs(away) < 1.0) length += 2.0 * std::sqrt(1.0 - away * away);
    }
  }
  EXPECT_NEAR(area_of(lines), 2.0 * width * length, 1e-4 * area_of(lines));
}

// circles at equal distances about a point, and twelve spokes from the first of them to the rim
TEST(Mesh, APolarGridIsOfCirclesAndSpokesThatFadeOutwards) {
  const double spacing = 0.3, width = 0.01, angle = 0.4;
  for (const Vec2& center : {Vec2(0, 0), Vec2(0.3, -0.2), Vec2(-0.9, 0.1)}) {
    const Mesh lines = polar_floor_grid(center, angle, spacing, width);
    for (const Vertex& vertex : lines.vertices) {
      const Vec2 p(vertex.position.x, vertex.position.y);
      const double radius = (p - center).norm();
      const double off_circles = std::abs(radius - spacing * std::round(radius / spacing));
      const double off_spokes =
          radius * std::abs(std::sin(std::remainder(
                       std::atan2(p.y() - center.y(), p.x() - center.x()) - angle, kPi / 6.0)));
      EXPECT_LT(std::min(off_circles, off_spokes), 1.001 * width);
      EXPECT_GT(radius, spacing - 1.001 * width);
      EXPECT_LT(p.norm(), 1.02);
      if (p.norm() > 0.999) {
        EXPECT_LT(vertex.normal.z, 1e-4f);
      }
    }
    // by how many of a million points on each circle are on the floor
    double length = 0.0;
    for (double radius = spacing; radius < 2.0; radius += spacing) {
      int inside = 0;
      constexpr int kPoints = 1'000'000;
      for (int i = 0; i < kPoints; ++i) {
        const double at = 2.0 * kPi * i / kPoints;
        if ((center + radius * Vec2(std::cos(at), std::sin(at))).norm() < 1.0) ++inside;
      }
      length += 2.0 * kPi * radius * inside / kPoints;
    }
    for (int k = 0; k < 12; ++k) {
      const Vec2 along(std::cos(angle + k * kPi / 6.0), std::sin(angle + k * kPi / 6.0));
      const double inwards = -along.dot(center);
      const double reach = inwards + std::sqrt(inwards * inwards + 1.0 - center.squaredNorm());
      length += std::max(0.0, reach - spacing);
    }
    EXPECT_NEAR(area_of(lines), 2.0 * width * length, 1e-3 * area_of(lines));
  }
}

// seen from above, a circle and twelve ticks of lines that are gone at their sides
TEST(Mesh, ADialIsACircleWithTicks) {
  const Mesh lines = dial(72, 0.007);
  double area = 0.0;
  for (std::size_t i = 0; i < lines.indices.size(); i += 3) {
    const glm::vec3& a = lines.vertices[lines.indices[i]].position;
    const glm::vec3& b = lines.vertices[lines.indices[i + 1]].position;
    const glm::vec3& c = lines.vertices[lines.indices[i + 2]].position;
    const float piece = 0.5f * glm::cross(b - a, c - a).z;
    EXPECT_GT(piece, 0.0f);
    area += piece;
  }
  const double width = 0.014, ticks = 8 * 0.05 + 4 * 0.11;
  EXPECT_NEAR(area, width * (2.0 * kPi + ticks), 0.01 * area);
  for (const Vertex& vertex : lines.vertices) {
    const float radius = glm::length(vertex.position);
    if (radius > 1.001f) {
      EXPECT_EQ(vertex.normal.z, 0.0f);
    }
    EXPECT_GT(radius, 0.88f);
    EXPECT_LT(radius, 1.008f);
    EXPECT_EQ(vertex.normal.x, 0.0f);
  }
}

}  // namespace
}  // namespace polhode
