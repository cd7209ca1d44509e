// SPDX-License-Identifier: MIT
// The axis of a body whose motion is watched.
#pragma once

#include "model/body_model.h"

namespace polhode {

// The unit vector (B) of the axis whose path, tilt and azimuth are drawn and plotted: the symmetry
// axis, else the direction from the pivot to the centre of mass, else the third body axis. On a
// pivot it points to the side of the centre of mass.
Vec3 figure_axis_B(const BodyModel& model);

}  // namespace polhode
