// SPDX-License-Identifier: MIT
// Curves: sampled as finely as pixels ask, and drawn as thin tubes.
#pragma once

#include <functional>
#include <vector>

#include "frame/mesh.h"
#include "frame/to_glm.h"

namespace polhode {

// Points of a curve at ascending parameters.
struct Path {
  std::vector<double> parameters;
  std::vector<Vec3> points;
};

// The curve over [from, to], no straight piece further from it than `tolerance` (as seen at the
// middle and the quarters of each piece). pieces: the least number, enough to show every turn.
Path sampled(
    const std::function<Vec3(double)>& curve, double from, double to, int pieces, double tolerance);

// A tube along points; `closed`: the last is joined to the first.
Mesh tube_along(const std::vector<Vec3>& points, double radius, int sides, bool closed);

// The path of a point in time, as meshes that are made once: a film that reveals it draws the
// pieces up to now and one more.
class Trail {
 public:
  Trail() = default;
  // Points and tube radius in m.
  Trail(Path path, double tube_radius, double unit, int sides);

  bool empty() const { return path_.points.size() < 2; }
  // Meshes of the part between two parameters; `place` puts them into space.
  std::vector<MeshPtr> part(double from, double to) const;
  const Placement& place() const { return place_; }
  const Path& path() const { return path_; }

 private:
  Mesh tube(const std::vector<Vec3>& points) const;
  Vec3 at(double parameter) const;

  Path path_;
  double tube_radius_ = 0.0;
  int sides_ = 8;
  Placement place_ = Placement::Identity();
  std::vector<MeshPtr> pieces_;
};

// The curve that angular velocity draws in the body, on the energy ellipsoid, as a closed curve in
// principal axes, rad/s: where y.w = twice the energy and |y|^2 keep their values. Parametrised on
// the axis that it goes round (Landau and Lifshitz, Mechanics, section 37). Empty for a body at
// rest and for spins about a principal axis. moments: kg m^2, all positive; w_P: a point of it.
std::vector<Vec3> polhode(const Vec3& moments, const Vec3& w_P, int pieces);

}  // namespace polhode
