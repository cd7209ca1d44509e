// SPDX-License-Identifier: MIT
// Converts between the types of mechanics (Eigen, double) and of drawing (GLM, float).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "math/notation.h"

namespace polhode {

// An affine map from mesh coordinates to S or B (m): p_S = linear * p_mesh + translation.
using Placement = Eigen::Affine3d;

// Both overloads round to single precision.
inline glm::vec3 to_glm(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline glm::mat4 to_glm(const Eigen::Matrix4d& m) {
  glm::mat4 out;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row)
      out[column][row] = static_cast<float>(m(row, column));
  }
  return out;
}

inline Vec3 to_eigen(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

}  // namespace polhode
