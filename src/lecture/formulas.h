// SPDX-License-Identifier: MIT
// Formulas as pandoc and browsers understand them.
#pragma once

#include <string>

namespace polhode {

// TeX in which the number of a formula, which pandoc leaves out of all documents but LaTeX, is
// words behind it: \tag{1} becomes (1), \tag*{a} becomes a.
std::string with_tags_as_words(const std::string& tex);

// A page of pandoc's whose MathML looks in browsers as it does in TeX: brackets that need not grow
// keep their width, upright letters stand upright.
std::string formulas_for_browsers(const std::string& html);

}  // namespace polhode
