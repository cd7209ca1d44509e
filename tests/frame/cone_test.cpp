// SPDX-License-Identifier: MIT
#include "frame/cone.h"

#include <cmath>

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

// every corner of the rim's tube is the tube's radius away from the circle where generators end
TEST(Cone, RimIsACircle) {
  for (const double half_angle : {0.1, 0.7, 1.4}) {
    const Cone cone = cone_about({1, -2, 0.5}, half_angle);
    const DrawList list = drawn({cone}, {5, 0, 0});
    ASSERT_EQ(list.opaque.size(), 1u);
    each_corner(list.opaque[0], cone, [&](const Vec3& point) {
      const double along = point.dot(cone.axis);
      const double across = (point - along * cone.axis).norm();
      const double radius = cone.slant * std::sin(half_angle);
      // the tube is round along the axis; across it is as thick as the ring's own proportion
      const double off_along = (along - cone.slant * std::cos(half_angle)) / cone.rim_radius;
      const double off_across = (across - radius) / (radius * kRimTube);
      EXPECT_NEAR(std::hypot(off_along, off_across), 1.0, 0.2);
    });
    EXPECT_EQ(list.opaque[0].material.alpha, 1.0f);
  }
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
