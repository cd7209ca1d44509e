// SPDX-License-Identifier: MIT
// The interface that closed forms and integrations share: the state as a function of time.
#pragma once

#include <memory>
#include <optional>

#include "model/body_model.h"

namespace polhode {

// Immutable. at() may be called from any thread, for any t in [0, duration] (s), in any order.
class Trajectory {
 public:
  virtual ~Trajectory() = default;
  // The state at t (s). Place and linear momentum are meaningful with six degrees of freedom only.
  // Throws Error (check_failed) if the partial step of an integration has no solution
  // (Stepper::step in motion/stepper.h).
  virtual State at(double t) const = 0;
};

// Relative changes of the conserved quantities since the start: the largest over a motion, or those
// of one state. Absent if the loads do not conserve them.
struct Drift {
  // Of energy() (model/body_model.h), relative to the kinetic energy at the start + |chi| + the
  // sizes of the other potential energies, or to 1 J if all of them are 0.
  std::optional<double> energy;
  // Of the vector L or, with a torque of gravity, of L.up; relative to |L| at the start or, if that
  // is larger, to sqrt(greatest moment * |chi|), or to 1 kg m^2/s if both are 0.
  std::optional<double> momentum;
};

// Records the largest drift of a sequence of states. Not thread-safe.
class DriftWatch {
 public:
  // start: the state at t = 0, with which others are compared.
  DriftWatch(const BodyModel& model, const State& start);
  // Takes one more state into account; NaN is kept as the largest drift.
  void look_at(const State& s);
  // The drift of one state; that of energy is signed, that of momentum is not.
  Drift of(const State& s) const;
  // The largest drift so far, without sign; a reference to a member.
  const Drift& worst() const { return worst_; }

 private:
  BodyModel model_;
  double energy_;
  Vec3 momentum_;
  double energy_scale_;
  double momentum_scale_;
  Drift worst_;
};

}  // namespace polhode
