// SPDX-License-Identifier: MIT
// The interface that closed forms and integrations share: the state as a function of time.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "model/body_model.h"
#include "model/contact_invariants.h"
#include "motion/steppers/lanes.h"

namespace polhode {

// How a body on a table touches it at a moment.
struct ContactState {
  Touch touch;
  double work = 0.0;  // of the table and of loads without a potential since the start, J
};

// Immutable. at() may be called from any thread, for any t in [0, duration] (s), in any order.
class Trajectory {
 public:
  virtual ~Trajectory() = default;
  // The state at t (s). Place and linear momentum are meaningful with six degrees of freedom only.
  // Throws Error (check_failed) if the partial step of an integration has no solution
  // (Stepper::step in motion/stepper.h).
  virtual State at(double t) const = 0;
  // The states at these times (s), in their order: those of at(), which may cost more one by one.
  virtual std::vector<State> at_each(const std::vector<double>& times) const;
  // Each time (s, ascending) moved back to where the state costs nothing to ask for, if there is
  // such a time shortly before.
  virtual std::vector<double> kept_times(const std::vector<double>& times) const { return times; }
  // Times (s, ascending), about `count` of them, that are the closer together, the more an
  // integration has to do there; none of what is not integrated.
  virtual std::vector<double> busy_times(std::size_t /*count*/) const { return {}; }
  // How the body touches the table at t (s), if there is one. Throws as at() does.
  virtual std::optional<ContactState> contact_at(double) const { return {}; }
};

// Of the grid times (s, ascending) of an integration about `count`, after equal shares of its steps
// and of the angle by which the body has turned: speeds of rotation at these times, rad/s.
std::vector<double> busy_times_of(const std::vector<double>& grid,
                                  const std::vector<double>& speeds,
                                  std::size_t count);

// Relative changes of the conserved quantities since the start: the largest over a motion, or those
// of one state. Absent if the loads do not conserve them.
struct Drift {
  // Of energy() (model/body_model.h), relative to the kinetic energy at the start + |chi| + the
  // sizes of the other potential energies, or to 1 J if all of them are 0. On a table the work of
  // the table and of loads without a potential does not count, so that the rest stays whatever they
  // do.
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
  // Takes one more state into account; NaN is kept as the largest drift. Bodies with no load but
  // gravity are looked at by eights.
  void look_at(const State& s, const ContactState& contact = {});
  // The drift of one state; that of energy is signed, that of momentum is not. On a table `contact`
  // tells the work.
  Drift of(const State& s, const ContactState& contact = {}) const;
  // The largest drift so far, without sign.
  Drift worst();

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
  // Of bodies on a pivot with no load but gravity: what they are, and states that were not looked
  // at yet, as columns.
  static constexpr std::size_t kAtOnce = 8;
  using Columns = std::array<std::array<double, kAtOnce>, 7>;
  struct Heavy {
    HeavyBody<double> body;
    HeavyInvariants<double> at_start;
    Columns waiting = {};
    std::size_t count = 0;
  };
  std::optional<Heavy> heavy_;
  Drift worst_;

  void look_at_waiting();
  Drift of_heavy(const HeavyInvariants<double>& now) const;
};

}  // namespace polhode
