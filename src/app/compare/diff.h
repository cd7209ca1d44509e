// SPDX-License-Identifier: MIT
// The use case `diff`: are two pictures, sequences, films or scenes the same to the eye?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/system/progress.h"
#include "film/load.h"
#include "image/verdict.h"

namespace polhode {

struct DiffJob {
  std::string actual;     // A: what was made
  std::string reference;  // B: what it should look like
  Thresholds thresholds;
  bool json = false;
  std::string html;  // folder for the page; empty: none

  // how scenes are drawn
  Overrides overrides;          // size, fps; absent: those of the other side
  std::optional<double> still;  // s; absent: 0 against a picture, the whole film otherwise
  bool text = true;
  std::string backend = "auto";
  ProgressKind progress = ProgressKind::automatic;
};

struct DiffResult {
  bool same = true;
  std::string text;  // for standard output: words, or JSON
};

// Throws Error (input) when the two cannot be compared: a missing file, other sizes, frames
// without partner.
DiffResult diff(const DiffJob& job);

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
