// SPDX-License-Identifier: MIT
// Reads the frames of two sources in matching pairs.
#pragma once

#include <memory>

#include "video/frame_source.h"

namespace polhode {

// Reads each source on a thread of its own, at most four frames ahead. Frames are paired by number
// in two sequences, by name in two folders, and by order otherwise; in two films the times of a
// pair may differ by at most half a frame of the faster one. Use it on one thread.
class FramePairs {
 public:
  // Takes the sources over. `by_order`: pair by order, whatever the kinds and times. name_a and
  // name_b are the names of the sources for messages. Throws Error (input), with the source as
  // place, if it is already known that a frame has no partner (not for films).
  FramePairs(const std::string& name_a,
             std::unique_ptr<FrameSource> a,
             const std::string& name_b,
             std::unique_ptr<FrameSource> b,
             bool by_order = false);
  ~FramePairs();
  FramePairs(const FramePairs&) = delete;
  FramePairs& operator=(const FramePairs&) = delete;

  // The approximate number of pairs, for progress; 0: unknown.
  int count() const { return count_; }

  // Sets `a` and `b` to the next pair and reuses their buffers; returns false at the end of both.
  // Throws Error (input), with the source as place, for a frame without a partner and frames of
  // different sizes; as FrameSource::next of both sources does; (interrupted).
  bool next(SourceFrame& a, SourceFrame& b);

 private:
  class Prefetcher;
  void refuse_unlike(const SourceFrame& a, const SourceFrame& b) const;

  std::string name_a_, name_b_;
  int count_ = 0;
  int given_ = 0;
  double apart_ = 0.0;  // s: largest difference of matching times; 0: times are ignored
  std::unique_ptr<Prefetcher> a_, b_;
};

}  // namespace polhode
