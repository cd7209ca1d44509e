// SPDX-License-Identifier: MIT
// Poinsot's picture: the energy ellipsoid of the body rolls without slipping on the plane that L is
// square to, and touches it at the tip of the angular velocity (Landau and Lifshitz, Mechanics,
// section 37; Goldstein, 5.6). And Binet's: in the space of L, an ellipsoid and a sphere.
#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>

#include "frame/elements/parts.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr double kPlaneRadius = 1.9;
constexpr float kPlaneShadow = 0.5f;  // how dark a full shadow on it is
constexpr double kAxisPlaneRadius = 1.45;
constexpr float kFarSide = 0.5f;  // of the colour of curves on the far side of an ellipsoid
constexpr std::size_t kPiecesOfLine = 32;
constexpr std::size_t kPointsOfCurve = 256;   // among which its name chooses
constexpr double kPlaneContactRadius = 0.04;  // of the ball at the point of contact

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

// A curve of the body's own, its mesh in units of the body's radius. ellipsoid: that it lies on,
// whose far side is paler; absent: one that hides its far side.
void add_body_curve(const Scenery& scenery,
                    const Sample& sample,
                    const MeshPtr& mesh,
                    const glm::vec3& color,
                    const std::optional<Placement>& ellipsoid,
                    Glyphs& glyphs) {
  if (!mesh) return;
  Placement place = principal_placement(scenery, sample);
  place.linear() *= scenery.scale.body;
  Material material = plain(color, 0.1f);
  material.mark_color = glm::mix(scenery.theme.background, color, kFarSide);
  glyphs.meshes.push_back({mesh, place, material, {}, ellipsoid});
  // corners of the tube are near enough to its middle
  const std::vector<Vertex>& corners = mesh->vertices;
  add_line([&](std::size_t i) { return Vec3(place * to_eigen(corners[i].position)); },
           corners.size(),
           kPiecesOfLine,
           glyphs);
}

// a direction in the invariable plane, to the right in a camera that sees L vertical, and `nearer`
// times as much towards it
Vec3 beside(const Vec3& up, double nearer) {
  const Vec3 vertical = up.z() < 0.0 ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitZ());
  const Vec3 towards = Vec3(kDefaultDirection.x(), kDefaultDirection.y(), 0.0).normalized();
  const Vec3 right = Vec3::UnitZ().cross(towards);
  return turn_between(vertical, up) * Vec3((right + nearer * towards).normalized());
}

// Where the polhode of `w_P` crosses the plane of the axes of the least and the greatest moment:
// there it is farthest from the separatrix. rad/s in P.
Vec3 crossing_of_polhode(const BodyModel& model, const Vec3& w_P) {
  int least = 0, most = 0;
  const double smallest = model.moments.minCoeff(&least);
  const double largest = model.moments.maxCoeff(&most);
  if (least == most) return w_P;
  const double middle = model.moments.sum() - smallest - largest;
  const double energy2 = twice_the_energy(model, w_P);
  const double momentum2 = model.moments.cwiseProduct(w_P).squaredNorm();
  // of the two moments of the plane, the rate about the axis of `own`
  const auto rate = [&](double own, double other) {
    return std::sqrt(std::max((momentum2 - other * energy2) / (own * (own - other)), 0.0));
  };
  Vec3 crossing = Vec3::Zero();
  crossing[least] = rate(smallest, largest);
  crossing[most] = rate(largest, smallest);
  // the side on which the curve goes round its axis
  const int axis = momentum2 >= energy2 * middle ? most : least;
  crossing[axis] = std::copysign(crossing[axis], w_P[axis]);
  return crossing;
}

}  // namespace

void add_ellipsoid(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Placement place = energy_ellipsoid(scenery, sample);
  glyphs.shells.push_back(
      {scenery.sphere, place, shell(scenery.theme.ellipsoid, 0.26f), scenery.ball});
  add_ball_reach(place, glyphs);
}

void add_plane(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3 up = sample.L_S.normalized();
  const Vec3 center = sample.reference_S + scenery.scale.omega * sample.w_S.dot(up) * up;
  // the ellipsoid rolls on it as on a floor: its upper side is that of the body
  const Placement place = disc_placement(center, -up, kPlaneRadius * scenery.scale.body);
  Material material = shell(scenery.theme.plane, 0.30f);
  material.flat = true;
  Material shadow = shell(scenery.theme.shadow, kPlaneShadow);
  shadow.flat = shadow.soft = true;
  glyphs.sheets.push_back({{scenery.disc, place, material}, center, up, shadow});
  glyphs.meshes.push_back({scenery.ring, place, plain(scenery.theme.plane, 0.1f)});
  add_rim_reach(place, 24, glyphs);
  add_line(
      [&](std::size_t i) {
        const double angle = 2.0 * kPi * static_cast<double>(i) / kPiecesOfLine;
        return Vec3(place * Vec3(std::cos(angle), std::sin(angle), 0.0));
      },
      kPiecesOfLine + 1,
      kPiecesOfLine,
      glyphs);

  const Placement contact =
      ball_placement(omega_tip(scenery, sample), kPlaneContactRadius * scenery.scale.body);
  glyphs.meshes.push_back({scenery.ball, contact, plain(scenery.theme.position, 0.3f)});
  glyphs.marks.push_back({contact.translation(), kPlaneContactRadius * scenery.scale.body});

  const Vec3 out = beside(up, 0.5);
  add_name(scenery,
           center + kPlaneRadius * scenery.scale.body * out,
           out,
           "invariable plane",
           scenery.theme.plane,
           1.0f,
           glyphs);
}

void add_polhode(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  if (!scenery.paths.polhode) return;
  // on the invariable plane one looks from above, and all of it may be on the far side
  std::optional<Placement> ellipsoid;
  const bool rolls = asks_for(scenery, "plane");
  if (!rolls) ellipsoid = energy_ellipsoid(scenery, sample);
  add_body_curve(scenery, sample, scenery.paths.polhode, scenery.theme.polhode, ellipsoid, glyphs);
  const Placement body = principal_placement(scenery, sample);
  const Vec3 crossing_P =
      crossing_of_polhode(scenery.motion.model(), principal_rate(scenery.motion.model(), sample));
  const Vec3 out = body.linear() * crossing_P;
  add_name(scenery,
           sample.reference_S + scenery.scale.omega * out,
           out,
           "polhode",
           scenery.theme.polhode,
           1.0f,
           glyphs);
  const std::vector<Vertex>& corners = scenery.paths.polhode->vertices;
  const std::size_t step = std::max<std::size_t>(corners.size() / kPointsOfCurve, 1);
  for (std::size_t i = 0; i < corners.size(); i += step) {
    glyphs.labels.back().curve.push_back(body *
                                         (scenery.scale.body * to_eigen(corners[i].position)));
  }
}

void add_polhodes(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Placement ellipsoid = energy_ellipsoid(scenery, sample);
  add_ball_reach(ellipsoid, glyphs);
  for (const MeshPtr& mesh : scenery.paths.polhodes)
    add_body_curve(scenery, sample, mesh, scenery.theme.polhodes, ellipsoid, glyphs);
  if (scenery.paths.separatrix.empty()) return;
  for (const MeshPtr& mesh : scenery.paths.separatrix)
    add_body_curve(scenery, sample, mesh, scenery.theme.velocity, ellipsoid, glyphs);
  const Vec3 out = principal_placement(scenery, sample).linear() * scenery.paths.on_separatrix_P;
  add_name(scenery,
           sample.reference_S + scenery.scale.omega * out,
           out,
           "separatrix",
           scenery.theme.velocity,
           1.0f,
           glyphs);
}

void add_herpolhode(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Trail& trail = scenery.paths.herpolhode;
  if (trail.empty()) return;
  const double begins = trail_begins(scenery, sample.t);
  add_path(trail, begins, sample.t, scenery.theme.herpolhode, glyphs);
  add_path_reach(trail, 0.0, sample.t, glyphs);
  // beside all that it will be, as soon as there is something of it
  const double turned = sample.t * sample.w_S.norm();
  const auto fade = static_cast<float>(std::clamp(turned - 2.0, 0.0, 1.0));
  if (fade <= 0.0f) return;
  const Vec3 up = sample.L_S.normalized();
  const Vec3 foot = sample.reference_S + scenery.scale.omega * sample.w_S.dot(up) * up;
  const Vec3 out = beside(up, 0.3);
  add_name(scenery,
           foot + scenery.paths.herpolhode_radius * out,
           out,
           "herpolhode",
           scenery.theme.herpolhode,
           fade,
           glyphs);
}

// {L : sum of L_i^2 / I_i = twice the energy} and the sphere of |L|, in the scale of L
void add_binet(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const BodyModel& model = scenery.motion.model();
  const double energy2 = twice_the_energy(model, principal_rate(model, sample));
  Placement ellipsoid = principal_placement(scenery, sample);
  ellipsoid.linear() =
      ellipsoid.linear() *
      (scenery.scale.momentum * (energy2 * model.moments).cwiseSqrt()).asDiagonal();
  Material material = plain(scenery.theme.ellipsoid, 0.3f);
  material.covers = true;
  glyphs.meshes.push_back({scenery.sphere, ellipsoid, material});
  add_ball_reach(ellipsoid, glyphs);
  const Placement sphere =
      ball_placement(sample.reference_S, scenery.scale.momentum * sample.L_S.norm());
  glyphs.shells.push_back({scenery.sphere, sphere, shell(scenery.theme.momentum, 0.22f)});
  add_ball_reach(sphere, glyphs);
  add_body_curve(scenery, sample, scenery.paths.binet, scenery.theme.polhode, {}, glyphs);
}

// L, Omega and the axis of a symmetric top are always in one plane
void add_axis_plane(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3 figure = sample.q_SB * figure_axis_B(scenery.motion.model());
  const Vec3 across = sample.L_S.cross(figure);
  if (across.norm() < 1e-6 * sample.L_S.norm()) return;
  const Vec3 normal = across.normalized();
  const Placement place =
      disc_placement(sample.reference_S, normal, kAxisPlaneRadius * scenery.scale.body);
  Material material = shell(scenery.theme.space_axes, 0.22f);
  material.flat = true;
  glyphs.sheets.push_back({{scenery.disc, place, material}, sample.reference_S, normal});
  glyphs.meshes.push_back({scenery.ring, place, plain(scenery.theme.space_axes, 0.1f)});
  add_rim_reach(place, 16, glyphs);
}

}  // namespace polhode
