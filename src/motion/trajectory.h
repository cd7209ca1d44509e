// SPDX-License-Identifier: MIT
// A rotation as a function of time: the interface that exact solutions and integrations share.
#pragma once

#include <memory>
#include <optional>

#include "model/body_model.h"

namespace polhode {

// Immutable; at() may be called from any thread, for any t in [0, duration], in any order.
class Trajectory {
 public:
  virtual ~Trajectory() = default;
  virtual State at(double t) const = 0;
};

// Largest deviations from the start of what mechanics conserves, relative; over the whole motion.
// Absent where loads make it change.
struct Drift {
  std::optional<double> energy;    // of |kinetic energy at the start| + |chi| + |potential|
  std::optional<double> momentum;  // of |L|: the vector L (free) or its vertical part (pivot)
};

// Keeps the largest drift of the states it is shown.
class DriftWatch {
 public:
  DriftWatch(const BodyModel& model, const State& start);
  void look_at(const State& s);
  // The drift of this state alone; that of energy with its sign.
  Drift of(const State& s) const;
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
