// SPDX-License-Identifier: MIT
// The Poincaré section of a heavy body on a pivot: where motions of one energy and one vertical
// momentum cross a surface, over and over. Motions of integrable bodies lie on curves, chaotic ones
// fill areas.
//
// The angles are zxz (math/notation.h) of axes F in the body: the third principal axis, and a
// second axis such that the centre of mass hangs in the plane of these two. There the vertical is
// gamma = (sin theta sin psi, sin theta cos psi, cos theta). The surface is psi = 0 with gamma_1
// increasing; on it the tilt theta and its momentum p, about the line of nodes, are conjugate
// variables, and the map from one crossing to the next keeps areas (V. I. Arnold, Mathematical
// Methods of Classical Mechanics, appendix 9).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/body_model.h"

namespace polhode {

// All motions of a body that have one energy and one vertical momentum.
class SectionSurface {
 public:
  // Those of `start`. The model must pass why_not_section().
  SectionSurface(const BodyModel& model, const State& start);

  // The state on the surface at the tilt theta (rad, between 0 and pi) and with the momentum p (kg
  // m^2/s); absent where energy and vertical momentum do not allow one.
  std::optional<State> state_at(double theta, double p) const;
  // Tilt and momentum of a state on the surface, and the vertical in axes F.
  Vec2 point_of(const State& state) const;
  Vec3 vertical_F(const State& state) const;
  // gamma_1, which is zero on the surface, its rate (1/s), and the length of the vertical's second
  // derivative in the body (1/s^2).
  struct Passage {
    double at, rate, bend;
  };
  Passage passage_of(const State& state) const;
  // The least and the greatest momentum at a tilt; absent where there is none.
  struct Allowed {
    double least, greatest;
  };
  std::optional<Allowed> allowed_at(double theta) const;
  // `count` starts, spread evenly over the allowed part (theta, p) of the surface.
  std::vector<Vec2> spread(int count) const;

  const BodyModel& model() const { return model_; }
  double energy() const { return energy_; }                        // J
  double vertical_momentum() const { return vertical_momentum_; }  // kg m^2/s

 private:
  // p^2 a + p b + c >= 0 where there is a state, and more of the same
  struct AtTilt;
  AtTilt at_tilt(double theta) const;

  BodyModel model_;
  double energy_ = 0.0;
  double vertical_momentum_ = 0.0;
  Mat3 R_PF_ = Mat3::Identity();
  Mat3 inverse_F_ = Mat3::Identity();  // of the tensor of inertia, in F
};

// Nothing if the model has a section: a body on a pivot that gravity turns, without other torques,
// no thin rod. Else what it needs, and the key of the scene that keeps it from one.
struct SectionObstacle {
  std::string key, needs;
};
std::optional<SectionObstacle> why_not_section(const BodyModel& model);

// How neighbouring motions part: in proportion to the time if the motion is regular, exponentially
// if it is chaotic. From the second to the last quarter of the time their distance (its geometric
// mean) grows 2.3 times in the one case. `regular`: less than e^3 times in at least 100 turns,
// `chaotic`: more than e^6 times, else `undecided`. Chaos that is weaker than this shows after more
// crossings. Lagrange's and Kovalevskaya's tops are never chaotic; where rounding errors make their
// motions part at a separatrix, they are `undecided`.
enum class SectionVerdict { regular, undecided, chaotic };
const char* name_of(SectionVerdict verdict);

// What became of one motion.
struct SectionOrbit {
  std::vector<Vec2> points;   // theta (rad) and p (kg m^2/s) at each crossing
  double growth = 0.0;        // natural logarithm of how much neighbours have parted
  double duration = 0.0;      // s, to the last crossing
  double energy_drift = 0.0;  // largest relative change (Drift::energy in motion/trajectory.h)
  SectionVerdict verdict = SectionVerdict::undecided;

  // The largest Lyapunov exponent, estimated over this time, 1/s.
  double exponent() const { return duration > 0.0 ? growth / duration : 0.0; }
};

// Integrates from `start` (dop853 with a tolerance of 1e-12) until `crossings` crossings were
// found, each to a few roundings of its time. A motion that turns 200 times (typical_rate(),
// motion/scales.h) without one ends there. Throws Error (check_failed) as the method does,
// (interrupted). Thread-safe.
SectionOrbit trace_section(const SectionSurface& surface, const State& start, int crossings);

}  // namespace polhode
