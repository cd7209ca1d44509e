// SPDX-License-Identifier: MIT
// Computes what the plots and diagrams of show.plots show.
#pragma once

#include <vector>

#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// The plots of show.plots of the first scene over the whole motion, and its diagrams, in the order
// of the list; empty if there are none. `solved` as for make_film (film/film_panels.h); each plot
// has the curves of all scenes, with the captions of their panels. Throws Error (input) with
// show.plots as key for more curves than can be told apart, for diagrams of several scenes and for
// those that the motion does not have; and (check_failed) as Motion::at does.
FilmCharts make_charts(const std::vector<Solved>& solved);

}  // namespace polhode
