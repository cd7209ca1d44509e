// SPDX-License-Identifier: MIT
#include "motion/conditioning.h"

#include <algorithm>
#include <cmath>

#include "math/so3.h"
#include "motion/scales.h"

namespace polhode {
namespace {

constexpr int kTimes = 256;
constexpr double kRounding = 0x1p-53;

State changed(const State& start, const Vec3& momentum, const Vec3& turn) {
  State s = start;
  s.y = start.y.cwiseProduct(Vec3::Ones() + momentum);
  s.q = start.q * exp_rotation(turn);
  return s;
}

}  // namespace

std::vector<State> neighbours_of(const State& start, double size) {
  std::vector<State> neighbours;
  for (int i = 0; i < 3; ++i) {
    neighbours.push_back(changed(start, size * Vec3::Unit(i), Vec3::Zero()));
    neighbours.push_back(changed(start, Vec3::Zero(), size * Vec3::Unit(i)));
  }
  return neighbours;
}

State neighbour_of(const State& start, double size) {
  return changed(start, size * Vec3(1, -1, 1), size * Vec3(1, 1, -1));
}

Conditioning conditioning_of(
    const BodyModel& model,
    const Trajectory& motion,
    double duration,
    const std::vector<State>& neighbours,
    double size,
    double limit,
    const std::function<std::shared_ptr<const Trajectory>(const State& start)>& solve) {
  std::vector<std::shared_ptr<const Trajectory>> others;
  others.reserve(neighbours.size());
  for (const State& start : neighbours)
    others.push_back(solve(start));
  Conditioning found;
  for (int i = 1; i <= kTimes; ++i) {
    const double t = duration * i / kTimes;
    const State here = motion.at(t);
    for (const std::shared_ptr<const Trajectory>& other : others) {
      const double effect = deviation(model, here, other->at(t)) * kRounding / size;
      if (!(effect <= found.effect)) found.effect = effect;
    }
    if (!found.exceeds_limit && !(found.effect <= limit)) {
      found.exceeds_limit = true;
      found.exceeded_at = t;
    }
  }
  return found;
}

}  // namespace polhode
