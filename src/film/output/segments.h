// SPDX-License-Identifier: MIT
// The record that each segment or shard of a film carries, so that only matching ones are joined.
#pragma once

#include <map>
#include <string>

#include "film/prepared_film.h"
#include "film/render_plan.h"

namespace polhode {

// What a segment says about itself.
struct SegmentRecord {
  std::string version;  // of Polhode
  std::string ffmpeg;   // version that encoded it
  std::string scene;    // scene_hash()
  std::string title;
  std::map<std::string, std::string> settings;  // of the whole film, such as "crf": "18"
  Shard shard;
  FrameRange range;
  FilmMetadata film;  // of the whole film, without key frames
};
// The record of one shard of a film.
SegmentRecord record_of(const RenderPlan& plan,
                        const PreparedFilm& film,
                        const FilmMetadata& metadata,
                        const Shard& shard);

// Stores the record as the comment of a container. Throws Error (input), without a key, if the
// story is too long for it.
std::string comment_with(const SegmentRecord& record);
// Reads the record of a film file. Throws Error (input), with the file as place, if it is not a
// film or not a segment.
SegmentRecord record_in(const std::string& file);

// Why two segments cannot belong to the same film, such as "scenes differ"; empty if they can.
std::string difference_between(const SegmentRecord& a, const SegmentRecord& b);

// The metadata of one segment: its key frames. Chapters and captions are added when the film is
// joined.
FilmMetadata metadata_of_segment(const FilmMetadata& film, const FrameRange& range);

}  // namespace polhode
