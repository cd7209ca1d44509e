// SPDX-License-Identifier: MIT
#include "motion/closed_loop.h"

#include <algorithm>
#include <cmath>

#include "base/system/interrupt.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr double kStep = 0.1;  // rad of the fastest turning between looks
constexpr double kMostLooks = 2e6;
constexpr int kHalvings = 60;

double off(const Motion& motion, const Sample& start, double scale, double t) {
  const Sample now = motion.at(t);
  const double turned = rotation_angle_between(now.q_SB, start.q_SB);
  return std::hypot(turned, (now.w_B - start.w_B).norm() / scale);
}

}  // namespace

Loop find_loop(const Motion& motion, double longest, double allowed) {
  const Sample start = motion.at(0.0);
  double fastest = 0.0;
  for (int i = 0; i <= 100; ++i)
    fastest = std::max(fastest, motion.at(longest * i / 100.0).w_B.norm());
  if (fastest == 0.0) return {longest, 0.0};
  const double scale = std::max(start.w_B.norm(), 1e-3 * fastest);
  const double step = std::max(kStep / fastest, longest / kMostLooks);

  // valleys of the distance from the start, each followed to its bottom; up to the first hill the
  // motion only departs
  Loop best{longest, off(motion, start, scale, longest)};
  bool departed = false;
  double before = 0.0, last = off(motion, start, scale, step);
  for (double t = 2.0 * step; t <= longest + step; t += step) {
    stop_if_interrupted();
    const double now = off(motion, start, scale, std::min(t, longest));
    if (departed && last <= before && last <= now) {
      double low = t - 2.0 * step, high = std::min(t, longest);
      for (int i = 0; i < kHalvings; ++i) {
        const double a = low + (high - low) / 3.0;
        const double b = high - (high - low) / 3.0;
        if (off(motion, start, scale, a) < off(motion, start, scale, b)) {
          high = b;
        } else {
          low = a;
        }
      }
      const double bottom = 0.5 * (low + high);
      const double residual = off(motion, start, scale, bottom);
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
