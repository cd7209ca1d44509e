// SPDX-License-Identifier: MIT
#include "image/image.h"

#include <cstring>

namespace polhode {

void Image::wipe(int w,
                 int h,
                 const std::array<std::uint8_t, 4>& color,
                 const std::vector<PixelBox>& kept) {
  const bool same = width == w && height == h && ground == color;
  if (width != w || height != h) *this = Image(w, h);
  if (same) {
    for (const PixelBox& box : painted) {
      for (const PixelBox& part : without(box, kept))
        fill(part, color);
    }
  } else {
    fill({0, 0, w, h}, color);
  }
  ground = color;
  painted.clear();
}

void Image::fill(const PixelBox& box, const std::array<std::uint8_t, 4>& color) {
  if (box.empty()) return;
  std::uint8_t* first = at(box.x, box.y);
  for (int x = 0; x < box.width; ++x)
    std::memcpy(first + std::ptrdiff_t{4} * x, color.data(), 4);
  for (int row = 1; row < box.height; ++row)
    std::memcpy(at(box.x, box.y + row), first, 4 * static_cast<std::size_t>(box.width));
}

}  // namespace polhode
