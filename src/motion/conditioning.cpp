// SPDX-License-Identifier: MIT
#include "motion/conditioning.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "math/so3.h"
#include "motion/deviation.h"
#include "motion/scales.h"

namespace polhode {
namespace {

constexpr int kTimesOfNeighbours = 256;
constexpr double kRounding = 0x1p-53;

// how far a centre of mass may be, for its round-off: as far as it is, or as the body is large, m
double place_scale(const BodyModel& model, const State& start) {
  return std::max(start.place_S.norm(), std::sqrt(model.moments.maxCoeff() / model.body.mass));
}

// momentum: added in P; turn: about the principal axes, rad
State changed(const State& start, const Vec3& momentum, const Vec3& turn) {
  State s = start;
  s.y += momentum;
  s.q = start.q * exp_rotation(turn);
  return s;
}

}  // namespace

Neighbours neighbours_of(const State& start, double size) {
  Neighbours found{{}, size};
  // components that should be zero have the round-off of the others: axes may be turned
  const double momentum = size * start.y.norm();
  for (int i = 0; i < 3; ++i) {
    found.starts.push_back(changed(start, momentum * Vec3::Unit(i), Vec3::Zero()));
    found.starts.push_back(changed(start, Vec3::Zero(), size * Vec3::Unit(i)));
  }
  return found;
}

Neighbours one_neighbour_of(const BodyModel& model, const State& start, double size) {
  const Vec3 momentum = size * momentum_scale(model, start) * Vec3(1, -1, 1);
  const Vec3 turn = size * Vec3(1, 1, -1);
  State near = changed(start, momentum, turn);
  if (model.loads.gimbals) {
    const GimbalPose& rings = start.rings;
    set_rings(
        model, {rings.angles + turn, rings.rates + momentum / model.moments.maxCoeff()}, near);
  }
  if (model.with_translation) near.place_S += size * place_scale(model, start) * Vec3(-1, 1, 1);
  return {{near}, size};
}

Conditioning conditioning_of(
    const BodyModel& model,
    const Trajectory& motion,
    double duration,
    const Neighbours& neighbours,
    double roundings,
    double limit,
    const std::function<std::shared_ptr<const Trajectory>(const State& start)>& solve) {
  // even times may meet a motion always where neighbours are together
  const std::vector<double> times =
      cheap_times(motion, times_to_compare(model, motion, duration, kTimesOfNeighbours));
  const std::vector<State> here = motion.at_each(times);
  std::vector<std::vector<State>> there;
  for (const State& start : neighbours.starts)
    there.push_back(solve(start)->at_each(times));
  const double factor = roundings * kRounding / neighbours.size;
  Conditioning found;
  LargestDeviation largest(model);
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (const std::vector<State>& other : there)
      largest.look_at(here[i], other[i]);
    const double effect = largest.value() * factor;
    found.effect = std::isnan(effect) ? kPi : effect;  // of angles without digits nothing is known
    if (!found.exceeds_limit && !(found.effect <= limit)) {
      found.exceeds_limit = true;
      found.exceeded_at = times[i];
    }
  }
  return found;
}

Conditioning conditioning_of_closed_form(const SolutionMethod& method,
                                         const BodyModel& model,
                                         const State& start,
                                         const Trajectory& motion,
                                         double duration,
                                         double limit) {
  // a turn by the last digit alone would be rounded away
  constexpr double kLastDigits = 0x1p-49;
  const auto solve = [&](const State& from) {
    return std::shared_ptr<const Trajectory>(method.make(model, from));
  };
  return conditioning_of(
      model, motion, duration, neighbours_of(start, kLastDigits), 1.0, limit, solve);
}

}  // namespace polhode
