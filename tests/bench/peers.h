// SPDX-License-Identifier: MIT
// Integrators of well-known libraries on the same motions: what Polhode's are measured against.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/body_model.h"

namespace polhode::bench {

// angular velocity in body axes, and the attitude w, x, y, z
using PeerState = std::array<double, 7>;

// Euler's equations with gravity, as a user of a library writes them.
struct PeerProblem {
  PeerProblem(const BodyModel& model, const State& start, double duration);
  void rate(const PeerState& x, PeerState& dx) const;

  Vec3 moments, chi, up;
  bool heavy;
  PeerState start;
  double duration;
};

State to_state(const PeerProblem& problem, const PeerState& x);

// A method of a library; `run` integrates to the end with a tolerance, or where `fixed` with a
// number of steps, and returns the end.
struct Peer {
  std::string name;
  bool fixed;
  PeerState (*run)(const PeerProblem& problem, double fineness);
};

const std::vector<Peer>& peers();

}  // namespace polhode::bench
