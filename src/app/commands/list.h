// SPDX-License-Identifier: MIT
// The command `list`: prints the tables of the program: methods, models, shapes and so on.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// The names of the tables: methods, models, shapes, torques, elements, plots, scenes, starts,
// formats.
std::vector<std::string> list_names();

// The table of that name, as aligned columns with a heading. "scenes" lists the .toml files of the
// folder `scenes` in the working folder; if there is none, or if the environment variable
// POLHODE_SCENES is set, those of shipped_scenes() (base/shipped_files.h). Throws Error (input),
// without a place, for an unknown name or if there are no scenes, and as load_scene (scene/scene.h)
// does for a faulty scene.
std::string list_table(const std::string& name);

}  // namespace polhode
