// SPDX-License-Identifier: MIT
// The files that come with the program, found from where the program is: no path is built in.
#pragma once

#include <filesystem>

namespace polhode {

// PREFIX/share/polhode of an installed PREFIX/bin/polhode, else share/polhode beside the binary,
// as a build folder has it. The first of them is the answer when neither is there.
std::filesystem::path shipped_files();

// The example scenes: the folder named by POLHODE_SCENES if that is set, else
// shipped_files()/scenes.
std::filesystem::path shipped_scenes();

}  // namespace polhode
