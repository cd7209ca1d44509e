// SPDX-License-Identifier: MIT
// A smaller picture, each pixel the mean of a square of pixels.
#pragma once

#include "image/image.h"

namespace polhode {

// `factor` must divide both sides. Means of the stored values, as a driver resolves samples.
Image shrunk(const Image& image, int factor);

}  // namespace polhode
