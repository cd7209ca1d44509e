// SPDX-License-Identifier: MIT
// The image metric SSIM: structural similarity of two pictures.
#pragma once

#include "image/image.h"

namespace polhode {

// Mean SSIM index of luma, 1 for equal pictures. Wang, Bovik, Sheikh, Simoncelli, Image quality
// assessment: from error visibility to structural similarity, IEEE Trans. Image Process. 13(4),
// 2004: eq. 13 in windows of 11x11 weighted by a Gaussian of 1.5 pixels, K1 = 0.01, K2 = 0.03, L =
// 255, averaged (eq. 17) over all windows that lie in the picture. Luma is 0.2126 R + 0.7152 G +
// 0.0722 B of encoded values (BT.709), not rounded. Sides shorter than 11 pixels are extended by
// repeating the last pixel. Translucent pictures are compared over black and over white, and the
// lower value is returned. `jobs` is the number of threads, 0 for one per processor; the value does
// not depend on it. Throws Error (input), without a place, if the sizes differ.
double ssim(const Image& a, const Image& b, int jobs = 0);

}  // namespace polhode
