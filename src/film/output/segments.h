// SPDX-License-Identifier: MIT
// The record that each part of a film carries, so that only matching parts are joined. The parts
// are shards (--shard K/N) or the segments of --resume, which are the same thing.
#pragma once

#include <map>
#include <string>

#include "film/prepared_film.h"
#include "film/render_plan.h"

namespace polhode {

// What a part says about itself and about its film.
struct SegmentRecord {
  std::string version;                          // program_version() (base/version.h)
  std::string ffmpeg;                           // version of FFmpeg that encoded it
  std::string scene;                            // scene_hash() (scene/scene.h)
  std::string title;                            // of the film
  std::map<std::string, std::string> settings;  // of the whole film, such as "crf": "18"; always
                                                // with "fps", which parse_frame_rate() can read
  Shard shard;                                  // which part it is
  FrameRange range;                             // its frames, numbered as in the whole film
  FilmMetadata film;  // of the whole film: frames, chapters, captions; key frames are not stored
};
// Everything that the frames and their encoding depend on, as one text; not into how many parts the
// film is divided.
std::string words_of_film(const RenderPlan& plan);

// The record of one shard of a film; `metadata` is that of the whole film. Throws Error (input) as
// range_of does.
SegmentRecord record_of(const RenderPlan& plan,
                        const PreparedFilm& film,
                        const FilmMetadata& metadata,
                        const Shard& shard);

// The record as text, to be stored as the comment of a container: film_comment()
// (film/render_plan.h), followed by JSON. Throws Error (input), without a place, if it is longer
// than 60000 bytes, which is so if the story has too much text.
std::string comment_with(const SegmentRecord& record);
// The record in such a comment. Throws Error (input), without a place, if it has none, one that
// lacks a key (the message names it), or one that contradicts itself.
SegmentRecord parse_record(const std::string& comment);
// The record in the comment of a film file. Throws Error (input), with the file as place, if it is
// missing, not a film, or not a part of one.
SegmentRecord record_in(const std::string& file);

// Why two parts cannot belong to the same film, such as "scenes differ"; empty if they can. Title,
// chapters and captions are not compared.
std::string difference_between(const SegmentRecord& a, const SegmentRecord& b);

// The metadata for the sink of one part: the number of its frames, and its key frames counted from
// its first frame. Chapters and captions are added when the film is joined.
FilmMetadata metadata_of_segment(const FilmMetadata& film, const FrameRange& range);

}  // namespace polhode
