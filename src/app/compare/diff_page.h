// SPDX-License-Identifier: MIT
// HTML pages that show how pictures differ. Each is a single file that works
// without a network.
#pragma once

#include <string>
#include <vector>

#include "app/compare/frame_score.h"
#include "image/image.h"
#include "image/verdict.h"

namespace polhode {

// A pair of frames to show.
struct ShownFrame {
  FrameScore score;
  Image reference, actual;
  FlipMap flip;
  std::string title;  // plain text; may be empty
};

// The content of the page of one comparison. Texts are plain; diff_page() escapes them.
struct DiffPage {
  std::string actual, reference;  // names of the two sides
  bool same = true;               // the overall result
  std::string reason;             // why they differ
  Thresholds thresholds;
  DiffSummary summary;
  const std::vector<FrameScore>& scores;  // of all frames; outlives this
  const std::vector<ShownFrame>& shown;   // frames shown as pictures; outlives this
  bool film = false;                      // true: frames are labelled with their times
};
// The page as HTML.
std::string diff_page(const DiffPage& page);

// One case of golden pictures on a page. Texts are plain; golden_page() escapes them.
struct GoldenSection {
  std::string name;
  std::string outcome;  // "same", "different", "no reference", …
  bool good = true;     // whether the case passes
  std::string note;     // which reference was used, why it failed
  Thresholds thresholds;
  std::vector<ShownFrame> shown;  // empty, or one pair
};
// The page of several cases as HTML.
std::string golden_page(const std::string& title, const std::vector<GoldenSection>& sections);

}  // namespace polhode
