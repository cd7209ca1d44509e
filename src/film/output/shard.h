// SPDX-License-Identifier: MIT
// Shards of work (--shard K/N), which are made separately: ranges of the frames of a film, which
// `join` joins, and pieces that are dealt out.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace polhode {

// Part `number` of `of` parts, 1 <= number <= of.
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

// The pieces of a shard of work that consists of `pieces` pieces, numbered from 0. They are dealt
// out in turn, so that shards take about as long where the cost changes slowly from piece to piece.
// Without a shard they are all. Throws Error (input), with --shard as key, if there are more shards
// than pieces; `things` names these in the message ("rows").
std::vector<long> pieces_of(const std::optional<Shard>& shard,
                            long pieces,
                            const std::string& things);

}  // namespace polhode
