// SPDX-License-Identifier: MIT
// Numbers and units of siunitx (the package of LaTeX) in formulas, of which pandoc knows a part.
#pragma once

#include <string>

namespace polhode {

// A formula whose quantities pandoc shows as siunitx does: units stand apart, \si{\newton\metre} is
// \si{\newton}\,\si{\metre}, and numbers with doubts or without digits before their power of ten
// are written out, \num{1.2(3)e-4} as {1.2(3)\times 10^{-4}}. Throws Error (input), without a
// place, for units and numbers that pandoc would show as others, or that readers would take for
// others.
std::string plain_quantities(const std::string& tex);

}  // namespace polhode
