// SPDX-License-Identifier: MIT
// The command `join`: joins the shards of a film without re-encoding.
#pragma once

#include <string>
#include <vector>

#include "app/made.h"

namespace polhode {

// The options of `join`.
struct JoinJob {
  std::vector<std::string> parts;  // in any order
  std::string output;
};

// Writes the film with exactly the frames of its shards, and with title, chapters and captions of
// the whole film. Throws Error (input), with the file as place, for shards of different films (the
// message says what differs), for duplicate or damaged shards, and for an output with another
// ending; without a place if shards are missing (the message lists them).
Made join_pieces(const JoinJob& job);

}  // namespace polhode
