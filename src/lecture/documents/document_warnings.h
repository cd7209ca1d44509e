// SPDX-License-Identifier: MIT
// What the documents of a lecture lack of its deck.
#pragma once

#include <string>
#include <vector>

#include "lecture/deck/deck.h"

namespace polhode {

// In words for the person who made the deck; `output` as in `--to`. Reads the deck's own pictures:
// throws Error as trusted_file() (lecture/deck/sandbox.h) and read_file() do.
std::vector<std::string> document_warnings(const Deck& deck, const std::string& output);

}  // namespace polhode
