// SPDX-License-Identifier: MIT
// The allowed values of options, taken from the tables that define them, for help and completions.
#pragma once

#include <string>
#include <vector>

namespace polhode {

std::vector<std::string> backend_words();   // of --backend
std::vector<std::string> codec_words();     // of --codec
std::vector<std::string> document_words();  // of `lecture --to`
std::vector<std::string> method_words();    // of --method and --methods
std::vector<std::string> preset_words();    // of --preset
std::vector<std::string> progress_words();  // of --progress
std::vector<std::string> quality_words();   // of --quality

}  // namespace polhode
