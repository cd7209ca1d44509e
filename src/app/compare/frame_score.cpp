// SPDX-License-Identifier: MIT
#include "app/compare/frame_score.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace polhode {

std::string frame_name(const FrameScore& score, bool film) {
  if (film) return fmt::format("frame {} ({:.4f} s)", score.index, score.time);
  return score.label.empty() ? "" : fmt::format("picture '{}'", score.label);
}

DiffSummary summarise(const std::vector<FrameScore>& scores) {
  DiffSummary summary;
  double mean = 0.0, squares = 0.0, over = 0.0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const FrameScore& score = scores[i];
    summary.values.largest = std::max(summary.values.largest, score.values.largest);
    summary.values.values = std::max(summary.values.values, score.values.values);
    mean += score.values.mean;
    squares += score.values.rms * score.values.rms;
    over += score.values.fraction_over;
    if (score.ssim) summary.ssim = std::min(summary.ssim.value_or(1.0), *score.ssim);
    if (score.flip) summary.flip = std::max(summary.flip.value_or(0.0), *score.flip);
    summary.different += score.reason.empty() ? 0 : 1;
    if (score.badness > scores[summary.worst].badness) summary.worst = i;
  }
  const auto count = static_cast<double>(scores.size());
  summary.values.mean = mean / count;
  summary.values.rms = std::sqrt(squares / count);
  summary.values.fraction_over = over / count;
  return summary;
}

}  // namespace polhode
