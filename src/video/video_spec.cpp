// SPDX-License-Identifier: MIT
#include "video/video_spec.h"

#include <cmath>
#include <numeric>
#include <optional>

#include "base/error.h"
#include "base/numbers.h"

namespace polhode {
namespace {

// what a decimal rate most likely means: one of television's over 1001, else what it says
std::string exact_rate(double decimal) {
  const double over = std::round(decimal * 1.001);
  if (std::abs(decimal - over / 1.001) < 0.005) return fmt::format("{:.0f}/1001", over * 1000);
  const double thousandths = std::round(decimal * 1000);
  const double common = std::gcd(static_cast<int>(thousandths), 1000);
  return fmt::format("{:.0f}/{:.0f}", thousandths / common, 1000 / common);
}

}  // namespace

FrameRate parse_frame_rate(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::optional<double> decimal = parse_number(text);
  std::optional<int> above = parse_integer(text.substr(0, slash));
  if (decimal && *decimal == std::round(*decimal) && std::abs(*decimal) <= kMostFramesPerSecond)
    above = static_cast<int>(*decimal);  // 60.0, 1e2
  const std::optional<int> below =
      slash == std::string::npos ? std::optional(1) : parse_integer(text.substr(slash + 1));
  if (!above || !below) {
    if (decimal && *decimal >= 1.0 && *decimal < kMostFramesPerSecond) {
      throw input_error(
          "frame rates are exact: write \"{}\" instead of {}", exact_rate(*decimal), text);
    }
    if (decimal) {
      throw input_error("must be 1 to {} frames per second, got {}", kMostFramesPerSecond, text);
    }
    throw input_error("'{}' is not a frame rate; write 60 or \"30000/1001\"", text.substr(0, 40));
  }
  if (*above <= 0 || *below <= 0 || *above < *below ||
      static_cast<double>(*above) / *below > kMostFramesPerSecond) {
    throw input_error("must be 1 to {} frames per second, got {}", kMostFramesPerSecond, text);
  }
  const int common = std::gcd(*above, *below);
  return {*above / common, *below / common};
}

void check_picture_size(const PictureSize& size) {
  for (const int side : {size.width, size.height}) {
    if (side >= kSmallestSide && side <= kLargestSide) continue;
    throw input_error("sides must be {} to {} pixels, got {}x{}",
                      kSmallestSide,
                      kLargestSide,
                      size.width,
                      size.height);
  }
  if (static_cast<double>(size.width) * size.height > kMostPixels) {
    throw input_error("a picture has at most {} pixels, such as 8192x8192; got {}x{}",
                      kMostPixels,
                      size.width,
                      size.height);
  }
}

PictureSize parse_picture_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  const std::optional<int> width = parse_integer(text.substr(0, cross));
  const std::optional<int> height =
      cross == std::string::npos ? std::nullopt : parse_integer(text.substr(cross + 1));
  if (!width || !height) {
    throw input_error("'{}' is not a picture size; write \"1920x1080\"", text.substr(0, 40));
  }
  const PictureSize size{*width, *height};
  check_picture_size(size);
  return size;
}

const std::vector<std::string>& encoder_presets() {
  static const std::vector<std::string> names = {"ultrafast",
                                                 "superfast",
                                                 "veryfast",
                                                 "faster",
                                                 "fast",
                                                 "medium",
                                                 "slow",
                                                 "slower",
                                                 "veryslow"};
  return names;
}

}  // namespace polhode
