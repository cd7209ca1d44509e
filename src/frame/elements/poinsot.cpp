// SPDX-License-Identifier: MIT
// Poinsot's picture: the energy ellipsoid of the body rolls without slipping on the plane that L is
// square to, and touches it at the tip of the angular velocity (Landau and Lifshitz, Mechanics,
// section 37; Goldstein, 5.6). And Binet's: in the space of L, an ellipsoid and a sphere.
#include "frame/elements/parts.h"

namespace polhode {
namespace {

constexpr double kPlaneRadius = 1.9;
constexpr double kAxisPlaneRadius = 1.45;

// {w : w.I w = twice the energy}, in metres of the picture
Placement energy_ellipsoid(const Stage& stage, const Sample& sample) {
  const Model& model = stage.motion.model();
  const double energy2 = twice_the_energy(model, principal_rate(model, sample));
  Placement place = principal_placement(stage, sample);
  place.linear() = place.linear() *
                   (stage.scale.omega * (energy2 * model.inverse_moments).cwiseSqrt()).asDiagonal();
  return place;
}

// points around an ellipsoid, for framing
void add_reach(const Placement& place, Marks& marks) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) marks.reach.push_back(place * Vec3(x, y, z).normalized());
      }
    }
  }
}

// a curve of the body's own, its mesh in units of the body's radius
void add_body_curve(const Stage& stage,
                    const Sample& sample,
                    const MeshPtr& mesh,
                    const glm::vec3& color,
                    Marks& marks) {
  if (!mesh) return;
  Placement place = principal_placement(stage, sample);
  place.linear() *= stage.scale.body;
  marks.meshes.push_back({mesh, place, plain(color, 0.1f)});
}

}  // namespace

void add_ellipsoid(const Stage& stage, const Sample& sample, Marks& marks) {
  const Placement place = energy_ellipsoid(stage, sample);
  marks.shells.push_back({stage.sphere, place, shell(stage.theme.ellipsoid, 0.26f)});
  add_reach(place, marks);
}

void add_plane(const Stage& stage, const Sample& sample, Marks& marks) {
  const Vec3 up = sample.L_S.normalized();
  const Vec3 center = sample.reference_S + stage.scale.omega * sample.w_S.dot(up) * up;
  const Placement place = disc_placement(center, up, kPlaneRadius * stage.scale.body);
  Material material = shell(stage.theme.plane, 0.30f);
  material.flat = true;
  marks.sheets.push_back({{stage.disc, place, material}, center, up});
  marks.meshes.push_back({stage.ring, place, plain(stage.theme.plane, 0.1f)});
  add_rim_reach(place, 24, marks);
}

void add_polhode(const Stage& stage, const Sample& sample, Marks& marks) {
  add_body_curve(stage, sample, stage.paths.polhode, stage.theme.polhode, marks);
}

void add_polhodes(const Stage& stage, const Sample& sample, Marks& marks) {
  for (const MeshPtr& mesh : stage.paths.polhodes)
    add_body_curve(stage, sample, mesh, stage.theme.space_axes, marks);
}

void add_herpolhode(const Stage& stage, const Sample& sample, Marks& marks) {
  add_path(stage.paths.herpolhode, 0.0, sample.t, stage.theme.herpolhode, marks);
}

// {L : sum of L_i^2 / I_i = twice the energy} and the sphere of |L|, in the scale of L
void add_binet(const Stage& stage, const Sample& sample, Marks& marks) {
  const Model& model = stage.motion.model();
  const double energy2 = twice_the_energy(model, principal_rate(model, sample));
  Placement ellipsoid = principal_placement(stage, sample);
  ellipsoid.linear() = ellipsoid.linear() *
                       (stage.scale.momentum * (energy2 * model.moments).cwiseSqrt()).asDiagonal();
  marks.meshes.push_back({stage.sphere, ellipsoid, plain(stage.theme.ellipsoid, 0.3f)});
  add_reach(ellipsoid, marks);
  Placement sphere = Placement::Identity();
  sphere.translation() = sample.reference_S;
  sphere.linear() *= stage.scale.momentum * sample.L_S.norm();
  marks.shells.push_back({stage.sphere, sphere, shell(stage.theme.momentum, 0.22f)});
  add_reach(sphere, marks);
  add_body_curve(stage, sample, stage.paths.binet, stage.theme.polhode, marks);
}

// L, Omega and the axis of a symmetric top are always in one plane
void add_axis_plane(const Stage& stage, const Sample& sample, Marks& marks) {
  const Vec3 figure = sample.q_SB * figure_axis_B(stage);
  const Vec3 across = sample.L_S.cross(figure);
  if (across.norm() < 1e-6 * sample.L_S.norm()) return;
  const Vec3 normal = across.normalized();
  const Placement place =
      disc_placement(sample.reference_S, normal, kAxisPlaneRadius * stage.scale.body);
  Material material = shell(stage.theme.plane, 0.22f);
  material.flat = true;
  marks.sheets.push_back({{stage.disc, place, material}, sample.reference_S, normal});
  marks.meshes.push_back({stage.ring, place, plain(stage.theme.plane, 0.1f)});
  add_rim_reach(place, 16, marks);
}

}  // namespace polhode
