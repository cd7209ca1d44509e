// SPDX-License-Identifier: MIT
// Draws the plots of show.plots, which stand to the right of the body, once per film with gnuplot.
#pragma once

#include <vector>

#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// The fraction (0..1) of the picture's width that plots take on the right; 0 without plots.
double width_of_plots(const ShowSpec& show);

// The plots of show.plots over the whole motion, one below the other in the order of the list;
// empty if there are none. Throws Error (environment) if gnuplot is missing or fails,
// (interrupted), and (check_failed) as Motion::at does.
std::vector<FilmPlot> make_plots(const Solved& solved);

}  // namespace polhode
