// SPDX-License-Identifier: MIT
// How far apart the frames of two sources are, one by one and together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image/compare.h"

namespace polhode {

// One pair of frames, measured.
struct FrameScore {
  int index = 0;      // from 0
  std::string label;  // number or file name; "" where there is none
  double time = 0.0;  // s, in films
  Difference values;
  std::optional<double> ssim, flip;
  std::string reason;    // why it is different; "" when it is the same
  double badness = 0.0;  // over 1: different
};

// What the frames of two films come to: largest value, mean of means, rms of all values, mean
// share; least SSIM, greatest FLIP.
struct DiffSummary {
  Difference values;
  std::optional<double> ssim, flip;
  int different = 0;      // frames
  std::size_t worst = 0;  // index into the scores
};

// There must be a score.
DiffSummary summarise(const std::vector<FrameScore>& scores);

// "frame 12 (0.2000 s)", "picture 'a.png'", "" for a single picture.
std::string frame_name(const FrameScore& score, bool film);

}  // namespace polhode
