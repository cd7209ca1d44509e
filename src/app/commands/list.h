// SPDX-License-Identifier: MIT
// The command `list`: prints the tables of the program: methods, models, shapes, scenes, formats.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// The names of the tables: methods, models, shapes, scenes, formats.
std::vector<std::string> list_names();

// The table of that name, as aligned columns with a heading. "scenes" lists the .toml files of the
// folder named by POLHODE_SCENES, else of a folder `scenes` in the working folder, else of
// shipped_scenes(). Throws Error (input), without a place, for an unknown name or if there are no
// scenes, and as load_scene does for a faulty scene.
std::string list_table(const std::string& name);

}  // namespace polhode
