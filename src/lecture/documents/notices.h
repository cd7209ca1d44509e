// SPDX-License-Identifier: MIT
// Makes the copyright notices for the parts of a lecture's pages that do not come from its deck:
// Polhode's own styles and scripts, reveal.js, and the font of formulas.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lecture/documents/pages.h"
#include "lecture/documents/turning.h"

namespace polhode {

// The file name of the notices in the lecture's folder.
inline constexpr const char* kNoticesFile = "LICENCES.txt";

// Whether any of these outputs (names from lecture_outputs() in lecture/lecture.h) is made from an
// HTML page, which contains styles, scripts or fonts: html, slides, handout.
bool has_pages(const std::vector<std::string>& outputs);

// The notices for these outputs, as plain text; to be called only if has_pages(outputs). reveal:
// what the slides contain, not used without slides; three: what page and slides contain, if
// anything; formula_font: whether the pages contain the font for formulas; computes: whether page
// and slides contain what computes motions (find_page_core() in lecture/documents/sliders.h).
std::string notices(const std::vector<std::string>& outputs,
                    const std::optional<Reveal>& reveal,
                    bool formula_font,
                    const std::optional<Three>& three = {},
                    bool computes = false);

// The same with those of an earlier file, `before`, that it lacks: documents of an earlier run
// contain what is told there.
std::string with_earlier_notices(std::string text, const std::string& before);

}  // namespace polhode
