// SPDX-License-Identifier: MIT
// Tables for a terminal.
#pragma once

#include <string>
#include <vector>

namespace polhode {

using TextRow = std::vector<std::string>;

// Columns padded to their widest cell, the last one free; a line per row.
std::string aligned(const std::vector<TextRow>& rows);

}  // namespace polhode
