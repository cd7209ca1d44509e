// SPDX-License-Identifier: MIT
// Makes the film of a solved scene: its panels, text and plots.
#pragma once

#include <vector>

#include "film/comparison.h"
#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// Makes a film with one panel per solved scene; of a single scene one per compared method or,
// without a comparison, per entry of show.views (by default one). `solved` has the scenes of
// Scene::panels, or the one scene that has none; the first gives the text and, with
// Scene::same_cameras, the cameras. `comparison`: null if nothing is compared; it must outlive the
// film, which copies the other arguments. `charts`: what make_charts() (film/film_plots.h) has
// made of show.plots. `with_text`: with captions and the notes of panels; title, clock and labels
// are as the scene's `show` says. Throws Error (input) with show.plots as key if there are plots
// and a comparison, and as Composer does.
Film make_film(const std::vector<Solved>& solved,
               const Timeline& timeline,
               const Comparison* comparison,
               const FilmCharts& charts,
               bool with_text);

}  // namespace polhode
