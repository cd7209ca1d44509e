// SPDX-License-Identifier: MIT
#include "frame/arrow.h"

#include <algorithm>

#include "frame/to_glm.h"
#include "math/so3.h"

namespace polhode {
namespace {

// stands the unit piece on `base`, z along `direction`, with this radius and length
DrawItem piece(const MeshPtr& mesh,
               const Vec3& base,
               const Vec3& direction,
               double radius,
               double length,
               const Material& material) {
  Placement place = Placement::Identity();
  place.translation() = base;
  place.linear() = turn_between(Vec3::UnitZ(), direction).toRotationMatrix() *
                   Vec3(radius, radius, length).asDiagonal();
  return {mesh, to_glm(place.matrix()), material, Faces::front};
}

}  // namespace

ArrowMeshes arrow_meshes(int around_shaft, int around_head) {
  return {std::make_shared<const Mesh>(unit_cylinder(around_shaft)),
          std::make_shared<const Mesh>(unit_cone(around_head))};
}

void add_arrow(std::vector<DrawItem>& items,
               const ArrowMeshes& meshes,
               const Vec3& from,
               const Vec3& tip,
               const ArrowShape& shape,
               const Material& material) {
  const Vec3 vector = tip - from;
  const double length = vector.norm();
  if (length < 1e-3 * shape.head_length) return;

  // the head takes at most two thirds of a short vector, in proportion
  const double head = std::min(shape.head_length, length * 2.0 / 3.0);
  const double shrink = head / shape.head_length;
  const Vec3 neck = tip - vector * (head / length);
  items.push_back(
      piece(meshes.shaft, from, vector, shape.shaft_radius * shrink, length - head, material));
  items.push_back(piece(meshes.head, neck, vector, shape.head_radius * shrink, head, material));
}

void add_tube(std::vector<DrawItem>& items,
              const ArrowMeshes& meshes,
              const Vec3& from,
              const Vec3& to,
              double radius,
              const Material& material) {
  const Vec3 vector = to - from;
  const double length = vector.norm();
  if (length > 0.0) items.push_back(piece(meshes.shaft, from, vector, radius, length, material));
}

}  // namespace polhode
