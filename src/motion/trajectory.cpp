// SPDX-License-Identifier: MIT
#include "motion/trajectory.h"

#include <algorithm>
#include <cmath>

#include "base/system/wide_registers.h"
#include "motion/steppers/derivative.h"

namespace polhode {
namespace {

// what is conserved: all of L for a free body, its vertical part when gravity acts on a pivot
Vec3 conserved_momentum(const BodyModel& model, const State& s) {
  Vec3 L_S = momentum_in_space(s);
  if (model.chi_P.squaredNorm() == 0.0) return L_S;
  return model.up_S.dot(L_S) * model.up_S;
}

// energy of the centre of mass at the start, J, where the states carry it
double energy_of_place(const BodyModel& model, const State& s) {
  if (!model.with_translation) return 0.0;
  return 0.5 * s.linear_momentum_S.squaredNorm() / model.body.mass +
         std::abs(potential_of_place(model, s.place_S));
}

std::array<double, 7> numbers_of(const State& s) {
  return {s.q.x(), s.q.y(), s.q.z(), s.q.w(), s.y.x(), s.y.y(), s.y.z()};
}

// a NaN, once seen, is kept: nothing is greater than it
void keep_larger(std::optional<double>& worst, const std::optional<double>& drift) {
  if (!worst || !drift) return;
  if (std::abs(*drift) > *worst || std::isnan(*drift)) worst = std::abs(*drift);
}

// the invariants of eight states, each column one
using OfEight = std::array<double, 8>;
POLHODE_WIDE_REGISTERS void find_invariants(const HeavyBody<double>& body,
                                            const std::array<OfEight, 7>& v,
                                            OfEight& energies,
                                            OfEight& momenta) {
  for (std::size_t k = 0; k < energies.size(); ++k) {
    const std::array<double, 7> of_one = {
        v[0][k], v[1][k], v[2][k], v[3][k], v[4][k], v[5][k], v[6][k]};
    const HeavyInvariants<double> found = heavy_invariants(body, of_one.data());
    energies[k] = found.energy;
    momenta[k] = found.momentum;
  }
}

double or_one(double scale) {
  return scale > 0.0 ? scale : 1.0;
}

}  // namespace

std::vector<double> busy_times_of(const std::vector<double>& grid,
                                  const std::vector<double>& speeds,
                                  std::size_t count) {
  // a body at rest may be stepped as often as one that turns, where steps must be short
  const auto turn = [&](std::size_t i) {
    return speeds[i] * (grid[i + 1] - grid[i]);
  };
  double all = 0.0;
  for (std::size_t i = 0; i + 1 < grid.size(); ++i)
    all += turn(i);
  const double steps = static_cast<double>(grid.size()) - 1.0;
  std::vector<double> times;
  double done = 0.0;
  for (std::size_t i = 0; i + 1 < grid.size(); ++i) {
    done += 0.5 / steps + (all > 0.0 ? 0.5 * turn(i) / all : 0.0);
    if (done * static_cast<double>(count) < static_cast<double>(times.size()) + 1.0) continue;
    times.push_back(grid[i + 1]);
  }
  return times;
}

std::vector<State> Trajectory::at_each(const std::vector<double>& times) const {
  std::vector<State> states;
  states.reserve(times.size());
  for (const double t : times)
    states.push_back(at(t));
  return states;
}

DriftWatch::DriftWatch(const BodyModel& model, const State& start)
    : model_(model),
      energy_(energy(model, start)),
      momentum_(conserved_momentum(model, start)),
      energy_scale_(or_one(0.5 * start.y.dot(angular_velocity(model, start.y)) +
                           model.chi_P.norm() + energy_of_place(model, start) +
                           kinetic_energy_of_gimbals(model, start) +
                           potential_scale(model.loads.turning, start.q, start.place_S))),
      momentum_scale_(or_one(
          std::max(start.y.norm(), std::sqrt(model.moments.maxCoeff() * model.chi_P.norm())))) {
  if (keeps_momentum(model)) worst_.momentum = 0.0;
  if (!model.table) {
    if (keeps_energy(model)) worst_.energy = 0.0;
    if (model.loads.turning.empty() && !model.loads.gimbals && !model.with_translation &&
        model.chi_P.squaredNorm() > 0.0) {
      const HeavyBody<double> body = heavy_body(model);
      heavy_ = {body, heavy_invariants(body, numbers_of(start).data())};
    }
    return;
  }
  worst_.energy = 0.0;
  // a height is as good as another: what a fall from there gives is a scale too
  energy_scale_ += model.body.mass * model.gravity_S.norm() * model.table->surface->reach();
  const Moving begins = moving_of(model, start);
  for (const ContactInvariant* law : invariants_from(model, begins)) {
    const Vec3 value = law->value(model, begins);
    watched_.push_back({law, value, or_one(std::max(value.norm(), law->scale(model, begins)))});
    worst_.momentum = 0.0;
  }
}

void DriftWatch::look_at(const State& s, const ContactState& contact) {
  if (heavy_) {
    const std::array<double, 7> numbers = numbers_of(s);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      heavy_->waiting[i][heavy_->count] = numbers[i];
    if (++heavy_->count == kAtOnce) look_at_waiting();
    return;
  }
  if (contact.touch.phase == Touch::Phase::flying)
    std::erase_if(watched_, [](const Watched& one) { return one.law->while_touching; });
  const Drift now = of(s, contact);
  keep_larger(worst_.energy, now.energy);
  keep_larger(worst_.momentum, now.momentum);
}

void DriftWatch::look_at_waiting() {
  std::array<double, kAtOnce> energies, momenta;
  find_invariants(heavy_->body, heavy_->waiting, energies, momenta);
  for (std::size_t i = 0; i < heavy_->count; ++i) {
    const Drift now = of_heavy({energies[i], momenta[i]});
    keep_larger(worst_.energy, now.energy);
    keep_larger(worst_.momentum, now.momentum);
  }
  heavy_->count = 0;
}

Drift DriftWatch::worst() {
  if (heavy_) look_at_waiting();
  return worst_;
}

Drift DriftWatch::of_heavy(const HeavyInvariants<double>& now) const {
  return {(now.energy - heavy_->at_start.energy) / energy_scale_,
          std::abs(now.momentum - heavy_->at_start.momentum) / momentum_scale_};
}

Drift DriftWatch::of(const State& s, const ContactState& contact) const {
  if (heavy_) return of_heavy(heavy_invariants(heavy_->body, numbers_of(s).data()));
  Drift drift;
  if (worst_.energy) drift.energy = (energy(model_, s) - contact.work - energy_) / energy_scale_;
  if (model_.table) {
    const Moving now = moving_of(model_, s);
    for (const Watched& one : watched_) {
      const double apart = (one.law->value(model_, now) - one.value).norm() / one.scale;
      if (!(apart <= drift.momentum.value_or(0.0))) drift.momentum = apart;
    }
    if (worst_.momentum && !drift.momentum) drift.momentum = 0.0;
    return drift;
  }
  if (worst_.momentum) {
    drift.momentum = (conserved_momentum(model_, s) - momentum_).norm() / momentum_scale_;
  }
  return drift;
}

}  // namespace polhode
