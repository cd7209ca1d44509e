// SPDX-License-Identifier: MIT
// Makes a film in segments, so that a run that was killed can be resumed.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "film/output/render_output.h"
#include "film/output/segments.h"
#include "video/film_joiner.h"

namespace polhode {

// The folder .film.mp4.parts beside film.mp4.
std::string folder_of_pieces(const std::string& output);

// The segments of a film are in folder_of_pieces(), each about five seconds
// long. A segment gets its name when it is complete and sealed (video/seal.h). push() of the sink
// opens them, and also throws Error as make_sink (video/sink_kinds.h) and comment_with
// (film/output/segments.h) do. finish() joins them into the film and removes them and, if it is
// empty, the folder; it also throws Error as FilmJoiner::join does, and (environment) if a segment
// has changed or cannot be removed. Invariant: the folder contains segments of this film only.
class ResumedFilm final : public RenderOutput, private FrameSink {
 public:
  // Claims the output. `plan` must outlive this object. Throws Error (input) and (environment) as
  // FilmJoiner and make_sink do.
  explicit ResumedFilm(const RenderPlan& plan);
  ~ResumedFilm() override;

  // Looks for segments of an earlier run, says on stderr how many are complete, and warns of
  // damaged ones, which are made again. Throws Error (input) with --resume as key if they belong to
  // another film or the folder cannot be created, and without a key if a segment's name is taken by
  // something else than a file; (interrupted).
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
  bool is_whole(int number) const;
  void look_at_old_segments();
  void open_segment(int frame);
  void collect_hashes();

  const RenderPlan& plan_;
  std::string folder_;
  std::string ending_;
  FilmJoiner joiner_;
  FilmMetadata metadata_;
  SegmentRecord record_;  // of the first segment
  int segments_ = 1;
  std::size_t pushed_ = 0;  // of frames_
  std::unique_ptr<FrameSink> segment_;
  int left_in_segment_ = 0;  // frames
  int whole_ = 0;            // segments
  SinkTimes times_;          // of the segments that are done
  std::vector<std::string> hashes_;
};

}  // namespace polhode
