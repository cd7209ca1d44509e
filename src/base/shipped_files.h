// SPDX-License-Identifier: MIT
// Finds the files installed with the program. The search starts at the binary, so no path is
// compiled in.
#pragma once

#include <filesystem>

namespace polhode {

// PREFIX/share/polhode for an installed PREFIX/bin/polhode, else share/polhode beside the binary
// (build folder). If neither exists, the first path is returned.
std::filesystem::path shipped_files();

// The example scenes: the folder named by POLHODE_SCENES if that is set, else
// shipped_files()/scenes.
std::filesystem::path shipped_scenes();

}  // namespace polhode
