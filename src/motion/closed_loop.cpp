// SPDX-License-Identifier: MIT
#include "motion/closed_loop.h"

#include <algorithm>
#include <cmath>

#include "base/system/interrupt.h"
#include "math/so3.h"
#include "motion/scales.h"

namespace polhode {
namespace {

constexpr double kStep = 0.1;      // rad of the fastest turning between looks
constexpr int kLooksAhead = 1009;  // for the fastest; a prime, so that no period divides it
constexpr double kLeastLooks = 100.0, kMostLooks = 2e6;
constexpr int kHalvings = 60;

// what Loop::residual is measured by
struct Scales {
  double angle = 0.0;  // rad
  double rate = 0.0;   // rad/s
};

double off(const Motion& motion, const Sample& start, const Scales& scales, double t) {
  const Sample now = motion.at(t);
  const double turned = rotation_angle_between(now.q_SB, start.q_SB);
  return std::hypot(turned / scales.angle, (now.w_B - start.w_B).norm() / scales.rate);
}

}  // namespace

Loop find_loop(const Motion& motion, double longest, double allowed) {
  const Sample start = motion.at(0.0);
  double fastest = 0.0, farthest = 0.0;
  for (int i = 0; i <= kLooksAhead; ++i) {
    const Sample now = motion.at(longest * i / kLooksAhead);
    fastest = std::max(fastest, now.w_B.norm());
    farthest = std::max(farthest, rotation_angle_between(now.q_SB, start.q_SB));
  }
  if (fastest == 0.0 || farthest == 0.0) return {longest, 0.0};
  const Scales scales{std::min(farthest, 1.0), std::max(start.w_B.norm(), 0.5 * fastest)};
  // small swings come back long before they have turned by a radian
  const double rate = std::max(fastest, typical_rate(motion.model(), motion.state_at(0.0)));
  const double step = std::clamp(kStep / rate, longest / kMostLooks, longest / kLeastLooks);

  // valleys of the distance from the start, each followed to its bottom; up to the first hill the
  // motion only departs
  Loop best{longest, off(motion, start, scales, longest)};
  bool departed = false;
  double before = 0.0, last = off(motion, start, scales, step);
  for (double t = 2.0 * step; t <= longest + step; t += step) {
    stop_if_interrupted();
    const double now = off(motion, start, scales, std::min(t, longest));
    if (departed && last <= before && last <= now) {
      double low = t - 2.0 * step, high = std::min(t, longest);
      for (int i = 0; i < kHalvings; ++i) {
        const double a = low + (high - low) / 3.0;
        const double b = high - (high - low) / 3.0;
        if (off(motion, start, scales, a) < off(motion, start, scales, b)) {
          high = b;
        } else {
          low = a;
        }
      }
      const double bottom = 0.5 * (low + high);
      const double residual = off(motion, start, scales, bottom);
      if (residual <= allowed) return {bottom, residual};
      if (residual < best.residual) best = {bottom, residual};
    }
    departed = departed || now < last;
    before = last;
    last = now;
  }
  return best;
}

}  // namespace polhode
