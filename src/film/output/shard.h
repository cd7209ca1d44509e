// SPDX-License-Identifier: MIT
// Shards of a film (--shard K/N), which are rendered separately and joined by `join`, and ranges of
// frames.
#pragma once

#include <string>

namespace polhode {

// Part `number` of `of` parts of a film, 1 <= number <= of.
struct Shard {
  int number = 1;
  int of = 1;
};

// Parses "K/N", such as "2/8". Throws Error (input), with --shard as key, for other text and unless
// 1 <= K <= N.
Shard parse_shard(const std::string& text);
// The shard as text, such as "2/8".
std::string name_of(const Shard& shard);

// Consecutive frames of a film.
struct FrameRange {
  int first = 0;  // number of the first; frames of a film count from 0
  int count = 0;
};

// The frames of a shard of a film that has `frames` frames. The shards follow each other, and their
// lengths differ by at most one frame. Throws Error (input), with --shard as key, if there are more
// shards than frames.
FrameRange range_of(const Shard& shard, int frames);

}  // namespace polhode
