// SPDX-License-Identifier: MIT
// The measured differences of frames, one by one and summarised.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image/compare.h"

namespace polhode {

// The differences of one pair of frames.
struct FrameScore {
  int index = 0;      // from 0
  std::string label;  // number or file name; may be empty
  double time = 0.0;  // s, for films
  Difference values;
  std::optional<double> ssim, flip;
  std::string reason;    // why it is different; empty if it is the same
  double badness = 0.0;  // see badness(); over 1: different
};

// The differences of all frames: largest difference, mean of means, rms over all values, mean
// share; least SSIM, greatest FLIP.
struct DiffSummary {
  Difference values;
  std::optional<double> ssim, flip;
  int different = 0;      // number of frames
  std::size_t worst = 0;  // index into the scores
};

// Summarises at least one score.
DiffSummary summarise(const std::vector<FrameScore>& scores);

// "frame 12 (0.2000 s)", "picture 'a.png'", "" for a single picture.
std::string frame_name(const FrameScore& score, bool film);

}  // namespace polhode
