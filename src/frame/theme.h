// SPDX-License-Identifier: MIT
// Colours. Vectors keep theirs in every scene, so that a class learns them once.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "frame/draw_list.h"
#include "frame/view_spec.h"

namespace polhode {

// All colours sRGB-encoded, 0..1. The hues are those of Okabe and Ito's palette, which people with
// the common colour-vision deficiencies can tell apart.
struct Theme {
  std::string name;
  glm::vec3 background;
  glm::vec3 body;
  glm::vec3 mark;
  glm::vec3 omega;     // angular velocity
  glm::vec3 momentum;  // angular momentum
  glm::vec3 body_axes;
  glm::vec3 space_axes;
  glm::vec3 space_cone;
  glm::vec3 body_cone;
  glm::vec3 precession_cone;
  glm::vec3 stand;
  glm::vec3 force;     // on points of the body
  glm::vec3 velocity;  // of points of the body
  glm::vec3 position;  // position vectors, points, angles
  glm::vec3 ellipsoid;
  glm::vec3 plane;
  glm::vec3 polhode;
  glm::vec3 herpolhode;
  glm::vec3 trail;
  glm::vec3 floor;
};

const std::vector<Theme>& themes();

// How a body of that material looks; a name from material_names().
Finish finish_named(const std::string& material);

// The theme with the scene's own background, if it gives one. Throws Error (input).
Theme make_theme(const ThemeSpec& spec);

// "#rrggbb" as 0..1. Throws Error (input).
glm::vec3 color_from_hex(const std::string& text);

}  // namespace polhode
