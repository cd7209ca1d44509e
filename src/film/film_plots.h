// SPDX-License-Identifier: MIT
// Computes what the plots of show.plots show.
#pragma once

#include <vector>

#include "film/solved_scene.h"
#include "frame/plot.h"

namespace polhode {

// The plots of show.plots of the first scene over the whole motion, in the order of the list; empty
// if there are none. `solved` as for make_film (film/film_panels.h); each plot has the curves of
// all scenes, with the captions of their panels. Throws Error (input) with show.plots as key for
// more curves than can be told apart, and (check_failed) as Motion::at does.
std::vector<FilmPlot> make_plots(const std::vector<Solved>& solved);

}  // namespace polhode
