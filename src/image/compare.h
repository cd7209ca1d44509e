// SPDX-License-Identifier: MIT
// How far two pictures are apart.
#pragma once

#include "image/image.h"

namespace polhode {

// Differences are per channel value (R, G, B, A), in levels of 0..255.
struct Difference {
  int largest = 0;             // greatest absolute difference
  double mean = 0.0;           // mean absolute difference
  double rms = 0.0;            // root mean square difference
  double fraction_over = 0.0;  // share of pixels with some channel over the threshold
};

// Both pictures must have the same size; throws Error (input) otherwise.
Difference compare(const Image& a, const Image& b, int threshold);

// |a - b| times gain, clipped, opaque; for a person to look at.
Image difference_picture(const Image& a, const Image& b, int gain);

}  // namespace polhode
