// SPDX-License-Identifier: MIT
#include "app/commands/join.h"

#include <filesystem>
#include <map>

#include <fmt/ranges.h>

#include "base/system/overwriting.h"
#include "film/output/segments.h"
#include "video/captions.h"
#include "video/film_joiner.h"
#include "video/seal.h"

namespace polhode {
namespace {

struct Found {
  std::string file;
  SegmentRecord record;
};

// by number
using Pieces = std::map<int, Found>;

void add_piece(const std::string& file, Pieces& pieces) {
  Found found{file, record_in(file)};
  if (!sealed_text(file)) {
    throw input_error(
        "is damaged: its contents have changed since it was made; make it again with --shard {}/{}",
        found.record.shard.number,
        found.record.shard.of)
        .at({file, 0, {}});
  }
  if (!pieces.empty()) {
    const Found& first = pieces.begin()->second;
    const std::string difference = difference_between(first.record, found.record);
    if (!difference.empty()) {
      throw input_error("does not belong to '{}': {}", first.file, difference).at({file, 0, {}});
    }
  }
  const int number = found.record.shard.number;
  const auto [place, is_new] = pieces.emplace(number, std::move(found));
  if (is_new) return;
  throw input_error("is shard {}, and so is '{}'", number, place->second.file).at({file, 0, {}});
}

// "shards 2 and 5 of 8 are missing"
void refuse_missing(const Pieces& pieces) {
  const int of = pieces.begin()->second.record.shard.of;
  std::vector<std::string> missing;
  for (int number = 1; number <= of; ++number) {
    if (!pieces.contains(number)) missing.push_back(std::to_string(number));
  }
  if (missing.empty()) return;
  if (missing.size() == 1) throw input_error("shard {} of {} is missing", missing[0], of);
  const std::string last = missing.back();
  missing.pop_back();
  throw input_error("shards {} and {} of {} are missing", fmt::join(missing, ", "), last, of);
}

void refuse_other_ending(const JoinJob& job) {
  const std::filesystem::path part(job.parts.front());
  const std::filesystem::path output(job.output);
  if (part.extension() == output.extension()) return;
  throw input_error("must have the ending of its pieces, {}: joining does not encode again",
                    part.extension().string())
      .at({job.output, 0, {}});
}

}  // namespace

Made join_pieces(const JoinJob& job) {
  Pieces pieces;
  const std::vector<std::filesystem::path> inputs(job.parts.begin(), job.parts.end());
  refuse_same_file(job.output, "the output", inputs);
  refuse_same_file(captions_beside(job.output), "its captions", inputs);
  for (const std::string& file : job.parts)
    add_piece(file, pieces);
  refuse_missing(pieces);
  refuse_other_ending(job);

  std::vector<FilmJoiner::Part> parts;
  for (const auto& [number, found] : pieces) {
    parts.push_back({found.file, found.record.range.count});
  }
  const SegmentRecord& record = pieces.begin()->second.record;
  FilmJoiner joiner(job.output);
  joiner.join(parts,
              parse_frame_rate(record.settings.at("fps")),
              record.title,
              film_comment(record.version, record.scene),
              record.film);
  Made made;
  made.output = job.output;
  made.parts = static_cast<int>(parts.size());
  for (const FilmJoiner::Part& part : parts) {
    made.frames += part.frames;
  }
  return made;
}

}  // namespace polhode
