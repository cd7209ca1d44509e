// SPDX-License-Identifier: MIT
// The command `section` with two keys: a map of where the motion of a scene is chaotic.
#pragma once

#include <string>

#include "app/commands/section_job.h"
#include "app/divided_work.h"

namespace polhode {

// Writes section_map.csv and section_map.png into the folder, together at the end; finished rows of
// cells are kept in section_map.resume as section() keeps motions. job.map must be set. Returns a
// summary of a line. Throws Error as section() does, and (input) with --x, --y, --x-range,
// --y-range or --cells as key as axis_of_key and parse_cells (app/commands/map_options.h) do, and
// as load_scene does for values that the scene cannot have.
std::string section_map(const SectionJob& job);

// The same work before it is begun. Throws Error as section_map() does.
DividedWork divided_section_map(const SectionJob& job);

}  // namespace polhode
