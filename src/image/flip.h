// SPDX-License-Identifier: MIT
// The image metric FLIP: how different two pictures look to an observer who switches between them.
#pragma once

#include <vector>

#include "image/image.h"

namespace polhode {

// Pixels per degree of visual angle for a screen 0.7 m wide with 3840 pixels, seen from 0.7 m: the
// default of the paper.
inline constexpr double kPixelsPerDegree = 67.02064327658226;

// The errors of all pixels, 0 (none) to 1 (green against blue).
struct FlipMap {
  int width = 0;              // pixels
  int height = 0;             // pixels
  std::vector<float> errors;  // width x height, row by row from the top
  double mean = 0.0;          // of the errors
};

// LDR-FLIP of Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem and Fairchild, FLIP: a
// difference evaluator for alternating images, Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020,
// with the paper's constants: colours are filtered by contrast sensitivity and compared by the HyAB
// distance in Hunt-adjusted L*a*b*; differences of edges and points increase the error. Translucent
// pictures are compared over black and over white, and the map with the greater mean is returned.
// pixels_per_degree: positive. `jobs` is the number of threads, 0 for one per processor; the values
// do not depend on it. Throws Error (input), without a place, if the sizes differ, (interrupted).
FlipMap flip(const Image& reference,
             const Image& test,
             double pixels_per_degree = kPixelsPerDegree,
             int jobs = 0);

// The map in the magma colours used in the paper, from black (0) to pale yellow (1); opaque.
Image heat_picture(const FlipMap& map);

}  // namespace polhode
