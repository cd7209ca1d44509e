// SPDX-License-Identifier: MIT
// The laboratory stand under a pivot.
#pragma once

#include "frame/mesh.h"

namespace polhode {

// The radius of the base plate, in units of the body's radius.
inline constexpr double kStandFoot = 0.2;
// The cone with its apex at the pivot that contains the upper half of the stand: its radius over
// its depth. A body that keeps outside of it does not touch the stand.
inline constexpr double kStandClearance = 0.31;

// The stand as one surface of revolution about z, in units of the body's radius: a base plate at
// z = -height, a slender column that tapers upwards, a ball bearing, and a pin whose tip is the
// pivot, the origin. height: at least 0.4. segments: straight pieces that stand for a full circle.
Mesh stand_mesh(double height, int segments);

}  // namespace polhode
