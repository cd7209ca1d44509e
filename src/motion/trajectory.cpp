// SPDX-License-Identifier: MIT
#include "motion/trajectory.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

// what is conserved: all of L for a free body, its vertical part when gravity acts on a pivot
Vec3 conserved_momentum(const Model& model, const State& s) {
  Vec3 L_S = momentum_in_space(s);
  if (model.chi_P.squaredNorm() == 0.0) return L_S;
  return model.up_S.dot(L_S) * model.up_S;
}

double or_one(double scale) {
  return scale > 0.0 ? scale : 1.0;
}

}  // namespace

DriftWatch::DriftWatch(const Model& model, const State& start)
    : model_(model),
      energy_(rotation_energy(model, start)),
      momentum_(conserved_momentum(model, start)),
      energy_scale_(
          or_one(0.5 * start.y.dot(angular_velocity(model, start.y)) + model.chi_P.norm())),
      momentum_scale_(or_one(
          std::max(start.y.norm(), std::sqrt(model.moments.maxCoeff() * model.chi_P.norm())))) {}

void DriftWatch::look_at(const State& s) {
  const double energy = std::abs(rotation_energy(model_, s) - energy_) / energy_scale_;
  const double momentum = (conserved_momentum(model_, s) - momentum_).norm() / momentum_scale_;
  // a NaN, once seen, is kept: nothing is greater than it
  if (energy > worst_.energy || std::isnan(energy)) worst_.energy = energy;
  if (momentum > worst_.momentum || std::isnan(momentum)) worst_.momentum = momentum;
}

}  // namespace polhode
