// SPDX-License-Identifier: MIT
#include "frame/chevron.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "image/stroke.h"

namespace polhode {
namespace {

constexpr double kLine = 0.32;  // of its size

}  // namespace

TextRoom Chevron::room() const {
  const Vec2 a = left_end(), b = right_end();
  const TextRoom corners{std::min({tip.x(), a.x(), b.x()}),
                         std::min({tip.y(), a.y(), b.y()}),
                         std::max({tip.x(), a.x(), b.x()}),
                         std::max({tip.y(), a.y(), b.y()})};
  return grown(corners, 0.5 * kLine * size, 0.5 * kLine * size);
}

Chevron chevron_in(const TextRoom& frame, const Vec2& way, double size) {
  // the ends are never farther out than the tip and the size
  const double inset = (1.0 + 0.5 * kLine) * size;
  const Vec2 middle = frame.center();
  const auto reach = [](double half, double along) {
    return along == 0.0 ? std::numeric_limits<double>::infinity() : half / std::abs(along);
  };
  const double far = std::min(reach(0.5 * frame.width() - inset, way.x()),
                              reach(0.5 * frame.height() - inset, way.y()));
  return {middle + far * way, way, size};
}

Stamp stamp_of(const Chevron& chevron, const TextStyle& style) {
  const TextRoom room = grown(chevron.room(), style.halo + 1.0, style.halo + 1.0);
  const int left = static_cast<int>(std::floor(room.left));
  const int top = static_cast<int>(std::floor(room.top));
  Sprite sprite(static_cast<int>(std::ceil(room.right)) - left,
                static_cast<int>(std::ceil(room.bottom)) - top);
  Polyline line;
  for (const Vec2& point : {chevron.left_end(), chevron.tip, chevron.right_end()})
    line.push_back({point.x() - left, point.y() - top});
  const double width = kLine * chevron.size;
  stroke(sprite, {line}, width + 2.0 * style.halo, style.halo_color);
  stroke(sprite, {line}, width, style.color);
  return {std::make_shared<const Sprite>(std::move(sprite)), left, top};
}

}  // namespace polhode
