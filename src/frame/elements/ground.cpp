// SPDX-License-Identifier: MIT
// What the body stands on, and the body itself.
#include <algorithm>
#include <limits>

#include "frame/elements/parts.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr double kStandHeight = 0.55;
constexpr double kStandRadius = 0.17;
constexpr double kFloorRadius = 1.9;
constexpr double kFreeFloor = 1.25;    // below the centre of a free body
constexpr double kShadowRadius = 1.3;  // of the body's shadow on the floor
constexpr double kShadowDepth = 0.75;  // how dark its middle is
constexpr float kGhostAlpha = 0.16f;

// where the floor is: under the stand, or below all that a free body reaches
double floor_depth(const Stage& stage) {
  return (stage.motion.model().on_pivot ? kStandHeight : kFreeFloor) * stage.scale.body;
}

}  // namespace

void add_body(const Stage& stage, const Sample& sample, Marks& marks) {
  const Placement space_from_body = body_placement(stage, sample);
  for (const LookPart& part : stage.look) {
    Material material = part.material;
    material.alpha = static_cast<float>(stage.options.body_opacity);
    marks.meshes.push_back({part.mesh, space_from_body * part.body_from_mesh, material});
  }
  for (const Vec3& point_B : stage.hull_B)
    marks.reach.push_back(space_from_body * point_B);
}

// the body where it was, at equal times back from now
void add_ghosts(const Stage& stage, const Sample& sample, Marks& marks) {
  const double apart = stage.options.ghost_s.value_or(stage.motion.duration() / 40.0);
  for (int k = stage.options.ghost_count; k >= 1; --k) {
    const double t = sample.t - k * apart;
    if (t < 0.0) continue;
    const Placement place = body_placement(stage, stage.motion.at(t));
    for (const LookPart& part : stage.look) {
      Material material = part.material;
      material.alpha =
          kGhostAlpha * static_cast<float>(1.0 - 0.6 * (k - 1.0) / stage.options.ghost_count);
      marks.ghosts.push_back({part.mesh, place * part.body_from_mesh, material});
    }
    for (const Vec3& point_B : stage.hull_B)
      marks.reach.push_back(place * point_B);
  }
}

void add_stand(const Stage& stage, const Sample&, Marks& marks) {
  const Vec3& up = stage.motion.model().up_S;
  const double size = stage.scale.body;
  Placement place = Placement::Identity();
  place.translation() = -kStandHeight * size * up;
  place.linear() = turn_between(Vec3::UnitZ(), up).toRotationMatrix() *
                   (size * Vec3(kStandRadius, kStandRadius, kStandHeight)).asDiagonal();
  marks.meshes.push_back({stage.stand, place, plain(stage.theme.stand, 0.3f)});
  // corners around the foot
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0})
      marks.reach.push_back(place * Vec3(x, y, 0.0));
  }
}

// a disc, with a shadow that is darkest where the body is near
void add_floor(const Stage& stage, const Sample& sample, Marks& marks) {
  const Vec3& up = stage.motion.model().up_S;
  const double depth = floor_depth(stage);
  const Vec3 start = stage.motion.at(0.0).reference_S;
  const Vec3 center = start - depth * up;
  const Placement place = disc_placement(center, up, kFloorRadius * stage.scale.body);
  marks.meshes.push_back({stage.disc, place, plain(stage.theme.floor, 0.0f)});
  add_rim_reach(place, 16, marks);

  // under the middle of the body, wider and paler the higher it is
  Vec3 middle = Vec3::Zero();
  double lowest = std::numeric_limits<double>::infinity();
  const Placement body = body_placement(stage, sample);
  for (const Vec3& point_B : stage.hull_B) {
    const Vec3 point = body * point_B - center;
    middle += (point - point.dot(up) * up) / static_cast<double>(stage.hull_B.size());
    lowest = std::min(lowest, point.dot(up));
  }
  const double high = std::clamp(lowest / depth, 0.0, 1.0);
  const double wide = kShadowRadius * (0.75 + 0.5 * high) * stage.scale.body;
  Material shade = plain(glm::vec3(0.0f), 0.0f);
  shade.flat = shade.soft = true;
  shade.alpha = static_cast<float>(kShadowDepth * (1.0 - 0.6 * high));
  const Vec3 just_above = center + middle + 1e-3 * stage.scale.body * up;
  marks.shades.push_back({stage.disc, disc_placement(just_above, up, wide), shade});
}

}  // namespace polhode
