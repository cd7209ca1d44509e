// SPDX-License-Identifier: MIT
// The command `stability`: maps of how methods fail over two parameters.
#pragma once

#include <string>

#include "app/commands/stability_job.h"

namespace polhode {

// Writes stability.csv, stability_SCENE_METHOD.png for each scene and method, and an overview
// stability_SCENE.png and .svg for each scene into the folder, together at the end. If it is
// interrupted or fails, finished rows of cells are kept there in stability.resume for the next run
// with the same options. Returns a summary, one line per scene and method. Throws Error (input) as
// make_place and prepare_place (app/commands/mapped_scene.h), OutputFolder
// (base/system/output_folder.h) and KeptRows (base/system/kept_rows.h, for stability.resume) do,
// with --methods as key for an unknown method, with --y as key for equal axes, and without a place
// for two scenes of the same name; (environment) without gnuplot or if a file cannot be written;
// (interrupted).
std::string stability(const StabilityJob& job);

}  // namespace polhode
