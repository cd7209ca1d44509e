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
double floor_depth(const Scenery& scenery) {
  return (scenery.motion.model().on_pivot ? kStandHeight : kFreeFloor) * scenery.scale.body;
}

}  // namespace

void add_body(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Placement space_from_body = body_placement(scenery, sample);
  for (const LookPart& part : scenery.look) {
    Material material = part.material;
    material.alpha = static_cast<float>(scenery.options.body_opacity);
    material.covers = true;
    glyphs.meshes.push_back({part.mesh, space_from_body * part.body_from_mesh, material});
  }
  for (const Vec3& point_B : scenery.hull_B)
    glyphs.reach.push_back(space_from_body * point_B);
}

// the body where it was, at equal times back from now
void add_ghosts(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const double apart = scenery.options.ghost_s.value_or(scenery.motion.duration() / 40.0);
  for (int k = scenery.options.ghost_count; k >= 1; --k) {
    const double t = sample.t - k * apart;
    if (t < 0.0) continue;
    const Placement place = body_placement(scenery, scenery.motion.at(t));
    for (const LookPart& part : scenery.look) {
      Material material = part.material;
      material.alpha =
          kGhostAlpha * static_cast<float>(1.0 - 0.6 * (k - 1.0) / scenery.options.ghost_count);
      glyphs.ghosts.push_back({part.mesh, place * part.body_from_mesh, material});
    }
    for (const Vec3& point_B : scenery.hull_B)
      glyphs.reach.push_back(place * point_B);
  }
}

void add_stand(const Scenery& scenery, const Sample&, Glyphs& glyphs) {
  const Vec3& up = scenery.motion.model().up_S;
  const double size = scenery.scale.body;
  Placement place = Placement::Identity();
  place.translation() = -kStandHeight * size * up;
  place.linear() = turn_between(Vec3::UnitZ(), up).toRotationMatrix() *
                   (size * Vec3(kStandRadius, kStandRadius, kStandHeight)).asDiagonal();
  Material material = plain(scenery.theme.stand, 0.3f);
  material.covers = true;
  glyphs.meshes.push_back({scenery.stand, place, material});
  // corners around the foot
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0})
      glyphs.reach.push_back(place * Vec3(x, y, 0.0));
  }
}

// a disc, with a shadow that is darkest where the body is near
void add_floor(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3& up = scenery.motion.model().up_S;
  const double depth = floor_depth(scenery);
  const Vec3 start = scenery.motion.at(0.0).reference_S;
  const Vec3 center = start - depth * up;
  const Placement place = disc_placement(center, up, kFloorRadius * scenery.scale.body);
  Material material = plain(scenery.theme.floor, 0.0f);
  material.covers = true;
  glyphs.meshes.push_back({scenery.disc, place, material});
  add_rim_reach(place, 16, glyphs);

  // under the middle of the body, wider and paler the higher it is
  Vec3 middle = Vec3::Zero();
  double lowest = std::numeric_limits<double>::infinity();
  const Placement body = body_placement(scenery, sample);
  for (const Vec3& point_B : scenery.hull_B) {
    const Vec3 point = body * point_B - center;
    middle += (point - point.dot(up) * up) / static_cast<double>(scenery.hull_B.size());
    lowest = std::min(lowest, point.dot(up));
  }
  const double high = std::clamp(lowest / depth, 0.0, 1.0);
  const double wide = kShadowRadius * (0.75 + 0.5 * high) * scenery.scale.body;
  Material shade = plain(glm::vec3(0.0f), 0.0f);
  shade.flat = shade.soft = true;
  shade.alpha = static_cast<float>(kShadowDepth * (1.0 - 0.6 * high));
  const Vec3 just_above = center + middle + 1e-3 * scenery.scale.body * up;
  glyphs.shades.push_back({scenery.disc, disc_placement(just_above, up, wide), shade});
}

}  // namespace polhode
