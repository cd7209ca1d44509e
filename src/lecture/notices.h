// SPDX-License-Identifier: MIT
// Makes the copyright notices for third-party parts of a lecture's documents.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lecture/pages.h"

namespace polhode {

// The file name of the notices in the lecture's folder.
inline constexpr const char* kNoticesFile = "LICENCES.txt";

// Whether any of these outputs (names from lecture_outputs()) is made from an HTML page, which
// contains styles, scripts or fonts: html, slides, handout.
bool has_pages(const std::vector<std::string>& outputs);

// The notices for these outputs, as plain text. reveal: what the slides contain, absent without
// slides; formula_font: whether the pages contain the font for formulas.
std::string notices(const std::vector<std::string>& outputs,
                    const std::optional<Reveal>& reveal,
                    bool formula_font);

}  // namespace polhode
