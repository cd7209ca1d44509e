// SPDX-License-Identifier: MIT
// Segments of a film: which frames each has, and what it says of itself so that they can be joined.
#pragma once

#include <map>
#include <string>

#include "film/prepared_film.h"
#include "film/render_plan.h"

namespace polhode {

// What a segment says of itself.
struct SegmentRecord {
  std::string version;  // of Polhode
  std::string ffmpeg;   // that encoded it
  std::string scene;    // hash
  std::string title;
  std::map<std::string, std::string> settings;  // of the whole film: "crf" is "18"
  Shard shard;
  FrameRange range;
  FilmMetadata film;  // of the whole film; key frames are not told
};
SegmentRecord record_of(const RenderPlan& plan,
                        const PreparedFilm& film,
                        const FilmMetadata& metadata,
                        const Shard& shard);

// The record as the comment of a container, and back. Throws Error (input) for a file that is no
// film, or no segment of one.
std::string comment_with(const SegmentRecord& record);
SegmentRecord record_in(const std::string& file);

// In what two segments differ that cannot be of one film, such as "scenes differ"; empty if they
// can.
std::string difference_between(const SegmentRecord& a, const SegmentRecord& b);

// What a segment has of a film's metadata: its key frames. Chapters and captions are the whole
// film's.
FilmMetadata metadata_of_segment(const FilmMetadata& film, const FrameRange& range);

}  // namespace polhode
