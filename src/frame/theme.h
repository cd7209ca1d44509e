// SPDX-License-Identifier: MIT
// Colour themes. A theme gives a quantity the same colour in every scene, so that viewers learn it
// once.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "frame/draw_list.h"
#include "frame/view_spec.h"

namespace polhode {

// All colours are sRGB-encoded, 0..1. The hues are from the palette of Okabe and Ito, which people
// with common colour-vision deficiencies can distinguish. To add a theme: a row in frame/theme.cpp.
struct Theme {
  std::string name;
  glm::vec3 background;
  glm::vec3 body;
  glm::vec3 mark;      // of the strip on the body that makes its spin visible
  glm::vec3 omega;     // angular velocity
  glm::vec3 momentum;  // angular momentum
  glm::vec3 body_axes;
  glm::vec3 space_axes;
  glm::vec3 space_cone;
  glm::vec3 body_cone;
  glm::vec3 precession_cone;
  glm::vec3 stand;
  glm::vec3 force;     // forces on points of the body
  glm::vec3 friction;  // of a table, beside its normal force
  glm::vec3 velocity;  // velocities of points of the body
  glm::vec3 position;  // position vectors, points, angles
  glm::vec3 ellipsoid;
  glm::vec3 plane;
  glm::vec3 polhode;
  glm::vec3 polhodes;  // of other motions
  glm::vec3 herpolhode;
  glm::vec3 trail;  // paths, of the body's axis and of others
  glm::vec3 floor;
  glm::vec3 shadow;  // what a floor is darkened to
};

// All themes; the table exists until the program ends.
const std::vector<Theme>& themes();

// The finish for a name from material_names(); plain for any other name.
Finish finish_named(const std::string& material);

// The theme of that name; it exists until the program ends. Throws Error (input), without a key,
// for an unknown name.
const Theme& find_theme(const std::string& name);

// The theme with the scene's own background, if it gives one. Throws Error (input): naming
// video.theme for an unknown theme, without a key for a background that is not "#rrggbb".
Theme make_theme(const ThemeSpec& spec);

// Whether black stands out from a colour more than white does. sRGB-encoded, 0..1.
bool is_light(const glm::vec3& color);

// A colour for text: `color`, made darker or paler, as far as it must be to stand out from the
// background with a contrast of 4.5 : 1 (WCAG 2.1). All sRGB-encoded, 0..1.
glm::vec3 readable(const glm::vec3& color, const glm::vec3& background);

// "#rrggbb" as components 0..1. Throws Error (input), without a key, for other text.
glm::vec3 color_from_hex(const std::string& text);

}  // namespace polhode
