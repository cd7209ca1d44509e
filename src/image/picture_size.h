// SPDX-License-Identifier: MIT
// The size of a picture.
#pragma once

namespace polhode {

struct PictureSize {
  int width = 1920;   // pixels
  int height = 1080;  // pixels

  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

}  // namespace polhode
