// SPDX-License-Identifier: MIT
// Downsamples a picture by a whole factor.
#pragma once

#include "image/image.h"

namespace polhode {

// Each pixel is the mean of factor x factor pixels, taken over the stored (sRGB) values, as OpenGL
// drivers resolve samples. `factor`, at least 1, must divide width and height.
Image shrunk(const Image& image, int factor);

}  // namespace polhode
