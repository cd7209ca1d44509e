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

DrawItem piece(const MeshPtr& mesh,
               const Placement& place,
               const Material& material,
               Faces faces = Faces::front) {
  return {mesh, to_glm(place.matrix()), material, faces};
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

std::optional<ArrowRim> rim_around(const Vec3& vector,
                                   const ArrowShape& shape,
                                   const Vec3& thicker,
                                   const ArrowShape& thicker_shape) {
  constexpr double kBreadth = 0.55;  // of a whole rim, in radii of the shaft that it surrounds
  constexpr double kWhole = 0.3;     // how far the shafts are then apart at most, in widths
  const double length = vector.norm(), other_length = thicker.norm();
  if (length < 1e-3 * shape.head_length || other_length < 1e-3 * thicker_shape.head_length)
    return std::nullopt;
  const ArrowShape own = fitting(shape, length), other = fitting(thicker_shape, other_length);
  if (own.shaft_radius >= other.shaft_radius || vector.dot(thicker) <= 0.0) return std::nullopt;

  // as far as both have shafts
  const double common = std::min(length - own.head_length, other_length - other.head_length);
  const double apart = common * std::sin(angle_between(vector, thicker));
  const double width = own.shaft_radius + other.shaft_radius;
  const double part = std::clamp((width - apart) / (width - kWhole * width), 0.0, 1.0);
  if (part <= 0.0) return std::nullopt;
  const double whole = (1.0 + kBreadth) * other.shaft_radius;
  const double smooth = part * part * (3.0 - 2.0 * part);
  return ArrowRim{own.shaft_radius + smooth * (whole - own.shaft_radius), common};
}

void add_tube(std::vector<DrawItem>& items,
              const ArrowMeshes& meshes,
              const Vec3& from,
              const Vec3& to,
              double radius,
              const Material& material,
              Faces faces) {
  const Vec3 vector = to - from;
  const double length = vector.norm();
  if (length > 0.0) {
    const Placement place = standing(from, vector, radius, length);
    items.push_back(piece(meshes.shaft, place, dashed(material, length), faces));
  }
}

}  // namespace polhode
