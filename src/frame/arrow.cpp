// SPDX-License-Identifier: MIT
#include "frame/arrow.h"

#include <algorithm>

#include "frame/to_glm.h"
#include "math/so3.h"

namespace polhode {
namespace {

// of a unit piece that stands on `base`, z along `direction`, with this radius and length
Placement standing(const Vec3& base, const Vec3& direction, double radius, double length) {
  Placement place = Placement::Identity();
  place.translation() = base;
  place.linear() = turn_between(Vec3::UnitZ(), direction).toRotationMatrix() *
                   Vec3(radius, radius, length).asDiagonal();
  return place;
}

DrawItem piece(const MeshPtr& mesh, const Placement& place, const Material& material) {
  return {mesh, to_glm(place.matrix()), material, Faces::front};
}

// what is hidden of a line is dashed from its foot on, if it is dashed at all
Material dashed(Material material, double length) {
  if (material.dashes > 0.0f) material.dashes = static_cast<float>(length / kDashLength);
  return material;
}

Material unbroken(Material material) {
  material.dashes = 0.0f;
  return material;
}

}  // namespace

ArrowMeshes arrow_meshes(int around_shaft, int around_head) {
  return {std::make_shared<const Mesh>(unit_cylinder(around_shaft)),
          std::make_shared<const Mesh>(unit_cone(around_head))};
}

ArrowShape fitting(const ArrowShape& shape, double length) {
  const double head = std::min(shape.head_length, length * 2.0 / 3.0);
  const double shrink = head / shape.head_length;
  return {shape.shaft_radius * shrink, shape.head_radius * shrink, head};
}

std::optional<ArrowPlaces> arrow_places(const Vec3& from,
                                        const Vec3& tip,
                                        const ArrowShape& shape) {
  const Vec3 vector = tip - from;
  const double length = vector.norm();
  if (length < 1e-3 * shape.head_length) return std::nullopt;
  const auto& [shaft_radius, head_radius, head] = fitting(shape, length);
  const Vec3 neck = tip - vector * (head / length);
  return ArrowPlaces{standing(from, vector, shaft_radius, length - head),
                     standing(neck, vector, head_radius, head)};
}

void add_arrow(std::vector<DrawItem>& items,
               const ArrowMeshes& meshes,
               const Vec3& from,
               const Vec3& tip,
               const ArrowShape& shape,
               const Material& material) {
  const std::optional<ArrowPlaces> places = arrow_places(from, tip, shape);
  if (!places) return;
  const double length = (tip - from).norm();
  const double shaft = length - fitting(shape, length).head_length;
  items.push_back(piece(meshes.shaft, places->shaft, dashed(material, shaft)));
  items.push_back(piece(meshes.head, places->head, unbroken(material)));
}

void add_tube(std::vector<DrawItem>& items,
              const ArrowMeshes& meshes,
              const Vec3& from,
              const Vec3& to,
              double radius,
              const Material& material) {
  const Vec3 vector = to - from;
  const double length = vector.norm();
  if (length > 0.0) {
    const Placement place = standing(from, vector, radius, length);
    items.push_back(piece(meshes.shaft, place, dashed(material, length)));
  }
}

}  // namespace polhode
