// SPDX-License-Identifier: MIT
// Finds the files installed with the program. The search starts at the running binary
// (/proc/self/exe), so no path is compiled in.
#pragma once

#include <filesystem>

namespace polhode {

// PREFIX/share/polhode for an installed PREFIX/bin/polhode, else share/polhode beside the binary
// (in a build folder). If neither folder exists, the first path is returned.
std::filesystem::path shipped_files();

// The folder of the example scenes: the value of the environment variable POLHODE_SCENES if it is
// set and not empty, else shipped_files()/scenes. The folder need not exist.
std::filesystem::path shipped_scenes();

}  // namespace polhode
