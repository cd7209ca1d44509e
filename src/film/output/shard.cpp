// SPDX-License-Identifier: MIT
#include "film/output/shard.h"

#include <cstdint>

#include "base/error.h"
#include "base/numbers.h"

namespace polhode {

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  std::optional<int> number, of;
  if (slash != std::string::npos) {
    number = parse_integer(text.substr(0, slash));
    of = parse_integer(text.substr(slash + 1));
  }
  if (!number || !of) {
    throw input_error("must be K/N, such as 2/8 for the second of eight pieces; found '{}'",
                      text.substr(0, 40))
        .at({{}, 0, "--shard"});
  }
  if (*of < 1 || *number < 1 || *number > *of) {
    throw input_error("K/N must have K from 1 to N, got {}/{}", *number, *of)
        .at({{}, 0, "--shard"});
  }
  return {*number, *of};
}

std::string name_of(const Shard& shard) {
  return fmt::format("{}/{}", shard.number, shard.of);
}

FrameRange range_of(const Shard& shard, int frames) {
  if (shard.of > frames) {
    throw input_error(
        "the film has only {} frames; make at most that many pieces, not {}", frames, shard.of)
        .at({{}, 0, "--shard"});
  }
  const auto begin = [&](std::int64_t k) {
    return static_cast<int>(k * frames / shard.of);
  };
  const int first = begin(shard.number - 1);
  return {first, begin(shard.number) - first};
}

std::vector<long> pieces_of(const std::optional<Shard>& shard,
                            long pieces,
                            const std::string& things) {
  const Shard part = shard.value_or(Shard{});
  if (shard && part.of > pieces) {
    throw input_error(
        "there are only {} {}; make at most that many parts, not {}", pieces, things, part.of)
        .at({{}, 0, "--shard"});
  }
  std::vector<long> mine;
  for (long i = part.number - 1; i < pieces; i += part.of)
    mine.push_back(i);
  return mine;
}

}  // namespace polhode
