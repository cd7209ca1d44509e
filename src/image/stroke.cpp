// SPDX-License-Identifier: MIT
#include "image/stroke.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

LinePoint between(const LinePoint& a, const LinePoint& b, double part) {
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

// how much of each pixel lines cover, 0..1
class Coverage {
 public:
  Coverage(int width, int height)
      : width_(width),
        height_(height),
        parts_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  // raises it where a segment covers more
  void add(const LinePoint& a, const LinePoint& b, double radius) {
    const double reach = radius + 1.0;
    const int left = std::max(0, static_cast<int>(std::floor(std::min(a.x, b.x) - reach)));
    const int right = std::min(width_, static_cast<int>(std::ceil(std::max(a.x, b.x) + reach)) + 1);
    const int top = std::max(0, static_cast<int>(std::floor(std::min(a.y, b.y) - reach)));
    const int bottom =
        std::min(height_, static_cast<int>(std::ceil(std::max(a.y, b.y) + reach)) + 1);
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const double px = x + 0.5 - a.x;
        const double py = y + 0.5 - a.y;
        const double along =
            square > 0.0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0.0;
        const double ox = px - along * dx;
        const double oy = py - along * dy;
        const double covered = radius + 0.5 - std::sqrt(ox * ox + oy * oy);
        if (covered <= 0.0) continue;
        float& part = at(x, y);
        part = std::max(part, static_cast<float>(std::min(covered, 1.0)));
      }
    }
  }

  float& at(int x, int y) {
    return parts_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(x)];
  }

 private:
  int width_, height_;
  std::vector<float> parts_;
};

}  // namespace

std::vector<Polyline> dashes_of(const Polyline& line, const std::vector<double>& pattern) {
  if (pattern.empty() || line.size() < 2) return {line};
  std::vector<Polyline> dashes;
  std::size_t part = 0;
  double left = pattern[0];  // of this part of the pattern
  bool drawn = true;
  dashes.push_back({line[0]});
  for (std::size_t i = 1; i < line.size(); ++i) {
    const LinePoint& a = line[i - 1];
    const LinePoint& b = line[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    double done = 0.0;
    while (length - done > left) {
      done += left;
      const LinePoint turn = between(a, b, done / length);
      if (drawn) {
        dashes.back().push_back(turn);
      } else {
        dashes.push_back({turn});
      }
      drawn = !drawn;
      part = (part + 1) % pattern.size();
      left = pattern[part];
    }
    left -= length - done;
    if (drawn) dashes.back().push_back(b);
  }
  return dashes;
}

void stroke(Sprite& sprite,
            const std::vector<Polyline>& lines,
            double width,
            const std::array<std::uint8_t, 3>& rgb) {
  Coverage coverage(sprite.width, sprite.height);
  for (const Polyline& line : lines) {
    if (line.size() == 1) coverage.add(line[0], line[0], 0.5 * width);
    for (std::size_t i = 1; i < line.size(); ++i)
      coverage.add(line[i - 1], line[i], 0.5 * width);
  }
  std::uint8_t* pixel = sprite.pixels.data();
  for (int y = 0; y < sprite.height; ++y) {
    for (int x = 0; x < sprite.width; ++x, pixel += 4) {
      const double part = coverage.at(x, y);
      if (part <= 0.0) continue;
      for (int c = 0; c < 4; ++c) {
        const double over = c < 3 ? rgb[static_cast<std::size_t>(c)] : 255.0;
        pixel[c] = static_cast<std::uint8_t>(std::lround(part * over + (1.0 - part) * pixel[c]));
      }
    }
  }
}

}  // namespace polhode
