// SPDX-License-Identifier: MIT
// Closed-form rotations behind the Trajectory interface.
#pragma once

#include <memory>

#include "motion/trajectory.h"

namespace polhode {

// Free spherical top: omega is constant. Needs model.kind spherical and chi = 0.
std::unique_ptr<Trajectory> exact_spherical(const BodyModel& model, const State& start);

// Free symmetric top, and the free rotator as its limit. Needs a symmetric model and chi = 0.
// With the symmetry axis as the third, y(t) = Rz(-beta t) y0 and
// q(t) = q0 o exp(t y0 / (2 I1)) o exp(beta t e3 / 2), beta = (1/I3 - 1/I1) y3: precession about L
// at |L|/I1 (Landau and Lifshitz, Mechanics, eq. 33.2), the rest of the spin about the own axis.
std::unique_ptr<Trajectory> exact_symmetric(const BodyModel& model, const State& start);

// Free asymmetric top, any start: tumbling, about the least or the greatest axis, on the
// separatrix, at rest. Needs an asymmetric model without rotator and chi = 0. Sources:
// motion/exact/asymmetric.cpp.
std::unique_ptr<Trajectory> exact_asymmetric(const BodyModel& model, const State& start);

// Heavy symmetric top on a pivot with its centre of mass on the axis (Lagrange), in any gravity; a
// rotator is the spherical pendulum, and swinging in a plane the planar one. Needs chi along the
// symmetry axis, any chi for a spherical top; chi != 0. Sources: motion/exact/heavy_symmetric.cpp.
std::unique_ptr<Trajectory> exact_heavy_symmetric(const BodyModel& model, const State& start);

// Any of the free bodies above with the torque -c L, c > 0 in 1/s. With s = (1 - exp(-c t))/c the
// attitude is q(s) of the undamped motion and the momentum exp(-c t) y(s): both sides of
// dy/dt = y x omega - c y, and dq/dt, are exp(-c t) times those of the undamped motion.
std::unique_ptr<Trajectory> damped(std::unique_ptr<Trajectory> undamped, double c);

// Between which tilts the axis of a heavy symmetric top nods. Angles of chi (towards the centre of
// mass) from the vertical, rad.
struct Nutation {
  double least_tilt = 0.0;
  double greatest_tilt = 0.0;
  double period = 0.0;  // of the tilt, s; infinite for a top that creeps up to the vertical
  double precession_at_least = 0.0;  // rad/s about the vertical, there; NaN in the vertical itself
  double precession_at_greatest = 0.0;  // likewise
};

// The same needs as exact_heavy_symmetric. The tilt is an elliptic function of time with period
// 2 K / kappa (Landau and Lifshitz, Mechanics, 35, problem 1).
Nutation nutation_of(const BodyModel& model, const State& start);

}  // namespace polhode
