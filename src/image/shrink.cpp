// SPDX-License-Identifier: MIT
#include "image/shrink.h"

#include <array>

#include "base/check.h"

namespace polhode {

Image shrunk(const Image& image, int factor) {
  CHECK(factor > 0 && image.width % factor == 0 && image.height % factor == 0);
  Image small(image.width / factor, image.height / factor);
  const unsigned area = static_cast<unsigned>(factor) * static_cast<unsigned>(factor);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      std::array<unsigned, 4> sum = {};
      for (int row = 0; row < factor; ++row) {
        const std::uint8_t* pixel = image.at(x * factor, y * factor + row);
        for (int i = 0; i < 4 * factor; ++i)
          sum[static_cast<std::size_t>(i % 4)] += pixel[i];
      }
      for (std::size_t c = 0; c < 4; ++c)
        small.at(x, y)[c] = static_cast<std::uint8_t>((sum[c] + area / 2) / area);
    }
  }
  return small;
}

}  // namespace polhode
