// SPDX-License-Identifier: MIT
// Copyright notices of what the documents of a lecture contain.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lecture/pages.h"

namespace polhode {

// The file of a lecture's folder that holds them.
inline constexpr const char* kNoticesFile = "LICENCES.txt";

// Is any of these outputs a page, which has styles, scripts or fonts of others inside?
bool has_pages(const std::vector<std::string>& outputs);

// The notices of these outputs. reveal: what slides were made with; formula_font: pages have it
// inside.
std::string notices(const std::vector<std::string>& outputs,
                    const std::optional<Reveal>& reveal,
                    bool formula_font);

}  // namespace polhode
