// SPDX-License-Identifier: MIT
// Computes what the plots of show.plots show.
#pragma once

#include <vector>

#include "film/solved_scene.h"
#include "frame/plot.h"

namespace polhode {

// The plots of show.plots over the whole motion, in the order of the list; empty if there are none.
// Throws Error (check_failed) as Motion::at does.
std::vector<FilmPlot> make_plots(const Solved& solved);

}  // namespace polhode
