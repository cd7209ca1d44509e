// SPDX-License-Identifier: MIT
// Paths of points in space.
#include "frame/elements/parts.h"

namespace polhode {
namespace {

void add_path(const Stage& stage,
              const Sample& sample,
              const Trail& trail,
              const glm::vec3& color,
              Marks& marks) {
  if (trail.empty()) return;
  const double from = sample.t - stage.options.trail_s.value_or(stage.motion.duration());
  for (const MeshPtr& mesh : trail.part(std::max(0.0, from), sample.t))
    marks.meshes.push_back({mesh, trail.place(), plain(color, 0.1f)});
  for (std::size_t i = 0; i < trail.path().points.size(); i += 8)
    marks.reach.push_back(trail.path().points[i]);
}

}  // namespace

void add_trail(const Stage& stage, const Sample& sample, Marks& marks) {
  add_path(stage, sample, stage.paths.axis, stage.theme.trail, marks);
}

void add_point_trails(const Stage& stage, const Sample& sample, Marks& marks) {
  for (const Trail& trail : stage.paths.points)
    add_path(stage, sample, trail, stage.theme.trail, marks);
}

// the sphere on which the body's axis writes
void add_trail_sphere(const Stage& stage, const Sample& sample, Marks& marks) {
  Placement place = Placement::Identity();
  place.translation() = sample.reference_S;
  place.linear() *= 0.997 * kTrailRadius * stage.scale.body;
  marks.shells.push_back({stage.sphere, place, shell(stage.theme.plane, 0.12f)});
  for (int i = 0; i < 3; ++i) {
    marks.reach.push_back(place * Vec3(Vec3::Unit(i)));
    marks.reach.push_back(place * Vec3(-Vec3::Unit(i)));
  }
}

}  // namespace polhode
