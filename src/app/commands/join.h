// SPDX-License-Identifier: MIT
// The command `join`: joins the shards of a film (made by `render --shard K/N`)
// without re-encoding.
#pragma once

#include <string>
#include <vector>

#include "app/made.h"

namespace polhode {

// The options of `join`.
struct JoinJob {
  std::vector<std::string> parts;  // files of all shards, in any order; at least one
  std::string output;              // file of the film, with the same ending as the shards
};

// Writes the film with exactly the frames of its shards, and with title, chapters and captions of
// the whole film. Throws Error (input) with the file as place for shards of different films (the
// message says what differs), for duplicate or damaged shards, for files that are no shards, and
// for an output with another ending; without a place for an output that is one of the shards or
// ends in .toml, and if shards are missing (the message lists them); otherwise as FilmJoiner and
// its join() (video/film_joiner.h) do.
Made join_pieces(const JoinJob& job);

}  // namespace polhode
