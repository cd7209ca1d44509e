// SPDX-License-Identifier: MIT
// Formulas as browsers understand them.
#pragma once

#include <string>

namespace polhode {

// A page of pandoc's whose MathML looks in browsers as it does in TeX: brackets that need not grow
// keep their width, upright letters stand upright, bars and arrows are as long as what is below.
std::string formulas_for_browsers(const std::string& html);

}  // namespace polhode
