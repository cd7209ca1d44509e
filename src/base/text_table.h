// SPDX-License-Identifier: MIT
// Formats tables for a terminal.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// The cells of one row. Rows may differ in length.
using TextRow = std::vector<std::string>;

// One line per row, each ending in a line break. Columns are two spaces apart; every cell of a row
// but its last is padded to the widest cell of its column, counted in bytes.
std::string aligned(const std::vector<TextRow>& rows);

}  // namespace polhode
