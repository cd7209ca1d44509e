// SPDX-License-Identifier: MIT
// A film that is made in pieces which a killed run leaves behind for the next one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "film/segments.h"
#include "video/film_joiner.h"

namespace polhode {

// For film.mp4 the pieces stand in .film.mp4.parts/, each some seconds long, named when it is
// whole, and sealed. finish() joins them and removes the folder. Invariant: the folder holds pieces
// of this film only.
class ResumedFilm final : public FrameSink {
 public:
  // Claims the output. Throws Error as make_sink does.
  explicit ResumedFilm(const RenderPlan& plan);
  ~ResumedFilm() override;

  // What remains of an earlier run is looked at. Throws Error (input) when it is of another film.
  void begin(const PreparedFilm& film, const FilmMetadata& metadata);
  // The frames that are still to be pushed, in this order.
  const std::vector<int>& missing() const { return missing_; }

  void push(const Image& frame) override;
  void finish() override;
  SinkTimes times() const override;

  // Hashes of all frames; after finish().
  const std::vector<std::string>& hashes() const { return hashes_; }
  // "3 of 10 pieces are kept in …", for a run that ends early.
  std::string kept() const;

 private:
  std::string file_of(int number) const;
  bool is_whole(int number) const;
  void look_at_old_pieces();
  void open_piece(int frame);
  void collect_hashes();

  const RenderPlan& plan_;
  std::string folder_;
  std::string ending_;
  FilmJoiner joiner_;
  FilmMetadata metadata_;
  SegmentRecord record_;  // of the first piece
  int pieces_ = 1;
  std::vector<int> missing_;
  std::size_t pushed_ = 0;  // of missing_
  std::unique_ptr<FrameSink> piece_;
  int left_in_piece_ = 0;  // frames
  int whole_ = 0;          // pieces
  SinkTimes times_;        // of the pieces that are done
  std::vector<std::string> hashes_;
};

}  // namespace polhode
