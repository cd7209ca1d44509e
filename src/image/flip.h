// SPDX-License-Identifier: MIT
// How different two pictures look when one is flipped to the other.
#pragma once

#include <vector>

#include "image/image.h"

namespace polhode {

// Pixels in a degree of the observer's sight: a screen 0.7 m wide with 3840 pixels, seen from 0.7
// m. The published default.
inline constexpr double kPixelsPerDegree = 67.02064327658226;

// The error of each pixel, 0 (none) to 1 (green against blue), row by row, and their mean.
struct FlipMap {
  int width = 0;   // pixels
  int height = 0;  // pixels
  std::vector<float> errors;
  double mean = 0.0;
};

// LDR-FLIP of Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem and Fairchild, FLIP: a
// difference evaluator for alternating images, Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020,
// with its constants: colour filtered by contrast sensitivity, compared as HyAB distance of
// Hunt-adjusted L*a*b*, raised by differences of edges and points.
// Translucent pictures are laid on black and on white; the map with the greater mean counts.
// `jobs` threads, 0: one per processor; the values do not depend on their number. Throws Error
// (input) for pictures of different sizes.
FlipMap flip(const Image& reference,
             const Image& test,
             double pixels_per_degree = kPixelsPerDegree,
             int jobs = 0);

// The map in the colours of magma, from black (0) to pale yellow (1), as its authors show it.
Image heat_picture(const FlipMap& map);

}  // namespace polhode
