// SPDX-License-Identifier: MIT
// Samples curves adaptively and draws them as thin tubes.
#pragma once

#include <functional>
#include <vector>

#include "frame/mesh.h"
#include "frame/to_glm.h"

namespace polhode {

// Points of a curve at ascending parameters (for a path in time: s); both lists are equally long.
struct Path {
  std::vector<double> parameters;
  std::vector<Vec3> points;
  bool coarse = false;  // it is farther from the curve than asked for, as there are too many points
};

inline constexpr std::size_t kMostPointsOfPath = 200'000;

// Samples the curve over [from, to] so that no straight piece, run through at an even pace, is
// farther from it at any parameter than about `tolerance` (in the unit of the points; tested at the
// middle and the quarters of each piece).
// pieces: into how many equal parts the interval is first divided; they must resolve every turn.
// Each is halved up to twelve times, until there are `most_points`; then points within half the
// tolerance of the piece between those kept are dropped. Throws Error (interrupted).
Path sampled(const std::function<Vec3(double)>& curve,
             double from,
             double to,
             int pieces,
             double tolerance,
             std::size_t most_points = kMostPointsOfPath);

// A tube with flat ends along at least two points (else it aborts); `closed` joins the last to the
// first instead. Radius in the unit of the points; sides: corners of the cross-section.
Mesh tube_along(const std::vector<Vec3>& points, double radius, int sides, bool closed);

// The path of a point in time, as meshes that are made once. To draw part of it, a film draws the
// complete pieces and makes new meshes for the cut ones. Immutable, so any thread may use it.
class Trail {
 public:
  Trail() = default;  // empty
  // Points (S or B) and tube radius in m. unit: metres per unit of the meshes. sides: as for
  // tube_along(). Throws Error (interrupted).
  Trail(Path path, double tube_radius, double unit, int sides);

  bool empty() const { return path_.points.size() < 2; }
  // Whether the path was too long for its tolerance, so that it has corners.
  bool coarse() const { return path_.coarse; }
  // The meshes of the part between two parameters of the path, in mesh coordinates; empty for an
  // empty trail.
  std::vector<MeshPtr> part(double from, double to) const;
  // Maps mesh coordinates to the frame of the points, m.
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

// The polhode: the closed curve of the angular velocity w in principal axes P (rad/s) on which y.w
// (twice the kinetic energy) and |y|^2 are constant, y = I w (Landau and Lifshitz, Mechanics,
// section 37). The result has `pieces` points (rad/s) at equal steps of the angle around the axis
// that the curve encircles; the last is not the first again. moments: kg m^2, all positive; w_P: a
// point of the curve, rad/s. Empty for a body at rest and for a rotation about the axis of the
// least or the greatest moment, where the curve is a point.
std::vector<Vec3> polhode(const Vec3& moments, const Vec3& w_P, int pieces);

// The separatrix: the two ellipses through both ends of the middle axis that part the polhodes of
// one energy (Landau and Lifshitz, Mechanics, section 37). Each has `pieces` points (rad/s); the
// first is an end of the middle axis, and a quarter on is the point of the first ellipse where both
// other components are greatest, of the second where that along the axis of the greatest moment is
// negative. Empty for a body at rest or with two equal moments. moments: kg m^2, all positive;
// w_P: of that energy, rad/s.
std::vector<std::vector<Vec3>> separatrix(const Vec3& moments, const Vec3& w_P, int pieces);

}  // namespace polhode
