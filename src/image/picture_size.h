// SPDX-License-Identifier: MIT
// The size of a picture in pixels, shared by scenes, cameras and films.
#pragma once

namespace polhode {

struct PictureSize {
  int width = 1920;   // pixels
  int height = 1080;  // pixels

  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

}  // namespace polhode
