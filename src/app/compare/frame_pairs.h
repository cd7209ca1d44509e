// SPDX-License-Identifier: MIT
// The frames of two sources, side by side.
#pragma once

#include <memory>

#include "video/frame_source.h"

namespace polhode {

// Reads both sources on threads of their own, a few frames ahead. Frames belong together by the
// time they are shown at in two films, by number in two sequences, by name in two folders, by
// their order otherwise.
class FramePairs {
 public:
  // `by_order`: pair by order whatever the kinds are. Throws Error (input) when it is known now
  // that a frame has no partner, naming it.
  FramePairs(const std::string& name_a,
             std::unique_ptr<FrameSource> a,
             const std::string& name_b,
             std::unique_ptr<FrameSource> b,
             bool by_order = false);
  ~FramePairs();
  FramePairs(const FramePairs&) = delete;
  FramePairs& operator=(const FramePairs&) = delete;

  // About how many pairs there will be; 0: not known.
  int count() const { return count_; }

  // False at the end of both. The buffers are used again. Throws Error (input) for a frame without
  // partner, frames of different sizes, and what cannot be read.
  bool next(SourceFrame& a, SourceFrame& b);

 private:
  class Prefetcher;
  void refuse_unlike(const SourceFrame& a, const SourceFrame& b) const;

  std::string name_a_, name_b_;
  int count_ = 0;
  int given_ = 0;
  double apart_ = 0.0;  // s: how far times may be apart; 0: they do not count
  std::unique_ptr<Prefetcher> a_, b_;
};

}  // namespace polhode
