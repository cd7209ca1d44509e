// SPDX-License-Identifier: MIT
// Differences of two pictures, value by value.
//
// The values are red, green and blue, sRGB-encoded, if both pictures are opaque. Otherwise they are
// the colour premultiplied by alpha, and alpha itself: invisible colour does not count as a
// difference, and a change of alpha does.
#pragma once

#include "image/image.h"
#include "image/pixel_box.h"

namespace polhode {

// Differences of values, in levels of 0..255.
struct Difference {
  int largest = 0;             // greatest absolute difference
  double mean = 0.0;           // mean absolute difference
  double rms = 0.0;            // root mean square difference
  double fraction_over = 0.0;  // share (0..1) of pixels with a difference over the threshold
  int values = 3;              // per pixel: 3, or 4 with alpha
};

// Compares two pictures. A pixel counts in fraction_over if one of its values differs by more than
// `threshold` levels, 0..255. Throws Error (input), without a place, if the sizes differ.
Difference compare(const Image& a, const Image& b, int threshold);

// Peak signal-to-noise ratio in dB for a root mean square difference in levels: 20 log10(255 /
// rms). Infinite for rms = 0.
double psnr(double rms);

// The default gain of difference_picture().
inline constexpr int kDifferenceGain = 16;

// An opaque picture of |a - b| times `gain` (positive), clipped at 255, for people to look at. A
// difference of alpha alone appears grey to white. Throws Error (input), without a place, if the
// sizes differ.
Image difference_picture(const Image& a, const Image& b, int gain);

// The rectangle of width x height pixels (both positive; cut to the size of the picture) with the
// greatest sum of differences, located to within eight pixels; at the upper left if the pictures
// are equal. Throws Error (input), without a place, if the sizes differ.
PixelBox worst_region(const Image& a, const Image& b, int width, int height);

// A copy of that part of the picture, without `ground`. `region` must lie inside the picture.
Image cut_out(const Image& image, const PixelBox& region);

// Whether every pixel has alpha 255.
bool is_opaque(const Image& image);

// The picture composited over an opaque background of that grey level (0..255), on encoded values,
// without `ground`.
Image laid_on(const Image& image, std::uint8_t grey);

}  // namespace polhode
