// SPDX-License-Identifier: MIT
// The measured differences of the frames of two sources, one by one and summarised, for `diff` and
// its pages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image/compare.h"

namespace polhode {

// The differences of one pair of frames.
struct FrameScore {
  int index = 0;                     // of the pair, from 0
  std::string label;                 // number or file name; "" for films and single pictures
  double time = 0.0;                 // s after the first frame, for films; else 0
  Difference values;                 // its threshold is Thresholds::max (image/verdict.h)
  std::optional<double> ssim, flip;  // mean SSIM, mean FLIP; absent: not measured
  std::string reason;                // why the frames are different; empty if they are the same
  double badness = 0.0;              // see badness() in image/verdict.h; over 1: different
};

// The differences of all frames together. `values` holds the largest difference, the mean of the
// means, the RMS over all values and the mean of the fractions.
struct DiffSummary {
  Difference values;
  std::optional<double> ssim, flip;  // least SSIM, greatest FLIP; absent: measured for no frame
  int different = 0;                 // number of frames with a reason
  std::size_t worst = 0;             // index of the score with the greatest badness
};

// The summary of at least one score.
DiffSummary summarise(const std::vector<FrameScore>& scores);

// The name of a frame for messages: "frame 12 (0.2000 s)" if `film`, else "picture 'a.png'" from
// its label; "" for a single picture.
std::string frame_name(const FrameScore& score, bool film);

}  // namespace polhode
