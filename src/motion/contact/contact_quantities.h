// SPDX-License-Identifier: MIT
// What theory says of a body on a table: thresholds, growth rates, steady motions.
#pragma once

#include <optional>
#include <vector>

#include "model/table.h"
#include "motion/quantity.h"

namespace polhode {

// The largest rate (1/s) at which a small deviation grows while the body spins about the vertical
// at `spin` (rad/s) with its direction up_P upwards; 0 if none grows. up_P (unit) must be a
// principal axis that meets the surface at a right angle below the centre of mass. Friction counts
// as at small slip: Coulomb's holds. From the eigenvalues of the linearised equations of (up,
// angular velocity, and with viscous friction velocity) in P; nothing where friction is so strong
// that their round-off hides it.
std::optional<double> growth_rate_of_spin(const BodyModel& model, const Vec3& up_P, double spin);

// The quantities of a body on a table that starts so (`start` as start_state gives it), after the
// energies.
std::vector<Quantity> contact_quantities(const BodyModel& model, const State& start);

}  // namespace polhode
