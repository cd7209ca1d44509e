// SPDX-License-Identifier: MIT
// Parts of a film by number, and the frames that each has.
#pragma once

#include <string>

namespace polhode {

// One of several parts of a film, numbered from 1 to `of`.
struct Shard {
  int number = 1;
  int of = 1;
};

// "2/8". Throws Error (input), naming --shard.
Shard parse_shard(const std::string& text);
std::string name_of(const Shard& shard);

// Frames of a film, from `first`.
struct FrameRange {
  int first = 0;
  int count = 0;
};

// The frames of that shard: all shards together are the film, and no two differ in length by more
// than one. Throws Error (input), naming --shard, when there are more shards than frames.
FrameRange range_of(const Shard& shard, int frames);

}  // namespace polhode
