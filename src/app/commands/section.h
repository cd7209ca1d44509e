// SPDX-License-Identifier: MIT
// The command `section`: the Poincaré section of a heavy body.
#pragma once

#include <string>

#include "app/commands/section_job.h"
#include "app/divided_work.h"

namespace polhode {

// Writes section.csv and section.png into the folder, together at the end. If it is interrupted or
// fails, finished motions are kept there in section.resume for the next run with the same options.
// Returns a summary of a few lines. Throws Error (input) as load_single (film/solved_scene.h),
// make_model, start_state, OutputFolder and KeptRows do, with --starts or --crossings as key for a
// number out of range, and without a key if the scene has no section; (check_failed) as
// trace_section (chart/section.h) does; (environment) without gnuplot or if a file cannot be
// written; (interrupted).
//
// With job.part.shard it only makes a part, as stability() (app/commands/stability.h) does.
std::string section(const SectionJob& job);

// The same work before it is begun. Throws Error as section() does.
DividedWork divided_section(const SectionJob& job);

}  // namespace polhode
