// SPDX-License-Identifier: MIT
// Mass, centre of mass and inertia tensor, and how they compose.
#pragma once

#include <vector>

#include "math/notation.h"

namespace polhode {

struct MassProperties {
  double mass = 0.0;           // kg
  Vec3 center = Vec3::Zero();  // centre of mass, m
  Mat3 tensor = Mat3::Zero();  // about the centre of mass, kg m^2
};

// Sum of m (a^2 1 - a a^T): what the parallel-axis theorem adds for an offset a (notes eq. 12).
Mat3 steiner_tensor(double mass, const Vec3& offset);

// The tensor about the point `about` instead of the centre of mass.
Mat3 tensor_about(const MassProperties& body, const Vec3& about);

// The body turned by R and moved by `shift`: a point r goes to R r + shift.
MassProperties moved(const MassProperties& body, const Mat3& R, const Vec3& shift);

// Several bodies as one.
MassProperties composed(const std::vector<MassProperties>& parts);

// Point masses (notes eqs. 6 and 8).
struct PointMass {
  double mass;  // kg
  Vec3 at;      // m
};
MassProperties of_points(const std::vector<PointMass>& points);

}  // namespace polhode
