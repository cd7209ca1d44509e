// SPDX-License-Identifier: MIT
// Lines that show how parts add up to a vector.
#include <algorithm>

#include "frame/elements/parts.h"

namespace polhode {
namespace {

// in units of the body's radius
constexpr double kLineRadius = 0.007;
constexpr double kDash = 0.06;      // as long as the gap that follows
constexpr double kShortest = 0.03;  // shorter lines say nothing

void add_dashed(const Scenery& scenery, const Vec3& from, const Vec3& to, Glyphs& glyphs) {
  const double length = (to - from).norm();
  const double dash = kDash * scenery.scale.body;
  if (length < kShortest * scenery.scale.body) return;
  Material material = drawn_through(scenery, plain(scenery.theme.omega, 0.1f));
  material.dashes = 0.0f;  // as it is
  const Vec3 along = (to - from) / length;
  for (int i = 0; 2 * i * dash < length; ++i) {
    glyphs.rods.push_back({from + 2 * i * dash * along,
                           from + std::min((2 * i + 1) * dash, length) * along,
                           kLineRadius * scenery.scale.body,
                           material});
  }
  glyphs.lines.push_back({from, to});
}

}  // namespace

// Two parts make a parallelogram, and the third leads from its corner to the tip of the sum: of
// Euler's rates those about the vertical and the body's axis, of components the first two.
void add_sum(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  Glyphs parts;
  const bool of_angles = asks_for(scenery, "euler_rates");
  (of_angles ? add_euler_rates : add_omega_components)(scenery, sample, parts);
  if (parts.arrows.size() != 3) return;
  const auto part = [&](std::size_t i) {
    return Vec3(parts.arrows[i].tip - parts.arrows[i].from);
  };
  const Vec3& from = sample.reference_S;
  const Vec3 one = part(0), other = part(of_angles ? 2 : 1), last = part(of_angles ? 1 : 2);
  const Vec3 corner = from + one + other;
  add_dashed(scenery, from + one, corner, glyphs);
  add_dashed(scenery, from + other, corner, glyphs);
  add_dashed(scenery, corner, corner + last, glyphs);
}

}  // namespace polhode
