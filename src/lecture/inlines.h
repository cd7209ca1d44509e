// SPDX-License-Identifier: MIT
// Blocks of pandoc's tree as one paragraph, where a document has no room for more.
#pragma once

#include "base/json.h"

namespace polhode {

// The inlines of all blocks, with `between` (an inline) between paragraphs, lines, items and rows;
// cells of tables have " | " between them. Rules and pictures without words are left out.
Json inlines_of(const Json& blocks, const Json& between);

}  // namespace polhode
