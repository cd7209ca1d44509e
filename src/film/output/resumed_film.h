// SPDX-License-Identifier: MIT
// Makes a film in segments, so that a run that was killed can be resumed.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/system/scratch_folder.h"
#include "film/output/render_output.h"
#include "film/output/segments.h"
#include "video/film_joiner.h"

namespace polhode {

// The folder .film.mp4.parts beside film.mp4.
std::string folder_of_pieces(const std::string& output);

// The segments of a film are in folder_of_pieces(): plan.pieces of them, else one for each five
// seconds. A segment gets its name when it is complete and sealed (video/seal.h). push() of the
// sink opens them, and also throws Error as make_sink (video/sink_kinds.h) and comment_with
// (film/output/segments.h) do. finish() joins them into the film and removes them, what killed runs
// have left in the folder and, if it is empty, the folder; it also throws Error as FilmJoiner::join
// does, and (environment) if a segment has changed or cannot be removed. Invariant: the folder
// contains segments of this film only.
//
// With plan.shard it makes only the segments that pieces_of() (film/output/shard.h) deals to the
// shard, does not claim the output, and finish() leaves them where they are. Each is made in a
// folder of this run and then moved, so that runs that make the same one do not disturb each other.
class ResumedFilm final : public RenderOutput, private FrameSink {
 public:
  // Claims the output, unless it is to make a shard. `plan` must outlive this object. Throws Error
  // (input) and (environment) as FilmJoiner and make_sink do.
  explicit ResumedFilm(const RenderPlan& plan);
  ~ResumedFilm() override;

  // Looks for segments of an earlier run, says on stderr how many are complete, and warns of
  // damaged ones, which are made again. Throws Error (input) with --resume as key if they belong to
  // another film or the folder cannot be created, with --pieces as key for more segments than
  // frames, with --shard as key for more shards than segments, and without a key if a segment's
  // name is taken by something else than a file; (interrupted).
  void begin(const PreparedFilm& film) override;
  FrameSink& sink() override { return *this; }
  SinkTimes times() const override;
  const std::vector<std::string>& hashes() const override { return hashes_; }
  // Adds to an Error (environment) or (interrupted) how many segments are kept, and where; others
  // are returned unchanged.
  Error explained(const Error& error) const override;

 private:
  void push(const Image& frame) override;
  void finish() override;
  std::string kept() const;
  std::string file_of(int number) const;
  void look_at_old_segment(int number);
  // Throws Error (input) with --resume as key if a segment that is there, also of another shard, is
  // of another film.
  void refuse_other_film() const;
  Error other_film(const std::string& difference) const;
  void open_segment(int frame);
  void collect_hashes();

  const RenderPlan& plan_;
  std::string folder_;
  std::string ending_;
  std::unique_ptr<FilmJoiner> joiner_;      // null: makes a shard
  std::unique_ptr<ScratchFolder> scratch_;  // of this run, in the folder; null: joins
  FilmMetadata metadata_;
  SegmentRecord record_;  // of the first segment
  int segments_ = 1;
  std::vector<int> numbers_;          // of the segments to be there at the end
  std::map<int, std::string> seals_;  // texts of those that are complete
  std::size_t pushed_ = 0;            // of frames_
  std::unique_ptr<FrameSink> segment_;
  int number_ = 0;           // of the open segment
  int left_in_segment_ = 0;  // frames
  SinkTimes times_;          // of the segments that are done
  std::vector<std::string> hashes_;
};

}  // namespace polhode
