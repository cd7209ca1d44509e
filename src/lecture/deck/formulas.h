// SPDX-License-Identifier: MIT
// Formulas as pandoc understands them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

// For each byte of TeX, whether it belongs to words in a formula, as in \text{…}, but not to a
// formula $…$ in these.
std::vector<bool> words_in(const std::string& tex);

// A formula of which pandoc reads all as TeX does, so that it refuses what is no mathematics:
// without what it skips or shows though TeX does not. Comments and labels are left out, and
// numbers, which it leaves out of all documents but LaTeX, are words at the end of their rows:
// \tag{1} becomes (1), \tag*{a} becomes a. Quantities of siunitx are plain_quantities()
// (lecture/deck/quantities.h). Throws Error (input), without a place, for numbers and labels that
// are not in braces, for ends of formulas, for matrices that LaTeX would not know, and for
// quantities that would be shown as others.
std::string whole_formula(const std::string& tex);

// A number, as TeX, as a part of a formula: in braces, so that what is done to it is done to all of
// it, and in brackets where it is raised or, if it is negative, would be taken from what stands
// before. before, behind: the formula around it. among_words: it is a formula of its own between
// these.
std::string part_of_formula(const std::string& tex,
                            std::string_view before,
                            std::string_view behind,
                            bool among_words);

}  // namespace polhode
