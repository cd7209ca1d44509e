// SPDX-License-Identifier: MIT
// The use case `join`: from the pieces of a film to the film.
#pragma once

#include <string>
#include <vector>

#include "app/made.h"

namespace polhode {

struct JoinJob {
  std::vector<std::string> parts;  // in any order
  std::string output;
};

// The film has exactly the frames of its pieces, with title, chapters and captions of the whole.
// Throws Error (input) for pieces of different films (naming two of them and what differs), for
// missing ones (all are named), for one that is there twice or is damaged.
Made join_pieces(const JoinJob& job);

}  // namespace polhode
