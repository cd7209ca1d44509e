// SPDX-License-Identifier: MIT
#include "motion/conditioning.h"

#include <algorithm>
#include <cmath>

#include "math/so3.h"
#include "motion/scales.h"

namespace polhode {
namespace {

constexpr int kTimesOfNeighbours = 256;
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

State neighbour_of(const BodyModel& model, const State& start, double size) {
  State s = start;
  s.y += size * momentum_scale(model, start) * Vec3(1, -1, 1);
  s.q = start.q * exp_rotation(size * Vec3(1, 1, -1));
  return s;
}

Conditioning conditioning_of(
    const BodyModel& model,
    const Trajectory& motion,
    double duration,
    const Neighbours& neighbours,
    double roundings,
    double limit,
    const std::function<std::shared_ptr<const Trajectory>(const State& start)>& solve) {
  std::vector<std::shared_ptr<const Trajectory>> others;
  others.reserve(neighbours.starts.size());
  for (const State& start : neighbours.starts)
    others.push_back(solve(start));
  const double factor = roundings * kRounding / neighbours.size;
  Conditioning found;
  for (int i = 1; i <= kTimesOfNeighbours; ++i) {
    const double t = duration * i / kTimesOfNeighbours;
    const State here = motion.at(t);
    for (const std::shared_ptr<const Trajectory>& other : others) {
      const double effect = deviation(model, here, other->at(t)) * factor;
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
