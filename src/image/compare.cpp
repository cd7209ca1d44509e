// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "base/check.h"
#include "base/error.h"
#include "base/system/wide_registers.h"

namespace polhode {
namespace {

void refuse_sizes(const Image& a, const Image& b) {
  if (a.width == b.width && a.height == b.height) return;
  throw input_error(
      "the pictures have different sizes: {}x{} and {}x{}", a.width, a.height, b.width, b.height);
}

// colour as much as it covers; alpha stays
Image premultiplied(const Image& image) {
  Image out = image;
  for (std::size_t i = 0; i < out.pixels.size(); i += 4) {
    const unsigned alpha = out.pixels[i + 3];
    for (std::size_t c = i; c < i + 3; ++c)
      out.pixels[c] = static_cast<std::uint8_t>((out.pixels[c] * alpha + 127) / 255);
  }
  return out;
}

// What one row adds up to. Rows are at most 2^24 bytes long, so that no sum overflows.
struct RowSums {
  std::uint32_t sum = 0;
  std::uint64_t squares = 0;
  int largest = 0;
};

POLHODE_WIDE_REGISTERS
RowSums add_up(const std::uint8_t* a, const std::uint8_t* b, std::size_t count) {
  // blocks small enough for sums of squares in 32 bits
  constexpr std::size_t kBlock = 4096;
  RowSums sums;
  for (std::size_t start = 0; start < count; start += kBlock) {
    const std::size_t end = std::min(count, start + kBlock);
    std::uint32_t sum = 0, squares = 0;
    std::uint8_t largest = 0;
    for (std::size_t i = start; i < end; ++i) {
      const std::uint8_t apart = a[i] > b[i] ? static_cast<std::uint8_t>(a[i] - b[i])
                                             : static_cast<std::uint8_t>(b[i] - a[i]);
      largest = std::max(largest, apart);
      sum += apart;
      squares += static_cast<std::uint32_t>(apart * apart);
    }
    sums.sum += sum;
    sums.squares += squares;
    sums.largest = std::max(sums.largest, int{largest});
  }
  return sums;
}

POLHODE_WIDE_REGISTERS
std::uint32_t count_over(const std::uint8_t* a,
                         const std::uint8_t* b,
                         std::size_t pixels,
                         int threshold) {
  std::uint32_t over = 0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel, a += 4, b += 4) {
    const int worst = std::max(std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1])),
                               std::max(std::abs(a[2] - b[2]), std::abs(a[3] - b[3])));
    over += worst > threshold ? 1U : 0U;
  }
  return over;
}

Difference compare_values(const Image& a, const Image& b, int threshold, int values) {
  Difference difference;
  difference.values = values;
  std::uint64_t over = 0, sum = 0, squares = 0;
  const auto width = static_cast<std::size_t>(a.width);
  for (int y = 0; y < a.height; ++y) {
    const std::uint8_t* row_a = a.at(0, y);
    const std::uint8_t* row_b = b.at(0, y);
    if (std::memcmp(row_a, row_b, 4 * width) == 0) continue;
    const RowSums row = add_up(row_a, row_b, 4 * width);
    sum += row.sum;
    squares += row.squares;
    difference.largest = std::max(difference.largest, row.largest);
    if (row.largest > threshold) over += count_over(row_a, row_b, width, threshold);
  }
  const double pixels = static_cast<double>(a.pixels.size()) / 4.0;
  if (a.pixels.empty()) return difference;
  difference.mean = static_cast<double>(sum) / (values * pixels);
  difference.rms = std::sqrt(static_cast<double>(squares) / (values * pixels));
  difference.fraction_over = static_cast<double>(over) / pixels;
  return difference;
}

// sums of differences of squares of pixels, and of all that lie above and left of them
class TileSums {
 public:
  static constexpr int kTile = 8;  // pixels

  TileSums(const Image& a, const Image& b)
      : columns_((a.width + kTile - 1) / kTile),
        rows_((a.height + kTile - 1) / kTile),
        sums_(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1)) {
    for (int y = 0; y < a.height; ++y) {
      for (int x = 0; x < a.width; ++x) {
        for (int c = 0; c < 4; ++c)
          at(x / kTile + 1, y / kTile + 1) += std::abs(a.at(x, y)[c] - b.at(x, y)[c]);
      }
    }
    for (int y = 1; y <= rows_; ++y) {
      for (int x = 1; x <= columns_; ++x)
        at(x, y) += at(x - 1, y) + at(x, y - 1) - at(x - 1, y - 1);
    }
  }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::int64_t inside(int x, int y, int width, int height) {
    return at(x + width, y + height) - at(x, y + height) - at(x + width, y) + at(x, y);
  }

 private:
  std::int64_t& at(int x, int y) {
    return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_ + 1) +
                 static_cast<std::size_t>(x)];
  }

  int columns_, rows_;
  std::vector<std::int64_t> sums_;
};

}  // namespace

bool is_opaque(const Image& image) {
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* row = image.at(0, y);
    unsigned all = 255;
    for (int x = 0; x < image.width; ++x)
      all &= row[4 * x + 3];
    if (all != 255) return false;
  }
  return true;
}

Image laid_on(const Image& image, std::uint8_t grey) {
  Image out = premultiplied(image);
  out.ground.reset();
  out.painted.clear();
  for (std::size_t i = 0; i < out.pixels.size(); i += 4) {
    const int under = (grey * (255 - out.pixels[i + 3]) + 127) / 255;
    for (std::size_t c = i; c < i + 3; ++c)
      out.pixels[c] = static_cast<std::uint8_t>(std::min(255, out.pixels[c] + under));
    out.pixels[i + 3] = 255;
  }
  return out;
}

Difference compare(const Image& a, const Image& b, int threshold) {
  refuse_sizes(a, b);
  if (a.pixels == b.pixels) return compare_values(a, a, threshold, is_opaque(a) ? 3 : 4);
  if (is_opaque(a) && is_opaque(b)) return compare_values(a, b, threshold, 3);
  return compare_values(premultiplied(a), premultiplied(b), threshold, 4);
}

double psnr(double rms) {
  return rms > 0.0 ? 20.0 * std::log10(255.0 / rms) : std::numeric_limits<double>::infinity();
}

Image difference_picture(const Image& a, const Image& b, int gain) {
  refuse_sizes(a, b);
  const Image one = premultiplied(a), other = premultiplied(b);
  Image out(a.width, a.height);
  for (std::size_t i = 0; i < out.pixels.size(); i += 4) {
    const int alpha = std::abs(one.pixels[i + 3] - other.pixels[i + 3]);
    for (std::size_t c = i; c < i + 3; ++c) {
      const int value = gain * std::max(alpha, std::abs(one.pixels[c] - other.pixels[c]));
      out.pixels[c] = static_cast<std::uint8_t>(std::min(255, value));
    }
    out.pixels[i + 3] = 255;
  }
  return out;
}

PixelBox worst_region(const Image& a, const Image& b, int width, int height) {
  refuse_sizes(a, b);
  PixelBox best{0, 0, std::min(width, a.width), std::min(height, a.height)};
  TileSums tiles(premultiplied(a), premultiplied(b));
  const int wide = std::clamp(best.width / TileSums::kTile, 1, tiles.columns());
  const int high = std::clamp(best.height / TileSums::kTile, 1, tiles.rows());
  std::int64_t most = 0;
  for (int y = 0; y + high <= tiles.rows(); ++y) {
    for (int x = 0; x + wide <= tiles.columns(); ++x) {
      const std::int64_t sum = tiles.inside(x, y, wide, high);
      if (sum <= most) continue;
      most = sum;
      best.x = std::min(x * TileSums::kTile, a.width - best.width);
      best.y = std::min(y * TileSums::kTile, a.height - best.height);
    }
  }
  return best;
}

Image cut_out(const Image& image, const PixelBox& region) {
  CHECK(region.x >= 0 && region.y >= 0 && region.x + region.width <= image.width &&
        region.y + region.height <= image.height);
  Image out(region.width, region.height);
  for (int y = 0; y < region.height; ++y)
    std::copy_n(image.at(region.x, region.y + y), 4 * region.width, out.at(0, y));
  return out;
}

}  // namespace polhode
