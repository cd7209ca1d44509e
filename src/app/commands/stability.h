// SPDX-License-Identifier: MIT
// The command `stability`: maps of how methods fail over two parameters.
#pragma once

#include <string>

#include "app/commands/stability_job.h"
#include "app/divided_work.h"

namespace polhode {

// Writes stability.csv, stability_SCENE_METHOD.png for each scene and method, and an overview
// stability_SCENE.png and .svg for each scene into the folder, together at the end. If it is
// interrupted or fails, finished rows of cells are kept there in stability.resume for the next run
// with the same options. Returns a summary, one line per scene and method. Throws Error (input) as
// make_place and prepare_rows (app/commands/mapped_scene.h), OutputFolder
// (base/system/output_folder.h) and KeptRows (base/system/kept_rows.h, for stability.resume) do,
// with --methods as key for an unknown method, with --y as key for equal axes, and without a place
// for two scenes of the same name; (environment) without gnuplot or if a file cannot be written;
// (interrupted).
//
// With job.part.shard it only makes a part of the rows and keeps them in the folder, where the run
// without it finds them; it needs no gnuplot. Then it returns a line about that. It also throws
// Error (input) as part_of_work() and make_part() (app/piecewise.h) do.
std::string stability(const StabilityJob& job);

// The same work before it is begun. Throws Error as stability() does.
DividedWork divided_stability(const StabilityJob& job);

}  // namespace polhode
