// SPDX-License-Identifier: MIT
// Styles and sizes of the text in a film.
#pragma once

#include <string>

#include "frame/theme.h"
#include "text/typesetter.h"

namespace polhode {

// What fonts are measured in: the height of a 16:9 frame of the area width x height (pixels), so
// that narrow panels keep theirs legible; never more than the height.
double type_size(double width, double height);

// A colour of a theme in bytes.
Rgb bytes_of(const glm::vec3& color);

// Text of that size (pixels) and colour with a rim of the theme's background.
TextStyle style_of(const Theme& theme, double size, const glm::vec3& color);

// The style with which the text fits into width x height (pixels): the given one, else with lines
// broken at that width, else smaller, down to a fifth.
TextStyle fitted(const Typesetter& typesetter,
                 const std::string& markup,
                 TextStyle style,
                 double width,
                 double height);

}  // namespace polhode
