// SPDX-License-Identifier: MIT
// Makes the film of a solved scene: its panels, text and plots.
#pragma once

#include <vector>

#include "film/comparison.h"
#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// The film has one panel, or one per compared method, or one per entry of show.views. `comparison`:
// null if nothing is compared; must outlive the film. `plots`: those of show.plots. `with_text`:
// with title, captions, clock and the notes of panels. Throws Error (input) naming show.plots if
// there are plots and several panels, and as Composer does.
Film make_film(const Solved& solved,
               const Timeline& timeline,
               const Comparison* comparison,
               const std::vector<FilmPlot>& plots,
               bool with_text);

}  // namespace polhode
