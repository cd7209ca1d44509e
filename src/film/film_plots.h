// SPDX-License-Identifier: MIT
// The plots beside a picture, drawn once by gnuplot.
#pragma once

#include <vector>

#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// The part of the frame's width that plots take on the right, 0 without plots.
double width_of_plots(const ShowSpec& show);

// Those of show.plots, one under the other. Throws Error (environment) when gnuplot is missing.
std::vector<FilmPlot> make_plots(const Solved& solved);

}  // namespace polhode
