// SPDX-License-Identifier: MIT
// Mass, centre of mass and inertia tensor, and how to move and combine them.
#pragma once

#include <vector>

#include "math/notation.h"

namespace polhode {

// All components are in the axes of the caller, for a [body] table in B.
struct MassProperties {
  double mass = 0.0;           // kg
  Vec3 center = Vec3::Zero();  // centre of mass, m
  Mat3 tensor = Mat3::Zero();  // about the centre of mass, kg m^2
};

// m (a^2 1 - a a^T) in kg m^2, the term of the parallel-axis theorem for the offset a in m (lecture
// notes, eq. 12).
Mat3 steiner_tensor(double mass, const Vec3& offset);

// The inertia tensor about the point `about` (m), kg m^2.
Mat3 tensor_about(const MassProperties& body, const Vec3& about);

// The body rotated by R and moved by `shift` (m): a point r goes to R r + shift.
MassProperties moved(const MassProperties& body, const Mat3& R, const Vec3& shift);

// Several bodies with given places, combined to one rigid body. The sum of their masses must be
// positive.
MassProperties composed(const std::vector<MassProperties>& parts);

// A point mass.
struct PointMass {
  double mass;  // kg
  Vec3 at;      // m
};
// The mass properties of point masses, whose sum must be positive (lecture notes, eqs. 6 and 8; see
// docs/theory.md).
MassProperties of_points(const std::vector<PointMass>& points);

}  // namespace polhode
