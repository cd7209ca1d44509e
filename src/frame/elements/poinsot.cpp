// SPDX-License-Identifier: MIT
// Poinsot's picture: the energy ellipsoid of the body rolls without slipping on the plane that L is
// square to, and touches it at the tip of the angular velocity (Landau and Lifshitz, Mechanics,
// section 37; Goldstein, 5.6). And Binet's: in the space of L, an ellipsoid and a sphere.
#include <algorithm>
#include <cmath>

#include "frame/elements/parts.h"

namespace polhode {
namespace {

constexpr double kPlaneRadius = 1.9;
constexpr int kFamily = 9;  // polhodes between two axes

// {w : w.I w = twice the energy}, in metres of the picture
Placement energy_ellipsoid(const Stage& stage, const Sample& sample) {
  const Model& model = stage.motion.model();
  const Vec3 w_P = model.R_BP.transpose() * sample.w_B;
  const double energy2 = w_P.dot(model.moments.cwiseProduct(w_P));
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
  Placement place = Placement::Identity();
  place.translation() = center;
  place.linear() = Quat::FromTwoVectors(Vec3::UnitZ(), up).toRotationMatrix() *
                   (kPlaneRadius * stage.scale.body);
  Material material = shell(stage.theme.plane, 0.30f);
  material.flat = true;
  marks.sheets.push_back({{stage.disc, place, material}, center, up});
  Material rim = plain(stage.theme.plane, 0.1f);
  marks.meshes.push_back({stage.ring, place, rim});
  for (int k = 0; k < 24; ++k) {
    const double angle = 2.0 * kPi * k / 24;
    marks.reach.push_back(place * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
}

void add_polhode(const Stage& stage, const Sample& sample, Marks& marks) {
  add_body_curve(stage, sample, stage.paths.polhode, stage.theme.polhode, marks);
}

void add_polhodes(const Stage& stage, const Sample& sample, Marks& marks) {
  for (const MeshPtr& mesh : stage.paths.polhodes)
    add_body_curve(stage, sample, mesh, stage.theme.space_axes, marks);
}

void add_herpolhode(const Stage& stage, const Sample& sample, Marks& marks) {
  const Material material = plain(stage.theme.herpolhode, 0.1f);
  for (const MeshPtr& mesh : stage.paths.herpolhode.part(0.0, sample.t))
    marks.meshes.push_back({mesh, stage.paths.herpolhode.place(), material});
  const std::vector<Vec3>& points = stage.paths.herpolhode.path().points;
  for (std::size_t i = 0; i < points.size(); i += 8)
    marks.reach.push_back(points[i]);
}

// {L : sum of L_i^2 / I_i = twice the energy} and the sphere of |L|, in the scale of L
void add_binet(const Stage& stage, const Sample& sample, Marks& marks) {
  const Model& model = stage.motion.model();
  const Vec3 w_P = model.R_BP.transpose() * sample.w_B;
  const double energy2 = w_P.dot(model.moments.cwiseProduct(w_P));
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
  const Vec3 normal = sample.L_S.cross(figure);
  if (normal.norm() < 1e-6 * sample.L_S.norm()) return;
  Placement place = Placement::Identity();
  place.translation() = sample.reference_S;
  place.linear() = Quat::FromTwoVectors(Vec3::UnitZ(), normal.normalized()).toRotationMatrix() *
                   (1.45 * stage.scale.body);
  Material material = shell(stage.theme.plane, 0.22f);
  material.flat = true;
  marks.sheets.push_back({{stage.disc, place, material}, sample.reference_S, normal.normalized()});
  marks.meshes.push_back({stage.ring, place, plain(stage.theme.plane, 0.1f)});
  for (int k = 0; k < 16; ++k) {
    const double angle = 2.0 * kPi * k / 16;
    marks.reach.push_back(place * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
}

Paths make_paths(const Stage& stage, const ShowSpec& show, int segments) {
  // a quarter of a pixel where the body is as high as the frame; the pieces of a circle that look
  // round grow as the root of its radius
  const double tolerance = stage.scale.body * (1.0 - std::cos(kPi / segments));
  const int sides = std::max(8, static_cast<int>(std::ceil(segments * std::sqrt(kRimRadius))));
  const auto wanted = [&](const char* name) {
    const auto found = show.asked.find(name);
    return found != show.asked.end() && found->second.value_or(false);
  };
  Paths paths;
  const Motion& motion = stage.motion;
  const Model& model = motion.model();
  const double tube = kRimRadius * stage.scale.body;
  double fastest = 0.0;
  for (const double t : framing_times(motion))
    fastest = std::max(fastest, motion.at(t).w_B.norm());
  // a straight piece is never more than a tenth of a turn
  const int pieces =
      static_cast<int>(std::clamp(fastest * motion.duration() / 0.6, 64.0, 100'000.0));
  const auto trail = [&](const auto& point) {
    return Trail(sampled([&](double t) { return Vec3(point(motion.at(t))); },
                         0.0,
                         motion.duration(),
                         pieces,
                         tolerance),
                 tube,
                 stage.scale.body,
                 sides);
  };
  if (wanted("trail")) {
    const Vec3 tip_B = kTrailRadius * stage.scale.body * figure_axis_B(stage);
    paths.axis = trail([&](const Sample& now) { return Vec3(now.reference_S + now.q_SB * tip_B); });
  }
  for (const Vec3& point_B : show.trail_points) {
    paths.points.push_back(
        trail([&](const Sample& now) { return point_position(model, now, point_B); }));
  }
  if (wanted("herpolhode"))
    paths.herpolhode = trail([&](const Sample& now) { return omega_tip(stage, now); });

  // curves of the body, closed, in units of its radius
  const Vec3 w_P = model.R_BP.transpose() * motion.at(0.0).w_B;
  const int pieces_of_curve = 8 * segments;
  const auto tube_of = [&](const std::vector<Vec3>& points, const Vec3& factor) -> MeshPtr {
    if (points.empty()) return nullptr;
    std::vector<Vec3> drawn;
    drawn.reserve(points.size());
    for (const Vec3& w : points)
      drawn.emplace_back(w.cwiseProduct(factor) / stage.scale.body);
    return std::make_shared<const Mesh>(tube_along(drawn, kRimRadius, sides, true));
  };
  const Vec3 as_omega = Vec3::Constant(stage.scale.omega);
  if (wanted("polhode"))
    paths.polhode = tube_of(polhode(model.moments, w_P, pieces_of_curve), as_omega);
  const Vec3 as_momentum = stage.scale.momentum * model.moments;
  if (wanted("binet"))
    paths.binet = tube_of(polhode(model.moments, w_P, pieces_of_curve), as_momentum);
  if (wanted("polhodes")) {
    // the same energy, other momenta: starts along the great circle through the axes of the
    // smallest and the largest moment, whose polhodes cover both sides of the separatrix
    const double energy2 = w_P.dot(model.moments.cwiseProduct(w_P));
    int least = 0, most = 0;
    model.moments.minCoeff(&least);
    model.moments.maxCoeff(&most);
    for (int k = 0; k < 4 * kFamily; ++k) {
      const double angle = 2.0 * kPi * (k + 0.5) / (4 * kFamily);
      Vec3 w = Vec3::Zero();
      w[least] = std::sqrt(energy2 / model.moments[least]) * std::cos(angle);
      w[most] = std::sqrt(energy2 / model.moments[most]) * std::sin(angle);
      if (const MeshPtr mesh = tube_of(polhode(model.moments, w, pieces_of_curve), as_omega))
        paths.polhodes.push_back(mesh);
    }
  }
  return paths;
}

}  // namespace polhode
