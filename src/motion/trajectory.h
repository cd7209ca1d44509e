// SPDX-License-Identifier: MIT
// The interface that closed forms and integrations share: the state as a function of time.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model/body_model.h"
#include "model/contact_invariants.h"

namespace polhode {

// How a body on a table touches it at a moment.
struct ContactState {
  Touch touch;
  double work = 0.0;  // what the table has done on the body since the start, J
};

// Immutable. at() may be called from any thread, for any t in [0, duration] (s), in any order.
class Trajectory {
 public:
  virtual ~Trajectory() = default;
  // The state at t (s). Place and linear momentum are meaningful with six degrees of freedom only.
  // Throws Error (check_failed) if the partial step of an integration has no solution
  // (Stepper::step in motion/stepper.h).
  virtual State at(double t) const = 0;
  // How the body touches the table at t (s), if there is one. Throws as at() does.
  virtual std::optional<ContactState> contact_at(double) const { return {}; }
};

// Relative changes of the conserved quantities since the start: the largest over a motion, or those
// of one state. Absent if the loads do not conserve them.
struct Drift {
  // Of energy() (model/body_model.h), relative to the kinetic energy at the start + |chi| + the
  // sizes of the other potential energies, or to 1 J if all of them are 0. On a table the work of
  // the table counts as lost, so that the sum stays whatever the friction.
  std::optional<double> energy;
  // Of the vector L or, with a torque of gravity, of L.up; relative to |L| at the start or, if that
  // is larger, to sqrt(greatest moment * |chi|), or to 1 kg m^2/s if both are 0. On a table the
  // largest of contact_invariants() (model/contact_invariants.h), each relative to its scale.
  std::optional<double> momentum;
};

// Records the largest drift of a sequence of states. Not thread-safe.
class DriftWatch {
 public:
  // start: the state at t = 0, with which others are compared.
  DriftWatch(const BodyModel& model, const State& start);
  // Takes one more state into account; NaN is kept as the largest drift.
  void look_at(const State& s, const ContactState& contact = {});
  // The drift of one state; that of energy is signed, that of momentum is not. On a table `contact`
  // tells the work of the table.
  Drift of(const State& s, const ContactState& contact = {}) const;
  // The largest drift so far, without sign; a reference to a member.
  const Drift& worst() const { return worst_; }

 private:
  BodyModel model_;
  double energy_;
  Vec3 momentum_;
  double energy_scale_;
  double momentum_scale_;
  // on a table
  struct Watched {
    const ContactInvariant* law;
    Vec3 value;
    double scale;
  };
  std::vector<Watched> watched_;
  Drift worst_;
};

}  // namespace polhode
