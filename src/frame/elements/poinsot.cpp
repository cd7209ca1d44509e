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
Placement energy_ellipsoid(const Scenery& scenery, const Sample& sample) {
  const BodyModel& model = scenery.motion.model();
  const double energy2 = twice_the_energy(model, principal_rate(model, sample));
  Placement place = principal_placement(scenery, sample);
  place.linear() =
      place.linear() *
      (scenery.scale.omega * (energy2 * model.inverse_moments).cwiseSqrt()).asDiagonal();
  return place;
}

// points around an ellipsoid, for framing
void add_reach(const Placement& place, Glyphs& glyphs) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) glyphs.reach.push_back(place * Vec3(x, y, z).normalized());
      }
    }
  }
}

// a curve of the body's own, its mesh in units of the body's radius
void add_body_curve(const Scenery& scenery,
                    const Sample& sample,
                    const MeshPtr& mesh,
                    const glm::vec3& color,
                    Glyphs& glyphs) {
  if (!mesh) return;
  Placement place = principal_placement(scenery, sample);
  place.linear() *= scenery.scale.body;
  glyphs.meshes.push_back({mesh, place, plain(color, 0.1f)});
}

}  // namespace

void add_ellipsoid(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Placement place = energy_ellipsoid(scenery, sample);
  glyphs.shells.push_back({scenery.sphere, place, shell(scenery.theme.ellipsoid, 0.26f)});
  add_reach(place, glyphs);
}

void add_plane(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3 up = sample.L_S.normalized();
  const Vec3 center = sample.reference_S + scenery.scale.omega * sample.w_S.dot(up) * up;
  const Placement place = disc_placement(center, up, kPlaneRadius * scenery.scale.body);
  Material material = shell(scenery.theme.plane, 0.30f);
  material.flat = true;
  glyphs.sheets.push_back({{scenery.disc, place, material}, center, up});
  glyphs.meshes.push_back({scenery.ring, place, plain(scenery.theme.plane, 0.1f)});
  add_rim_reach(place, 24, glyphs);
}

void add_polhode(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  add_body_curve(scenery, sample, scenery.paths.polhode, scenery.theme.polhode, glyphs);
}

void add_polhodes(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  for (const MeshPtr& mesh : scenery.paths.polhodes)
    add_body_curve(scenery, sample, mesh, scenery.theme.space_axes, glyphs);
}

void add_herpolhode(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  add_path(scenery.paths.herpolhode, 0.0, sample.t, scenery.theme.herpolhode, glyphs);
}

// {L : sum of L_i^2 / I_i = twice the energy} and the sphere of |L|, in the scale of L
void add_binet(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const BodyModel& model = scenery.motion.model();
  const double energy2 = twice_the_energy(model, principal_rate(model, sample));
  Placement ellipsoid = principal_placement(scenery, sample);
  ellipsoid.linear() =
      ellipsoid.linear() *
      (scenery.scale.momentum * (energy2 * model.moments).cwiseSqrt()).asDiagonal();
  glyphs.meshes.push_back({scenery.sphere, ellipsoid, plain(scenery.theme.ellipsoid, 0.3f)});
  add_reach(ellipsoid, glyphs);
  Placement sphere = Placement::Identity();
  sphere.translation() = sample.reference_S;
  sphere.linear() *= scenery.scale.momentum * sample.L_S.norm();
  glyphs.shells.push_back({scenery.sphere, sphere, shell(scenery.theme.momentum, 0.22f)});
  add_reach(sphere, glyphs);
  add_body_curve(scenery, sample, scenery.paths.binet, scenery.theme.polhode, glyphs);
}

// L, Omega and the axis of a symmetric top are always in one plane
void add_axis_plane(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3 figure = sample.q_SB * figure_axis_B(scenery);
  const Vec3 across = sample.L_S.cross(figure);
  if (across.norm() < 1e-6 * sample.L_S.norm()) return;
  const Vec3 normal = across.normalized();
  const Placement place =
      disc_placement(sample.reference_S, normal, kAxisPlaneRadius * scenery.scale.body);
  Material material = shell(scenery.theme.plane, 0.22f);
  material.flat = true;
  glyphs.sheets.push_back({{scenery.disc, place, material}, sample.reference_S, normal});
  glyphs.meshes.push_back({scenery.ring, place, plain(scenery.theme.plane, 0.1f)});
  add_rim_reach(place, 16, glyphs);
}

}  // namespace polhode
