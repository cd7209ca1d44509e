// SPDX-License-Identifier: MIT
#include "frame/curves.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "frame/mesh_measures.h"

namespace polhode {
namespace {

double off_surfaces(const Vec3& moments, const Vec3& w, const Vec3& start) {
  const double energy = moments.dot(w.cwiseProduct(w)) / moments.dot(start.cwiseProduct(start));
  const double momentum =
      moments.cwiseProduct(w).squaredNorm() / moments.cwiseProduct(start).squaredNorm();
  return std::max(std::abs(energy - 1.0), std::abs(momentum - 1.0));
}

// every point of a polhode has the energy and |L| of its motion, and the motion stays on it
TEST(Curves, PolhodeIsWhereEnergyAndMomentumKeepTheirValues) {
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

TEST(Curves, ASteadySpinHasNoPolhode) {
  EXPECT_TRUE(polhode({1, 2, 3}, {0, 0, 2}, 100).empty());
  EXPECT_TRUE(polhode({1, 2, 3}, {2, 0, 0}, 100).empty());
  EXPECT_TRUE(polhode({1, 2, 3}, {0, 0, 0}, 100).empty());
  EXPECT_TRUE(polhode({2, 2, 2}, {0.3, 1, 2}, 100).empty());
}

// the separatrix has the energy of its motion, and the L^2 of a spin about the middle axis
TEST(Curves, TheSeparatrixGoesThroughTheMiddleAxis) {
  const Vec3 w(0.4, -0.3, 0.7);
  for (const Vec3& moments : {Vec3(1.0, 2.0, 3.5), Vec3(3.0, 1.2, 1.5), Vec3(2.0, 2.9, 0.8)}) {
    const double energy2 = moments.dot(w.cwiseProduct(w));
    const double middle = moments.sum() - moments.minCoeff() - moments.maxCoeff();
    const std::vector<std::vector<Vec3>> ellipses = separatrix(moments, w, 100);
    ASSERT_EQ(ellipses.size(), 2u);
    for (const std::vector<Vec3>& ellipse : ellipses) {
      ASSERT_EQ(ellipse.size(), 100u);
      for (const Vec3& point : ellipse) {
        EXPECT_NEAR(moments.dot(point.cwiseProduct(point)), energy2, 1e-14 * energy2);
        EXPECT_NEAR(moments.cwiseProduct(point).squaredNorm(), energy2 * middle, 1e-14 * energy2);
      }
      EXPECT_NEAR(ellipse.front().norm(), std::sqrt(energy2 / middle), 1e-15) << "about the middle";
    }
    EXPECT_GT((ellipses[0][25] - ellipses[1][25]).norm(), 0.5) << "two of them";
    EXPECT_GT((ellipses[0][25] + ellipses[1][25]).norm(), 0.5) << "two of them";
  }
  EXPECT_TRUE(separatrix({1, 1, 2}, w, 100).empty());
  EXPECT_TRUE(separatrix({1, 2, 2}, w, 100).empty());
  EXPECT_TRUE(separatrix({1, 2, 3}, Vec3::Zero(), 100).empty());
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

// a closed tube about a circle is a torus: volume 2 pi^2 R r^2 less what polygons lack
// a point that rests, moves on in a straight line and rests again is on its path at all times
TEST(Curves, KeepThePaceOfTheirPoint) {
  const auto point = [](double t) {
    return Vec3(std::clamp(t - 1.3, 0.0, 0.4), 0.0, 0.0);
  };
  const Path path = sampled(point, 0.0, 4.0, 64, 1e-3);
  EXPECT_LT(path.points.size(), 40u);
  for (double t = 0.0; t <= 4.0; t += 0.0113) {
    const auto next = std::upper_bound(path.parameters.begin(), path.parameters.end(), t);
    ASSERT_NE(next, path.parameters.end());
    const auto i = static_cast<std::size_t>(next - path.parameters.begin());
    const double part =
        (t - path.parameters[i - 1]) / (path.parameters[i] - path.parameters[i - 1]);
    const Vec3 there = path.points[i - 1] + part * (path.points[i] - path.points[i - 1]);
    EXPECT_LT((there - point(t)).norm(), 1.1e-3) << t;
  }
}

TEST(Curves, AClosedTubeIsATorus) {
  constexpr int kPieces = 200, kSides = 24;
  std::vector<Vec3> circle;
  for (int i = 0; i < kPieces; ++i) {
    const double angle = 2.0 * kPi * i / kPieces;
    circle.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
  }
  const Mesh tube = tube_along(circle, 0.1, kSides, true);
  EXPECT_EQ(test::open_edges(tube), 0);
  // the area of a polygon of n corners on a circle is n/2 sin(2 pi / n) r^2
  const double section = 0.5 * kSides * std::sin(2.0 * kPi / kSides) * 0.01;
  EXPECT_NEAR(test::signed_volume(tube), section * 2.0 * kPi * 2.0, 2e-3 * section * 4.0 * kPi);
  for (const Vertex& vertex : tube.vertices) {
    const double off = std::hypot(std::hypot(vertex.position.x, vertex.position.y) - 2.0,
                                  static_cast<double>(vertex.position.z));
    EXPECT_NEAR(off, 0.1, 1e-6);
  }
}

// an open tube has ends: it encloses its volume, and nobody looks into it
TEST(Curves, AnOpenTubeIsClosedAtItsEnds) {
  constexpr int kSides = 24;
  const Mesh tube = tube_along({{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 3}}, 0.1, kSides, false);
  EXPECT_EQ(test::open_edges(tube), 0);
  const Mesh straight = tube_along({{0, 0, 0}, {1, 2, 2}}, 0.1, kSides, false);
  const double section = 0.5 * kSides * std::sin(2.0 * kPi / kSides) * 0.01;
  EXPECT_NEAR(test::signed_volume(straight), 3.0 * section, 1e-6);
  for (const Vertex& vertex : straight.vertices)
    EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-6f);
}

// parts of a trail end at any parameter, within a piece too, and together are the whole
TEST(Curves, PartsOfATrailEndWhereTheyAreCut) {
  Path line;
  for (int i = 0; i <= 150; ++i) {
    line.parameters.push_back(i);
    line.points.emplace_back(0.0, 0.0, 2.0 * i);
  }
  const Trail trail(line, 0.1, 10.0, 8);
  const auto reach = [&](double from, double to) {
    double low = 1e9, high = -1e9;
    for (const MeshPtr& mesh : trail.part(from, to)) {
      for (const Vertex& vertex : mesh->vertices) {
        const double z = (trail.place() * to_eigen(vertex.position)).z();
        low = std::min(low, z);
        high = std::max(high, z);
      }
    }
    return Vec2(low, high);
  };
  for (const auto& [from, to] : {std::pair{0.0, 150.0}, {3.25, 3.75}, {10.5, 64.0}, {63.5, 140.2}})
    EXPECT_LT((reach(from, to) - 2.0 * Vec2(from, to)).norm(), 1e-4) << from << ' ' << to;
  EXPECT_TRUE(trail.part(150.0, 160.0).empty());
  EXPECT_TRUE(Trail().part(0.0, 1.0).empty());
}

}  // namespace
}  // namespace polhode
