// SPDX-License-Identifier: MIT
// Falls of a body on a table, which take no time.
#pragma once

#include "model/friction.h"
#include "model/table.h"

namespace polhode {

// The impulse at the point that comes down with the velocity `before` (against the table, m/s, z
// down; zero if it rises), in N s, all in S. mobility: the velocity that the point gains per
// impulse (model/mobility.h). While the normal impulse grows, the velocity follows (Routh), with
// friction as the law says for the slip of that moment; slip that has ended stays so if friction
// can hold it, and begins anew if not. Rolling friction ends the slip at once. The fall ends when
// the normal force has given back restitution^2 of the work that it has taken (Stronge, Impact
// Mechanics, 2000). Where friction does not change the normal velocity, the speed after is
// `restitution` times that before; where it does, that rule of Newton's would make energy.
Vec3 impulse_of_fall(const Mat3& mobility,
                     const Friction& law,
                     double restitution,
                     const Vec3& before);

// The velocities after a fall on the table at `now`, with touch.piece lowest.
void fall_on_table(const BodyModel& model, const Touch& touch, double restitution, Moving& now);

}  // namespace polhode
