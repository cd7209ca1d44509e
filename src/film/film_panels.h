// SPDX-License-Identifier: MIT
// From a solved scene to the panels of its film.
#pragma once

#include <vector>

#include "film/comparison.h"
#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// One panel; or one for each method that is compared, or for each of show.views. `comparison` must
// outlive the film. Throws Error (input) for plots beside several panels.
Film make_film(const Solved& solved,
               const Timeline& timeline,
               const Comparison* comparison,
               const std::vector<FilmPlot>& plots,
               bool with_text);

}  // namespace polhode
