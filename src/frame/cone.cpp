// SPDX-License-Identifier: MIT
#include "frame/cone.h"

#include <algorithm>
#include <cmath>

#include "frame/to_glm.h"
#include "math/so3.h"

namespace polhode {
namespace {

Mat3 turned_to(const Vec3& axis) {
  return turn_between(Vec3::UnitZ(), axis).toRotationMatrix();
}

// how much of its alpha the near wall of a narrow cone gives to the far one
constexpr double kGivenBack = 0.5;

DrawItem shell_item(const ConeMeshes& meshes, const Cone& cone, Faces faces) {
  // a body in its cone keeps its colours: the wall before it is thin, the wall behind makes up for
  // it; a flat cone has no inside, and shows the same side whichever way it opens
  const double given = kGivenBack * std::cos(cone.half_angle);
  Material wall = cone.material;
  wall.alpha *= static_cast<float>(faces == Faces::front ? 1.0 - given : 1.0 + given);
  return {meshes.shell, to_glm(cone_places(cone).shell.matrix()), wall, faces};
}

// The tube of a rim relative to the rim's own radius comes in steps of a hundredth, so that rims
// can be made once; what is left of a step is less than can be seen.
constexpr double kRimStep = 0.01;

double rim_tube(const Cone& cone) {
  // a tube that is thicker than its ring would fill it
  return std::min(cone.rim_radius, 0.9 * cone.slant * std::sin(cone.half_angle));
}

int rim_step(const Cone& cone) {
  const double across = cone.slant * std::sin(cone.half_angle);
  return static_cast<int>(std::lround(std::log(rim_tube(cone) / across) / kRimStep));
}

MeshPtr rim_mesh(int step, int segments) {
  return std::make_shared<const Mesh>(torus(1.0, std::exp(kRimStep * step), segments));
}

DrawItem rim_item(const ConeMeshes& meshes, const Cone& cone) {
  const int step = rim_step(cone);
  const auto ready = meshes.rims.find(step);
  const MeshPtr mesh = ready != meshes.rims.end() ? ready->second : rim_mesh(step, meshes.segments);
  const double across = cone.slant * std::sin(cone.half_angle);
  const double along = rim_tube(cone) / std::exp(kRimStep * step);
  Placement place = cone_places(cone).rim;
  place.linear() = turned_to(cone.axis) * Vec3(across, across, along).asDiagonal();
  Material solid = cone.material;
  solid.alpha = 1.0f;
  return {mesh, to_glm(place.matrix()), solid, Faces::front};
}

// is `inner` inside `outer`, touching allowed?
bool nested(const Cone& inner, const Cone& outer) {
  return inner.half_angle < outer.half_angle &&
         angle_between(inner.axis, outer.axis) <= outer.half_angle - inner.half_angle + 1e-6;
}

// of two separated cones: is `a` on the far side of the plane between them?
bool farther(const Cone& a, const Cone& b, const Vec3& eye) {
  // the plane holds the apex, the direction between the nearest generators, and is square to the
  // plane of the axes
  const Vec3 normal_of_axes = a.axis.cross(b.axis);
  if (normal_of_axes.norm() < 1e-9) return b.axis.dot(eye - a.apex) > 0.0;  // opposite
  const double apart = angle_between(a.axis, b.axis);
  const double gap = apart - a.half_angle - b.half_angle;
  const double from_a = a.half_angle + 0.5 * gap;
  const Vec3 between = Eigen::AngleAxisd(from_a, normal_of_axes.normalized()) * a.axis;
  const Vec3 towards_b = normal_of_axes.normalized().cross(between);
  return towards_b.dot(eye - a.apex) > 0.0;
}

}  // namespace

// the unit shell has radius = height; a flat one keeps a sliver of height for its normals, too low
// to be seen, so that its axis can change sign
ConePlaces cone_places(const Cone& cone) {
  const double across = cone.slant * std::sin(cone.half_angle);
  const double along = std::max(cone.slant * std::cos(cone.half_angle), 1e-5 * cone.slant);
  const Mat3 turn = turned_to(cone.axis);
  ConePlaces places;
  places.shell.translation() = cone.apex;
  places.shell.linear() = turn * Vec3(across, across, along).asDiagonal();
  places.rim.translation() = cone.apex + cone.axis * cone.slant * std::cos(cone.half_angle);
  places.rim.linear() = turn * across;
  places.tube = rim_tube(cone) / across;
  return places;
}

ConeMeshes cone_meshes(int segments, const std::vector<Cone>& expected) {
  // the rim hides where a shell ends; long thin triangles are dear
  const int of_shell = segments * 7 / 10;
  ConeMeshes meshes{std::make_shared<const Mesh>(unit_cone_shell(of_shell)), segments, {}};
  constexpr std::size_t kMostReady = 64;
  for (const Cone& cone : expected) {
    const int step = rim_step(cone);
    if (meshes.rims.size() < kMostReady && meshes.rims.count(step) == 0)
      meshes.rims[step] = rim_mesh(step, segments);
  }
  return meshes;
}

void add_cones(DrawList& list,
               const ConeMeshes& meshes,
               const std::vector<Cone>& cones,
               const Vec3& eye) {
  for (const Cone& cone : cones)
    list.opaque.push_back(rim_item(meshes, cone));

  // insert each shell around or beside those that are already in order
  std::vector<DrawItem> order;
  std::vector<const Cone*> placed;
  for (const Cone& cone : cones) {
    const DrawItem back = shell_item(meshes, cone, Faces::back);
    const DrawItem front = shell_item(meshes, cone, Faces::front);
    const bool is_outer = std::any_of(
        placed.begin(), placed.end(), [&](const Cone* other) { return nested(*other, cone); });
    const bool is_inner = std::any_of(
        placed.begin(), placed.end(), [&](const Cone* other) { return nested(cone, *other); });
    const bool is_far =
        !is_outer && !is_inner && !placed.empty() && farther(cone, *placed.back(), eye);
    if (is_outer) {
      order.insert(order.begin(), back);
      order.push_back(front);
    } else if (is_inner) {
      order.insert(order.end() - 1, {back, front});
    } else if (is_far) {
      order.insert(order.begin(), {back, front});
    } else {
      order.insert(order.end(), {back, front});
    }
    placed.push_back(&cone);
  }
  list.translucent.insert(list.translucent.end(), order.begin(), order.end());
}

}  // namespace polhode
