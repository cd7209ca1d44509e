// SPDX-License-Identifier: MIT
// Formats tables for a terminal.
#pragma once

#include <string>
#include <vector>

namespace polhode {

using TextRow = std::vector<std::string>;

// One line per row. Every column but the last is padded to its widest cell (in bytes).
std::string aligned(const std::vector<TextRow>& rows);

}  // namespace polhode
