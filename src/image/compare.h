// SPDX-License-Identifier: MIT
// How far two pictures are apart, value by value.
//
// Which values: red, green and blue of opaque pictures. Where either picture is translucent
// somewhere, colour premultiplied by alpha, and alpha as a fourth value: what cannot be seen cannot
// differ, and a change of alpha alone is a change.
#pragma once

#include "image/image.h"
#include "image/pixel_box.h"

namespace polhode {

// Differences of values, in levels of 0..255.
struct Difference {
  int largest = 0;             // greatest absolute difference
  double mean = 0.0;           // mean absolute difference
  double rms = 0.0;            // root mean square difference
  double fraction_over = 0.0;  // share of pixels with some value over the threshold
  int values = 3;              // per pixel: 3, or 4 with alpha
};

// Both pictures must have the same size; throws Error (input) otherwise.
Difference compare(const Image& a, const Image& b, int threshold);

// Peak signal-to-noise ratio of a root mean square difference, dB: 20 log10(255 / rms). Infinite
// for equal pictures.
double psnr(double rms);

// The gain of pictures of differences, where nothing else is asked for.
inline constexpr int kDifferenceGain = 16;

// |a - b| times gain, clipped, opaque; for a person to look at. A difference of alpha is white.
Image difference_picture(const Image& a, const Image& b, int gain);

// Where the pictures differ most: the rectangle of this size (cut to the picture's) with the
// greatest sum of differences, to within eight pixels.
PixelBox worst_region(const Image& a, const Image& b, int width, int height);

// That part of a picture, which must hold it.
Image cut_out(const Image& image, const PixelBox& region);

// Has every pixel full alpha?
bool is_opaque(const Image& image);

// The picture on an opaque background of one grey level.
Image laid_on(const Image& image, std::uint8_t grey);

}  // namespace polhode
