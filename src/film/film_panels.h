// SPDX-License-Identifier: MIT
// Makes the film of a solved scene: its panels, text and plots.
#pragma once

#include <vector>

#include "film/comparison.h"
#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// The film has one panel, or one per compared method, or one per entry of show.views. `comparison`
// may be null and must outlive the film. Throws Error (input) naming show.plots for plots beside
// several panels, and as Composer does.
Film make_film(const Solved& solved,
               const Timeline& timeline,
               const Comparison* comparison,
               const std::vector<FilmPlot>& plots,
               bool with_text);

}  // namespace polhode
