// SPDX-License-Identifier: MIT
// Pages on which a person judges differences: one file of HTML with everything inside, for reading
// from a disk without a network.
#pragma once

#include <string>
#include <vector>

#include "app/compare/frame_score.h"
#include "image/image.h"
#include "image/verdict.h"

namespace polhode {

// A pair of frames to be shown.
struct ShownFrame {
  FrameScore score;
  Image reference, actual;
  FlipMap flip;
  std::string title;  // plain text; may be empty
};

// The page of one comparison. Texts are plain; they are escaped here.
struct DiffPage {
  std::string actual, reference;  // names
  bool same = true;
  std::string reason;
  Thresholds thresholds;
  DiffSummary summary;
  const std::vector<FrameScore>& scores;
  const std::vector<ShownFrame>& shown;
  bool film = false;
};
std::string diff_page(const DiffPage& page);

// One case of a folder of golden pictures.
struct GoldenSection {
  std::string name;
  std::string outcome;  // "same", "different", "no reference", …
  bool good = true;
  std::string note;  // which reference, why it failed
  Thresholds thresholds;
  std::vector<ShownFrame> shown;  // none, or one
};
std::string golden_page(const std::string& title, const std::vector<GoldenSection>& sections);

}  // namespace polhode
