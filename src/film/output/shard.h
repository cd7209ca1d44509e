// SPDX-License-Identifier: MIT
// Shards of a film (--shard K/N) and ranges of frames.
#pragma once

#include <string>

namespace polhode {

// Part `number` (from 1) of `of` parts of a film.
struct Shard {
  int number = 1;
  int of = 1;
};

// Parses "2/8". Throws Error (input), naming --shard, for other text.
Shard parse_shard(const std::string& text);
// "2/8".
std::string name_of(const Shard& shard);

// Consecutive frames of a film, beginning with `first`.
struct FrameRange {
  int first = 0;
  int count = 0;
};

// The frames of a shard of a film with that many frames. The lengths of shards differ by at most
// one. Throws Error (input), naming --shard, if there are more shards than frames.
FrameRange range_of(const Shard& shard, int frames);

}  // namespace polhode
