// SPDX-License-Identifier: MIT
#include "frame/cone.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "frame/to_glm.h"
#include "math/so3.h"

namespace polhode {
namespace {

Cone cone_about(const Vec3& axis, double half_angle) {
  Cone cone;
  cone.apex = Vec3(0.3, -0.2, 0.1);
  cone.axis = axis.normalized();
  cone.half_angle = half_angle;
  cone.slant = 1.5;
  cone.rim_radius = 0.02;
  cone.material.alpha = 0.3f;
  return cone;
}

DrawList drawn(const std::vector<Cone>& cones, const Vec3& eye) {
  DrawList list;
  add_cones(list, cone_meshes(96), cones, eye);
  return list;
}

// calls f(point) for every corner of the item, relative to the apex
template <class Use>
void each_corner(const DrawItem& item, const Cone& cone, const Use& use) {
  for (const Vertex& vertex : item.mesh->vertices) {
    const glm::vec4 at = item.world_from_mesh * glm::vec4(vertex.position, 1.0f);
    use(Vec3(Vec3(at.x, at.y, at.z) - cone.apex));
  }
}

// which shell, of which side: how the order is told
std::string order_of(const DrawList& list, const std::vector<Cone>& cones) {
  std::string order;
  for (const DrawItem& item : list.translucent) {
    for (std::size_t i = 0; i < cones.size(); ++i) {
      if (item.material.color != cones[i].material.color) continue;
      order += static_cast<char>('a' + i);
      order += item.faces == Faces::back ? '-' : '+';
    }
  }
  return order;
}

std::vector<Cone> colored(std::vector<Cone> cones) {
  for (std::size_t i = 0; i < cones.size(); ++i)
    cones[i].material.color = glm::vec3(0.25f * static_cast<float>(i));
  return cones;
}

// every corner of the rim's tube is the tube's radius away from the circle where generators end, in
// wide and in narrow cones; of the narrowest the tube is as wide as they are
TEST(Cone, RimIsARoundTube) {
  for (const double half_angle : {0.003, 0.02, 0.05, 0.1, 0.7, 1.4, 0.5 * kPi}) {
    const Cone cone = cone_about({1, -2, 0.5}, half_angle);
    const double radius = cone.slant * std::sin(half_angle);
    const double tube = std::min(cone.rim_radius, 0.9 * radius);
    const ConeMeshes ready = cone_meshes(96, {cone});
    ASSERT_EQ(ready.rims.size(), 1u);
    for (const ConeMeshes& meshes : {ready, cone_meshes(96)}) {
      DrawList list;
      add_cones(list, meshes, {cone}, {5, 0, 0});
      ASSERT_EQ(list.opaque.size(), 1u);
      double nearest = 1e9, farthest = 0.0;
      each_corner(list.opaque[0], cone, [&](const Vec3& point) {
        const double along = point.dot(cone.axis);
        const double across = (point - along * cone.axis).norm();
        const double off = std::hypot(along - cone.slant * std::cos(half_angle), across - radius);
        nearest = std::min(nearest, off / tube);
        farthest = std::max(farthest, off / tube);
      });
      EXPECT_GT(nearest, 0.95) << half_angle;
      EXPECT_LT(farthest, 1.1) << half_angle;
      EXPECT_EQ(list.opaque[0].material.alpha, 1.0f);
    }
  }
}

// how high above the plane through the apex a cone's corners are, and how far out
struct Reach {
  double low = 1e9, high = -1e9, out = 0.0;
};
Reach reach_of(const DrawItem& item, const Cone& cone, const Vec3& up) {
  Reach reach;
  each_corner(item, cone, [&](const Vec3& point) {
    reach.low = std::min(reach.low, point.dot(up));
    reach.high = std::max(reach.high, point.dot(up));
    reach.out = std::max(reach.out, point.cross(up).norm());
  });
  return reach;
}

// as wide as can be it is a disc, about either direction; what is drawn first stays the same
TEST(Cone, TurnsOverWithoutAJump) {
  const Vec3 up = Vec3(0.3, -0.4, 1.0).normalized();
  for (const double short_of : {1e-3, 1e-6, 0.0}) {
    const Cone above = cone_about(up, 0.5 * kPi - short_of);
    const Cone below = cone_about(-up, 0.5 * kPi - short_of);
    const DrawList one = drawn({above}, {4, 1, 3}), other = drawn({below}, {4, 1, 3});
    for (const auto& [a, b] : {std::pair{one.opaque[0], other.opaque[0]},
                               {one.translucent[0], other.translucent[0]},
                               {one.translucent[1], other.translucent[1]}}) {
      const Reach at = reach_of(a, above, up), past = reach_of(b, below, up);
      const double allowed = above.slant * (2.0 * short_of + 3e-5);
      EXPECT_NEAR(at.low, past.low, allowed);
      EXPECT_NEAR(at.high, past.high, allowed);
      EXPECT_NEAR(at.out, past.out, 1e-5);
      EXPECT_EQ(a.material.alpha, b.material.alpha);
      EXPECT_EQ(a.faces, b.faces);
    }
    // the eye sees the inside of one and the outside of the other
    EXPECT_NEAR(one.translucent[0].material.alpha, other.translucent[1].material.alpha, short_of);
  }
  // from above the flat one is behind what stands on it, from below in front
  for (const double side : {1.0, -1.0}) {
    const std::vector<Cone> cones =
        colored({cone_about(side * up, 0.5 * kPi), cone_about(up, 0.3)});
    EXPECT_EQ(order_of(drawn(cones, 5.0 * up), cones).front(), 'a') << side;
    const std::string from_below = order_of(drawn(cones, -5.0 * up), cones);
    EXPECT_EQ(from_below.substr(from_below.size() - 2), "a+") << side;
  }
}

// the near wall, through which a body is seen, is thinner; together they are what was asked for
TEST(Cone, WallBeforeTheBodyIsThin) {
  const Cone cone = cone_about({0.2, 0.1, 1}, 0.4);
  const DrawList list = drawn({cone}, {4, 1, 3});
  ASSERT_EQ(list.translucent.size(), 2u);
  const DrawItem& far = list.translucent[0];
  const DrawItem& near = list.translucent[1];
  EXPECT_EQ(near.faces, Faces::front);
  EXPECT_LT(near.material.alpha, 0.6f * cone.material.alpha);
  EXPECT_NEAR(near.material.alpha + far.material.alpha, 2.0f * cone.material.alpha, 1e-6f);
}

// every corner of the shell is on the cone, up to what a polygon is off its circle
TEST(Cone, ShellHasTheHalfAngle) {
  for (const double half_angle : {0.05, 0.5, 1.2}) {
    const Cone cone = cone_about({0.2, 0.1, -1}, half_angle);
    const DrawList list = drawn({cone}, {0, 5, 0});
    ASSERT_EQ(list.translucent.size(), 2u);
    double longest = 0.0;
    each_corner(list.translucent[0], cone, [&](const Vec3& point) {
      if (point.norm() < 1e-6) return;
      EXPECT_NEAR(std::tan(angle_between(point, cone.axis)) / std::tan(half_angle), 1.0, 2e-3);
      longest = std::max(longest, point.norm());
    });
    EXPECT_NEAR(longest, cone.slant, 2e-3 * cone.slant);
  }
}

// outer back, inner, outer front, in whichever order they are given
TEST(Cone, NestedShellsAreDrawnInsideEachOther) {
  const Cone inner = cone_about({0, 0.1, 1}, 0.2), outer = cone_about({0, 0, 1}, 0.6);
  const std::vector<Cone> cones = colored({inner, outer});
  EXPECT_EQ(order_of(drawn(cones, {5, 0, 0}), cones), "b-a-a+b+");
  const std::vector<Cone> other = colored({outer, inner});
  EXPECT_EQ(order_of(drawn(other, {5, 0, 0}), other), "a-b-b+a+");
}

// of two beside each other the farther one comes first, from both sides
TEST(Cone, TheFartherOfTwoIsDrawnFirst) {
  const std::vector<Cone> cones =
      colored({cone_about({1, 0, 0.2}, 0.3), cone_about({-1, 0, 0.2}, 0.3)});
  EXPECT_EQ(order_of(drawn(cones, {9, 0, 0}), cones), "b-b+a-a+");
  EXPECT_EQ(order_of(drawn(cones, {-9, 0, 0}), cones), "a-a+b-b+");
}

}  // namespace
}  // namespace polhode
