// SPDX-License-Identifier: MIT
// The centre line of a coil spring.
#pragma once

#include <vector>

#include "math/notation.h"

namespace polhode {

// The number of turns of every coil: stretching changes the pitch only.
inline constexpr int kCoilTurns = 15;

// The centre line of a coil along z, in the unit of its arguments (in frame/elements/vectors.cpp
// radii of the body): from the origin straight along z, a helix of kCoilTurns turns about z, whose
// first and last half turn spiral out from the axis and back to it, and straight to (0, 0, length).
// radius: of the helix. end: the length of each straight end; a short coil has shorter ones.
// pieces: straight pieces per turn. length: not negative; 0 gives a flat coil.
std::vector<Vec3> coil_line(double length, double radius, double end, int pieces);

}  // namespace polhode
