// SPDX-License-Identifier: MIT
// The allowed values of options, taken from the tables that define them, for manual pages and
// shell completions.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// The values of one option each, in the order of their table.
std::vector<std::string> backend_words();   // --backend
std::vector<std::string> codec_words();     // --codec, for endings with a choice (.mp4)
std::vector<std::string> document_words();  // --to of `lecture`
std::vector<std::string> method_words();    // --method
std::vector<std::string> preset_words();    // --preset
std::vector<std::string> progress_words();  // --progress
std::vector<std::string> quality_words();   // --quality
std::vector<std::string> stepper_words();   // --methods of `chart` and `stability`
std::vector<std::string> theme_words();     // --theme

}  // namespace polhode
