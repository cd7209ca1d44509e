// SPDX-License-Identifier: MIT
// Draws the plots of show.plots beside the picture, once, with gnuplot.
#pragma once

#include <vector>

#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// The fraction of the picture's width that plots take on the right; 0 without plots.
double width_of_plots(const ShowSpec& show);

// The plots of show.plots, one below the other. Throws Error (environment) if gnuplot is missing or
// fails.
std::vector<FilmPlot> make_plots(const Solved& solved);

}  // namespace polhode
