// SPDX-License-Identifier: MIT
#include "model/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include <gtest/gtest.h>

#include "base/units.h"
#include "math/so3.h"
#include "model/body_model.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::expect_input_error;

// A point of the solid and the volume element there, as functions of (u, v, w) in the unit cube.
struct Element {
  Vec3 at;
  double volume;
};
using Chart = std::function<Element(double u, double v, double w)>;

// nodes and weights of the twenty-point Gauss rule on [0, 1], by Newton's method on Legendre's P20
std::vector<std::pair<double, double>> gauss_rule() {
  constexpr int n = 20;
  std::vector<std::pair<double, double>> rule;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(kPi * (i + 0.75) / (n + 0.5));
    double slope = 0.0;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double p = 1.0, q = 0.0;
      for (int k = 1; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * q) / k;
        q = std::exchange(p, next);
      }
      slope = n * (x * p - q) / (x * x - 1.0);
      x -= p / slope;
    }
    rule.emplace_back(0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

// mass (at density 1), centre and tensor by definition
MassProperties by_quadrature(const Chart& chart) {
  static const std::vector<std::pair<double, double>> rule = gauss_rule();
  std::vector<PointMass> points;
  MassProperties body;
  for (const auto& [u, weight_u] : rule) {
    for (const auto& [v, weight_v] : rule) {
      for (const auto& [w, weight_w] : rule) {
        const Element e = chart(u, v, w);
        points.push_back({weight_u * weight_v * weight_w * e.volume, e.at});
        body.mass += points.back().mass;
        body.center += points.back().mass * e.at;
      }
    }
  }
  body.center /= body.mass;
  for (const PointMass& p : points) {
    const Vec3 r = p.at - body.center;
    body.tensor += p.mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  }
  return body;
}

// a solid of revolution between radius(z) and the axis
Chart revolved(const std::function<double(double)>& radius, double from, double to) {
  return [=](double u, double v, double w) {
    const double z = from + v * (to - from);
    const double r = u * radius(z);
    const double turn = 2.0 * kPi * w;
    return Element{{r * std::cos(turn), r * std::sin(turn), z},
                   2.0 * kPi * r * radius(z) * (to - from)};
  };
}

Chart ellipsoid_chart(const Vec3& a) {
  return [=](double u, double v, double w) {
    const double c = 2.0 * v - 1.0;
    const double s = std::sqrt(1.0 - c * c);
    const Vec3 n(s * std::cos(2.0 * kPi * w), s * std::sin(2.0 * kPi * w), c);
    return Element{u * a.cwiseProduct(n), 4.0 * kPi * a.prod() * u * u};
  };
}

Chart torus_chart(double radius, double tube) {
  return [=](double u, double v, double w) {
    const double r = radius + tube * u * std::cos(2.0 * kPi * v);
    const double turn = 2.0 * kPi * w;
    return Element{{r * std::cos(turn), r * std::sin(turn), tube * u * std::sin(2.0 * kPi * v)},
                   4.0 * kPi * kPi * tube * tube * u * r};
  };
}

// residuals seen: 3e-15 relative, the quadrature's own round-off
constexpr double kBound = 2e-14;

void expect_same(const MassProperties& found, const MassProperties& expected) {
  EXPECT_NEAR(found.mass, expected.mass, kBound * expected.mass);
  EXPECT_LE((found.center - expected.center).norm(), kBound);
  EXPECT_LE((found.tensor - expected.tensor).norm(), kBound * expected.tensor.norm())
      << found.tensor << "\n\n"
      << expected.tensor;
}

SolidSpec solid(const std::string& kind) {
  SolidSpec s;
  s.kind = kind;
  s.density = 1.0;
  return s;
}

MassProperties of(const SolidSpec& s) {
  return mass_properties(s, "body.solid");
}

SolidSpec lathe_of(const std::vector<Vec2>& profile) {
  SolidSpec s = solid("lathe");
  s.profile = profile;
  return s;
}

TEST(Solids, Box) {
  SolidSpec s = solid("box");
  s.size = Vec3(0.3, 0.7, 1.9);
  expect_same(of(s), by_quadrature([](double u, double v, double w) {
                return Element{{0.3 * u - 0.15, 0.7 * v - 0.35, 1.9 * w - 0.95}, 0.3 * 0.7 * 1.9};
              }));
}

TEST(Solids, SphereAndEllipsoid) {
  SolidSpec s = solid("sphere");
  s.radius = 0.4;
  expect_same(of(s), by_quadrature(ellipsoid_chart(Vec3::Constant(0.4))));
  s = solid("ellipsoid");
  s.semi_axes = Vec3(0.3, 0.7, 1.9);
  expect_same(of(s), by_quadrature(ellipsoid_chart({0.3, 0.7, 1.9})));
}

TEST(Solids, CylinderConeThickDiscThickRod) {
  const auto constant = [](double) {
    return 0.6;
  };
  SolidSpec s = solid("cylinder");
  s.radius = 0.6;
  s.height = 1.5;
  expect_same(of(s), by_quadrature(revolved(constant, -0.75, 0.75)));
  s = solid("cone");
  s.radius = 0.6;
  s.height = 1.5;
  const auto opening = [](double z) {
    return 0.6 * z / 1.5;
  };
  expect_same(of(s), by_quadrature(revolved(opening, 0.0, 1.5)));
  s = solid("disc");
  s.radius = 0.6;
  s.thickness = 0.1;
  expect_same(of(s), by_quadrature(revolved(constant, -0.05, 0.05)));
  s = solid("rod");
  s.radius = 0.6;
  s.length = 4.0;
  expect_same(of(s), by_quadrature(revolved(constant, -2.0, 2.0)));
}

TEST(Solids, Torus) {
  SolidSpec s = solid("ring");
  s.radius = 0.9;
  s.tube = 0.25;
  expect_same(of(s), by_quadrature(torus_chart(0.9, 0.25)));
}

// thin solids have a mass instead of a density; textbook moments
TEST(Solids, ThinDiscRodAndHoop) {
  SolidSpec s;
  s.mass = 2.0;
  s.kind = "disc";
  s.radius = 0.5;
  EXPECT_LE((of(s).tensor.diagonal() - Vec3(0.125, 0.125, 0.25)).norm(), 1e-16);
  s.kind = "ring";
  EXPECT_LE((of(s).tensor.diagonal() - Vec3(0.25, 0.25, 0.5)).norm(), 1e-16);
  s.kind = "rod";
  s.radius.reset();
  s.length = 3.0;
  EXPECT_LE((of(s).tensor.diagonal() - Vec3(1.5, 1.5, 0.0)).norm(), 1e-15);
  EXPECT_EQ(of(s).mass, 2.0);
}

TEST(Solids, EveryKindIsCoveredHere) {
  const std::vector<std::string> covered = {"box",
                                            "sphere",
                                            "ellipsoid",
                                            "cylinder",
                                            "cone",
                                            "disc",
                                            "ring",
                                            "rod",
                                            "lathe",
                                            "mesh"};  // mesh: triangle_mesh_test.cpp
  EXPECT_EQ(solid_names(), covered);
}

TEST(Solids, TurnedAndMoved) {
  SolidSpec s = solid("cone");
  s.radius = 0.6;
  s.height = 1.5;
  s.turn = Vec3(0.4, -1.0, 2.0);
  s.at = Vec3(3.0, -2.0, 0.5);
  const Mat3 R = from_xyz_turns(s.turn);
  const Chart straight = revolved([](double z) { return 0.6 * z / 1.5; }, 0.0, 1.5);
  expect_same(of(s), by_quadrature([&](double u, double v, double w) {
                const Element e = straight(u, v, w);
                return Element{R * e.at + s.at, e.volume};
              }));
}

TEST(Solids, MassOverridesVolumeAndDensityScalesIt) {
  SolidSpec s = solid("box");
  s.size = Vec3(1.0, 2.0, 3.0);
  s.density = 2700.0;
  EXPECT_DOUBLE_EQ(of(s).mass, 16200.0);
  s.density.reset();
  s.mass = 12.0;
  EXPECT_LE((of(s).tensor.diagonal() - Vec3(13.0, 10.0, 5.0)).norm(), 1e-14);
}

TEST(Lathe, CylinderAndCone) {
  SolidSpec cylinder = solid("cylinder");
  cylinder.radius = 0.6;
  cylinder.height = 1.5;
  cylinder.at = Vec3(0, 0, 0.75);
  expect_same(of(lathe_of({{0.6, 0.0}, {0.6, 1.5}})), of(cylinder));
  expect_same(of(lathe_of({{0.0, 0.0}, {0.6, 0.0}, {0.6, 1.5}, {0.0, 1.5}})), of(cylinder));

  SolidSpec cone = solid("cone");
  cone.radius = 0.6;
  cone.height = 1.5;
  expect_same(of(lathe_of({{0.0, 0.0}, {0.6, 1.5}})), of(cone));
}

TEST(Lathe, OutlineDrawnDownwardsIsTheSameSolid) {
  const std::vector<Vec2> up = {{0.0, 0.0}, {0.4, 0.3}, {0.05, 0.5}, {0.0, 0.9}};
  const std::vector<Vec2> down(up.rbegin(), up.rend());
  const MassProperties a = of(lathe_of(up));
  const MassProperties b = of(lathe_of(down));
  EXPECT_GT(a.mass, 0.0);
  expect_same(a, b);
}

// an outline may go back under itself: a bowl is the outer solid without the inner one
TEST(Lathe, HollowBowl) {
  const MassProperties bowl =
      of(lathe_of({{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.4}, {0.4, 0.4}, {0.4, 0.1}, {0.0, 0.1}}));
  MassProperties outer = by_quadrature(revolved([](double) { return 0.5; }, 0.0, 0.4));
  MassProperties inner = by_quadrature(revolved([](double) { return 0.4; }, 0.1, 0.4));
  inner.mass = -inner.mass;
  inner.tensor = -inner.tensor;
  expect_same(bowl, composed({outer, inner}));
}

// a sphere's outline in n chords converges to the sphere as 1/n^2
TEST(Lathe, PolygonOfASphereConverges) {
  SolidSpec sphere = solid("sphere");
  sphere.radius = 0.8;
  const double exact = of(sphere).tensor(2, 2);
  const auto error = [&](int n) {
    std::vector<Vec2> profile;
    for (int i = 0; i <= n; ++i) {
      const double a = kPi * i / n;
      profile.emplace_back(std::max(0.0, 0.8 * std::sin(a)), -0.8 * std::cos(a));
    }
    return std::abs(of(lathe_of(profile)).tensor(2, 2) - exact) / exact;
  };
  EXPECT_LE(error(200), 5e-4);
  EXPECT_NEAR(error(100) / error(200), 4.0, 0.01);
}

TEST(SolidErrors, NameTheKey) {
  SolidSpec s = solid("bax");
  expect_input_error([&] { of(s); }, "body.solid.kind", "box");

  s = solid("box");
  expect_input_error([&] { of(s); }, "body.solid", "needs 'size'");
  s.size = Vec3(1, 1, 1);
  s.radius = 1.0;
  expect_input_error([&] { of(s); }, "body.solid.radius", "has no 'radius'; it takes size");
  s.radius.reset();
  s.smooth = true;
  expect_input_error([&] { of(s); }, "body.solid.smooth", "has no 'smooth'; it takes size");
  s.smooth = false;
  s.mass = 1.0;
  expect_input_error([&] { of(s); }, "body.solid", "exactly one of mass and density");
  s.mass.reset();
  s.density.reset();
  expect_input_error([&] { of(s); }, "body.solid", "exactly one of mass and density");

  s = solid("disc");
  s.radius = 0.5;
  expect_input_error([&] { of(s); }, "body.solid.density", "has no volume");
  s.radius = 0.0;
  expect_input_error([&] { of(s); }, "body.solid.radius", "greater than 0");

  s = solid("ring");
  s.radius = 0.5;
  s.tube = 0.6;
  expect_input_error([&] { of(s); }, "body.solid.tube", "thicker");
}

TEST(SolidErrors, LatheOutlines) {
  const std::string key = "body.solid.profile";
  expect_input_error([&] { of(lathe_of({{0.5, 0.0}})); }, key, "needs 2 to 2000 points");
  expect_input_error([&] { of(lathe_of(std::vector<Vec2>(2001, Vec2(1, 0)))); }, key, "found 2001");
  expect_input_error([&] { of(lathe_of({{0.5, 0.0}, {-0.1, 1.0}})); }, key, "negative");
  expect_input_error([&] { of(lathe_of({{0.5, 1.0}, {0.2, 1.0}})); }, key, "no volume");
  expect_input_error([&] { of(lathe_of({{0.0, 0.0}, {0.0, 1.0}})); }, key, "no volume");
  const std::vector<Vec2> bow = {{0.5, 0.0}, {0.5, 1.0}, {0.8, 0.2}, {0.1, 0.6}};
  expect_input_error([&] { of(lathe_of(bow)); }, key, "meets itself near (0.5, 1)");
  // at a corner, along an edge, twice round, and there and back
  for (const std::vector<Vec2>& wrong :
       {std::vector<Vec2>{{1, -4}, {2, -4}, {1.5, 1}, {1.3, 1.5}, {1.7, 1.5}, {1.5, 1}, {1, -4}},
        {{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}},
        {{1, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 1.5}, {1, 1.5}},
        {{0, 0}, {1, 0}, {1, 2}, {1, 1}, {0.5, 2}}}) {
    expect_input_error([&] { of(lathe_of(wrong)); }, key, "meets itself");
  }
  // an hourglass and a ring are well formed
  EXPECT_GT(of(lathe_of({{0, -1}, {1, -1}, {0, 0}, {1, 1}, {0, 1}})).mass, 0.0);
  EXPECT_GT(of(lathe_of({{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}})).mass, 0.0);
}

// a smooth outline goes through its points, has no corners, and its mass is that of what is drawn
TEST(Lathe, SmoothOutlinesGoThroughTheirPoints) {
  SolidSpec solid;
  solid.kind = "lathe";
  solid.mass = 1.0;
  constexpr int kProfilePoints = 13;
  for (int i = 0; i < kProfilePoints; ++i) {
    const double angle = kPi * (static_cast<double>(i) / (kProfilePoints - 1) - 0.5);
    solid.profile.emplace_back(i == 0 || i + 1 == kProfilePoints ? 0.0 : std::cos(angle),
                               std::sin(angle));
  }
  solid.smooth = true;
  const std::vector<Vec2> outline = lathe_outline(solid);
  for (const Vec2& point : solid.profile)
    EXPECT_NE(std::find(outline.begin(), outline.end(), point), outline.end());
  double sharpest = 0.0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Vec2 a = (outline[i] - outline[i - 1]).normalized();
    const Vec2 b = (outline[i + 1] - outline[i]).normalized();
    sharpest = std::max(sharpest, std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
  }
  EXPECT_LT(sharpest, 0.12);  // the corners of the profile are 0.26
  // a ball, to the order of the curve: 2/5 m r^2
  BodySpec body;
  body.solid = solid;
  EXPECT_NEAR(polhode::mass_properties(body).tensor(2, 2), 0.4, 1e-3);
  body.solid->smooth = false;
  EXPECT_GT(std::abs(polhode::mass_properties(body).tensor(2, 2) - 0.4), 4e-3);
}

}  // namespace
}  // namespace polhode
