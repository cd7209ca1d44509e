// SPDX-License-Identifier: MIT
// What a film may show otherwise than its author expects.
#pragma once

#include <vector>

#include "film/frame_times.h"
#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// Logs warnings, each with its place in the scene: loops that do not close or show where they
// repeat, bodies that seem to turn backwards, steps of a story that show nothing, bodies of very
// different sizes in one scale, and those of Composer::warnings(). solved: the scenes of all
// panels, or one.
void warn_of_film(const std::vector<Solved>& solved, const FrameTimes& frames, const Film& film);

// Logs which texts of the scenes have letters that no font has. Opens fonts.
void warn_of_missing_letters(const std::vector<Solved>& solved);

// Logs which fonts are missing and what serves instead. Throws Error (environment) without any
// font.
void warn_of_missing_fonts();

}  // namespace polhode
