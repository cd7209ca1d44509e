// SPDX-License-Identifier: MIT
// Closed-form rotations as trajectories, without the motion of the centre of mass. The caller must
// check the requirements stated here, as motion/solution_method.cpp does; loads of the model are
// ignored. at() does not throw. Frames and letters: math/notation.h; chi: BodyModel::chi_P, the
// torque of gravity being gamma x chi; start: the state at t = 0; exp(v): the rotation by |v|
// radians about v. Any thread may use the trajectories.
#pragma once

#include <memory>
#include <optional>

#include "motion/trajectory.h"

namespace polhode {

// Free spherical top: omega is constant. Requires a spherical model and chi = 0.
std::unique_ptr<Trajectory> exact_spherical(const BodyModel& model, const State& start);

// Free symmetric top, and the free rotator as its limit. Requires a symmetric model and chi = 0.
// With the symmetry axis as the third, I3 the moment about it and I1 that across it, y(t) =
// Rz(-beta t) y0 and q(t) = q0 o exp(t y0 / I1) o exp(beta t e3), beta = (1/I3 - 1/I1) y3:
// precession about L at |L|/I1 (Landau and Lifshitz, Mechanics, section 33), combined with a
// rotation about the symmetry axis.
std::unique_ptr<Trajectory> exact_symmetric(const BodyModel& model, const State& start);

// Free asymmetric top for any start: tumbling, rotation about the axis of the least or greatest
// moment, the separatrix, rest. Requires an asymmetric model that is no rotator, and chi = 0.
// Sources: motion/exact/asymmetric.cpp.
std::unique_ptr<Trajectory> exact_asymmetric(const BodyModel& model, const State& start);

// Heavy symmetric top on a pivot with its centre of mass on the symmetry axis (Lagrange's top), for
// gravity in any direction. Includes the rotator (spherical pendulum) and the planar pendulum.
// Requires a spherical model, or a symmetric one with chi along the symmetry axis; aborts for chi =
// 0. Sources: motion/exact/heavy_symmetric.cpp.
std::unique_ptr<Trajectory> exact_heavy_symmetric(const BodyModel& model, const State& start);

// Any of the free bodies above with the damping torque -c L, c > 0 in 1/s. With s = (1 - exp(-c
// t))/c the attitude is q(s) of the undamped motion and the momentum exp(-c t) y(s): both sides of
// dy/dt = y x omega - c y, and dq/dt, are exp(-c t) times those of the undamped motion.
std::unique_ptr<Trajectory> damped(std::unique_ptr<Trajectory> undamped, double c);

// The nutation of a heavy symmetric top. Tilts are angles between chi (towards the centre of mass)
// and the upward vertical, rad.
struct Nutation {
  double least_tilt = 0.0;
  double greatest_tilt = 0.0;
  // Period of the tilt, s; infinite for a top that approaches the vertical asymptotically, 0 for
  // one that stays vertical.
  double period = 0.0;
  // Precession about the vertical, rad/s, at least_tilt and at greatest_tilt; NaN if that tilt is
  // the vertical itself, 0 for a top that stays vertical.
  double precession_at_least = 0.0;
  double precession_at_greatest = 0.0;
  bool over_the_top = false;  // of motion in a vertical plane: it does not turn back
};

// Same requirements as exact_heavy_symmetric. The cosine of the tilt is an elliptic function of
// time with the period 2 K / kappa, kappa as in motion/exact/heavy_symmetric.cpp (Landau and
// Lifshitz, Mechanics, section 35, problem 1).
Nutation nutation_of(const BodyModel& model, const State& start);

// How far the axis goes round the vertical in one period of the nutation, rad. Same requirements;
// aborts where that period is 0 or infinite. Nothing if round-off decides more than 1e-5 of it, as
// for tops that hardly precess; meaningless for an axis that passes through the vertical.
std::optional<double> precession_in_a_nutation(const BodyModel& model, const State& start);

}  // namespace polhode
