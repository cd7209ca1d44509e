// SPDX-License-Identifier: MIT
// The surface with which a body touches a table: for each direction of "down" its lowest point, how
// far that is below the centre of mass, and how it moves over the surface as the body turns.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/body_spec.h"
#include "model/mass_properties.h"

namespace polhode {

// The direction of down in the axes of a body that q_SP turns into those of space.
inline Vec3 down_in_body(const Quat& q_SP) {
  return -(q_SP.conjugate() * Vec3::UnitZ());
}

// A convex curve in the plane through the axis of a solid of revolution, as its support function h
// of the angle of a direction above the plane across the axis: how far the curve reaches that way.
// Between nodes h is the polynomial of degree 5 that has its value and two derivatives there
// (Hermite), so that contact rolls over the curve with a continuous radius of curvature h + h''.
// Beyond its ends the curve has corners. Immutable.
class SmoothOutline {
 public:
  // A place of the curve: distance from the axis and along it, and the radius of curvature, m.
  struct Point {
    double r = 0.0, z = 0.0, curvature = 0.0;
  };
  // points: (radius, z) of a convex curve, m, anticlockwise from low to high, at least three; where
  // the first or the last is on the axis, the curve meets it at a right angle. Directions, and
  // radii of curvature, are those of circles through three neighbours. Throws Error (input),
  // without a key, if so many are not convex.
  explicit SmoothOutline(const std::vector<Vec2>& points);
  // Where it touches a line across the direction with this angle (rad, -pi/2..pi/2).
  Point at(double angle) const;
  double support(double angle) const;
  double reach() const { return reach_; }  // the greatest distance from the origin, m

 private:
  struct Node {
    double angle = 0.0;                       // rad, -pi/2..pi/2
    double h = 0.0, slope = 0.0, bend = 0.0;  // h, h' and h'', m
  };
  std::vector<Node> nodes_;
  double reach_ = 0.0;
};

// The sum, in the sense of Minkowski, of an ellipsoid, a circle about its own z axis and a ball: a
// sphere is a ball, the edge of a disc a circle, a torus a circle and a ball, a tip none of them.
// Or the surface of revolution of a smooth outline alone.
struct SurfacePiece {
  std::string name;                                   // of the solid, for messages
  Vec3 center_P = Vec3::Zero();                       // from the centre of mass, m
  Mat3 R_PD = Mat3::Identity();                       // its own axes as columns, in P
  Vec3 semi_axes = Vec3::Zero();                      // of the ellipsoid, m
  double ring = 0.0;                                  // radius of the circle, m
  double ball = 0.0;                                  // radius of the ball, m
  std::shared_ptr<const SmoothOutline> outline = {};  // about its z axis; null: none
  int solid = 0;                                      // pieces of one solid have the same number
};

// Where a body touches. Vectors in P.
struct SurfacePoint {
  Vec3 arm_P = Vec3::Zero();  // from the centre of mass to the lowest point, m
  double height = 0.0;        // of the centre of mass above it, m
  // How the lowest point moves over the body while "down" turns, m/s: the radii of curvature times
  // that rate, 0 along a tip and across an edge.
  Vec3 arm_rate_P = Vec3::Zero();
};

// Immutable.
class ContactSurface {
 public:
  // At least one piece.
  explicit ContactSurface(std::vector<SurfacePiece> pieces);

  // The number of the piece that is lowest; down_P: unit vector.
  int lowest(const Vec3& down_P) const;
  // The lowest point of that piece, while down_P turns at down_rate_P (1/s). On a circle that lies
  // flat any of its points.
  SurfacePoint at(const Vec3& down_P, const Vec3& down_rate_P, int piece) const;
  // The height of the centre of mass above a table under that piece, m: -down . arm.
  double height(const Vec3& down_P, int piece) const;
  // How far every other piece is above the lowest point of this one, m; negative: below. Infinite
  // if there is no other.
  double clearance(const Vec3& down_P, int piece) const;
  // The sine of the angle between the plane of the circle and the table; 1 for pieces without one.
  double tilt_of_face(const Vec3& down_P, int piece) const;
  // The greatest distance of its points from the centre of mass, at most, m.
  double reach() const { return reach_; }
  const std::vector<SurfacePiece>& pieces() const { return pieces_; }

  // The radius of the sphere that it is, and its centre from the centre of mass (P, m); null if it
  // is something else.
  const SurfacePiece* as_sphere() const;

 private:
  double support(const Vec3& down_P, const SurfacePiece& piece) const;

  std::vector<SurfacePiece> pieces_;
  double reach_ = 0.0;
};

// The surface of a [body] table: of its look, if there is one, else of its solid or parts; with
// parts, of all of them. `body` gives the centre of mass; R_BP: principal axes as columns, in B.
// Throws Error (input) naming the key of a solid with flat facets (box, mesh), and `motion.hold` if
// the table only gives moments, a tensor or points.
std::shared_ptr<const ContactSurface> make_contact_surface(const BodySpec& spec,
                                                           const MassProperties& body,
                                                           const Mat3& R_BP);

}  // namespace polhode
