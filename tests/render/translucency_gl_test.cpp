// SPDX-License-Identifier: MIT
// Blending order against rays: along the ray of a pixel, the nearest of the cone surfaces must be
// the one on top, from every side.
#include <cmath>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "base/units.h"
#include "frame/camera.h"
#include "frame/cone.h"
#include "render/renderer.h"

namespace polhode {
namespace {

constexpr PictureSize kPictureSize{320, 240};

// distances along the ray eye + t d at which it meets the finite cone, nearest first
std::vector<double> intersections(const Cone& cone, const Vec3& eye, const Vec3& d) {
  // (v.a)^2 = cos^2 v.v with v = eye + t d - apex, on the nappe v.a > 0, within the slant
  const Vec3 v = eye - cone.apex;
  const double c2 = std::pow(std::cos(cone.half_angle), 2);
  const double va = v.dot(cone.axis);
  const double da = d.dot(cone.axis);
  const double A = da * da - c2 * d.dot(d);
  const double B = va * da - c2 * v.dot(d);
  const double C = va * va - c2 * v.dot(v);
  const double disc = B * B - A * C;
  std::vector<double> found;
  if (disc < 0.0 || A == 0.0) return found;
  for (const double t : {(-B - std::sqrt(disc)) / A, (-B + std::sqrt(disc)) / A}) {
    const Vec3 p = v + t * d;
    const double height = p.dot(cone.axis);
    if (t > 0.0 && height > 0.02 * cone.slant &&
        height < 0.98 * cone.slant * std::cos(cone.half_angle)) {
      found.push_back(t);
    } else if (height > -0.05 && height < 1.05 * cone.slant) {
      found.push_back(-1.0);  // too near an edge to judge
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

Cone colored(const Vec3& axis, double half_angle, const glm::vec3& color) {
  Cone cone;
  cone.axis = axis.normalized();
  cone.half_angle = half_angle;
  cone.slant = 1.0;
  cone.material.color = color;
  cone.material.alpha = 0.5f;
  cone.material.gloss = 0.0f;
  return cone;
}

struct Arrangement {
  const char* name;
  Cone first;
  Cone second;
};

std::vector<Arrangement> arrangements() {
  const glm::vec3 red(1, 0, 0);
  const glm::vec3 green(0, 1, 0);
  const Vec3 up(0.2, -0.1, 1);
  const auto turned = [&](double angle) {
    return Vec3(Eigen::AngleAxisd(angle, up.cross(Vec3(1, 0.3, 0)).normalized()) * up);
  };
  return {{"touching outside", colored(up, 0.35, red), colored(turned(0.35 + 0.5), 0.5, green)},
          {"touching inside", colored(up, 0.2, red), colored(turned(0.4), 0.6, green)},
          {"apart", colored(up, 0.3, red), colored(turned(1.2), 0.4, green)},
          {"inside", colored(up, 0.2, red), colored(turned(0.1), 0.7, green)}};
}

TEST(Translucency, NearestSurfaceIsOnTopFromEverySide) {
  const std::unique_ptr<Context> context = open_context("osmesa");
  Renderer renderer(*context, {kPictureSize.width, kPictureSize.height, 4, false});
  const ConeMeshes meshes = cone_meshes(128);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  int judged = 0;
  int wrong = 0;
  for (const Arrangement& arrangement : arrangements()) {
    for (int side = 0; side < 24; ++side) {
      const Vec3 eye = 4.0 * Vec3(normal(random), normal(random), normal(random)).normalized();
      const Camera camera(eye, Vec3(0, 0, 0.3), 0.55, kPictureSize, Vec3(0, 0, 0.3), 1.2);
      for (const bool swapped : {false, true}) {
        DrawList list;
        list.view = camera.view();
        const std::vector<Cone> cones = swapped
                                            ? std::vector{arrangement.second, arrangement.first}
                                            : std::vector{arrangement.first, arrangement.second};
        add_cones(list, meshes, cones, eye);
        list.opaque.clear();
        for (DrawItem& item : list.translucent) {
          item.material.flat = true;
          item.material.alpha = 0.95f;  // what is on top dominates
        }
        Image image;
        renderer.draw(list, image);

        // rays to random points of both cones' neighbourhood
        for (int k = 0; k < 60; ++k) {
          const Vec3 near =
              Vec3(0, 0, 0.4) + 0.5 * Vec3(normal(random), normal(random), normal(random));
          const Vec2 p = camera.project(near);
          const int x = static_cast<int>(std::floor(p.x()));
          const int y = static_cast<int>(std::floor(p.y()));
          if (x < 0 || y < 0 || x >= kPictureSize.width || y >= kPictureSize.height) continue;
          const Vec3 d = (near - eye).normalized();
          const std::vector<double> a = intersections(arrangement.first, eye, d);
          const std::vector<double> b = intersections(arrangement.second, eye, d);
          if (a.empty() || b.empty() || a[0] < 0 || b[0] < 0) continue;
          if (std::abs(a[0] - b[0]) < 0.03) continue;  // too close to tell
          ++judged;
          const bool red_on_top = image.at(x, y)[0] > image.at(x, y)[1];
          wrong += red_on_top != (a[0] < b[0]) ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(judged, 500);
  EXPECT_EQ(wrong, 0) << "of " << judged;
}

}  // namespace
}  // namespace polhode
