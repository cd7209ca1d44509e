// SPDX-License-Identifier: MIT
#include "motion/scales.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

double least_moment(const BodyModel& model) {
  return (model.moments.array() > 0.0).select(model.moments, model.moments.maxCoeff()).minCoeff();
}

// how fast a load makes a body at rest swing, 1/s; 0 for damping
double driven_rate(const BodyModel& model, const Load& load) {
  const double arm = load.arm_P.norm();
  const double torque = load.vector.norm() * (load.kind == Load::Kind::torque ? 1.0 : arm);
  const double least = least_moment(model);
  if (load.kind == Load::Kind::gradient) {
    const double apart = model.moments.maxCoeff() - model.moments.minCoeff();
    return std::abs(load.rate) * std::sqrt(3.0 * apart / least);
  }
  if (load.kind == Load::Kind::frame) return load.vector.norm();
  return std::sqrt(torque / least) +
         std::sqrt(load.k * (1.0 / model.body.mass + arm * arm / least));
}

// how fast a load damps the rotation, 1/s; 0 for other loads
double damping_rate(const BodyModel& model, const Load& load) {
  return load.kind == Load::Kind::damp_spin ? load.c / least_moment(model) : load.c;
}

// what a load adds to the rates of a motion
double rate_of(const BodyModel& model, const Load& load) {
  return driven_rate(model, load) + std::abs(load.rate) + damping_rate(model, load);
}

}  // namespace

double typical_rate(const BodyModel& model, const State& start) {
  const double least = least_moment(model);
  double rate = angular_velocity(model, start.y).norm() + std::sqrt(model.chi_P.norm() / least);
  for (const Load& load : model.loads.turning)
    rate += rate_of(model, load);
  if (model.loads.gimbals) rate += model.loads.gimbals->friction.maxCoeff() / least;
  if (model.table) return rate + std::sqrt(model.gravity_S.norm() / model.table->surface->reach());
  if (!model.with_translation) return rate;
  // forces through the centre of mass turn nothing, but move it
  const double size = std::sqrt(model.moments.maxCoeff() / model.body.mass);
  for (const Push& push : model.loads.pushes)
    rate += std::abs(push.rate) + std::sqrt(push.force_S.norm() / (model.body.mass * size));
  return rate;
}

double typical_turn(const BodyModel& model, const State& start, double duration) {
  double turn = typical_rate(model, start) * duration;
  for (const Load& load : model.loads.turning) {
    if (load.acts.always()) continue;
    const double begins = std::clamp(load.acts.from, 0.0, duration);
    const double ends = std::clamp(load.acts.until + load.acts.ramp, begins, duration);
    turn -= rate_of(model, load) * (duration - (ends - begins));
  }
  return turn;
}

double turn_left_out(const BodyModel& model, const State& start, double duration, bool steadily) {
  if (model.left_out == 0.0) return 0.0;
  const double rate = typical_rate(model, start);
  const double growth = model.left_out * rate * rate * model.inverse_moments.maxCoeff();
  const double all = 0.5 * growth * duration * duration;
  if (!steadily || !model.kind.symmetric()) return all;
  const int axis = model.kind.axis;
  const double about_axis =
      start.y[axis] * (model.inverse_moments[axis] - model.inverse_moments[(axis + 1) % 3]);
  return std::min(all, growth * duration / std::abs(about_axis));
}

double turn_by_arms_left_out(const BodyModel& model, const State& start, double duration) {
  const double torque = model.torque_left_out;
  if (torque == 0.0) return 0.0;
  const double J = model.inverse_moments.maxCoeff();
  const double from_rest = 0.5 * J * torque * duration * duration;
  const double momentum = start.y.norm();
  const bool is_weight = model.loads.left_out == 0.0 && !model.loads.turn_body();
  if (!is_weight || momentum == 0.0) return from_rest;
  // a weight gives no more energy than it has: L turns by torque t / L, and the spin changes by as
  // little
  constexpr double kOfTurnAndDirection = 4.0;
  const double slender = model.moments.maxCoeff() * J;
  return std::min(from_rest, kOfTurnAndDirection * slender * torque * duration / momentum);
}

double stiffness(const BodyModel& model, const State& start, double duration) {
  double damping = 0.0, all = 0.0;
  for (const Load& load : model.loads.turning) {
    damping = std::max(damping, damping_rate(model, load));
    all += damping_rate(model, load);
  }
  return damping / std::max(typical_rate(model, start) - all, 1.0 / duration);
}

double momentum_scale(const BodyModel& model, const State& start) {
  // what the body has, or what drives it will give it: a start almost at rest is no scale
  const double most = model.moments.maxCoeff();
  double scale = std::max(start.y.norm(), std::sqrt(most * model.chi_P.norm()));
  for (const Load& load : model.loads.turning)
    scale = std::max(scale, most * driven_rate(model, load));
  if (model.table) {
    scale =
        std::max(scale, most * std::sqrt(model.gravity_S.norm() / model.table->surface->reach()));
  }
  return scale > 0.0 ? scale : 1.0;
}

double linear_momentum_scale(const BodyModel& model, double angular_momentum) {
  const double mass = model.body.mass;
  const double size = std::sqrt(model.moments.maxCoeff() / mass);
  double scale = angular_momentum / size;
  for (const Load& load : model.loads.turning) {
    const double force = load.kind == Load::Kind::force ? load.vector.norm() : load.k * size;
    scale = std::max(scale, std::sqrt(force * mass * size));
  }
  for (const Push& push : model.loads.pushes)
    scale = std::max(scale, std::sqrt(push.force_S.norm() * mass * size));
  return scale;
}

double first_step(const BodyModel& model, const State& start, double tolerance, int order) {
  const double rate = typical_rate(model, start);
  return rate > 0.0 ? 0.5 * std::pow(tolerance, 1.0 / order) / rate
                    : std::numeric_limits<double>::infinity();
}

}  // namespace polhode
