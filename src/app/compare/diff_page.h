// SPDX-License-Identifier: MIT
// HTML pages that show how pictures differ, for `diff --html` and `golden run --html`. Each is a
// single file that works without a network.
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
  Image reference, actual;  // of the same size
  FlipMap flip;             // of these two
  std::string title;        // plain text, for diff_page(); may be empty
};

// The content of the page of one comparison. Texts are plain; diff_page() escapes them.
struct DiffPage {
  std::string actual, reference;          // names of the two sides
  bool same = true;                       // the overall result
  std::string reason;                     // why they differ; empty if they are the same
  Thresholds thresholds;                  // that were applied
  DiffSummary summary;                    // of `scores`
  const std::vector<FrameScore>& scores;  // of all frames; must outlive this struct
  const std::vector<ShownFrame>& shown;   // frames to show as pictures; must outlive this struct
  bool film = false;                      // true: frames are labelled with their times
};
// The page as HTML. Throws Error (environment) if a picture cannot be encoded.
std::string diff_page(const DiffPage& page);

// One case of golden pictures (app/compare/golden_job.h) on a page. Texts are plain; golden_page()
// escapes them.
struct GoldenSection {
  std::string name;
  std::string outcome;            // CaseResult::outcome() (app/compare/golden_results.h)
  bool good = true;               // whether the case passes
  std::string note;               // why it fails; may be empty
  Thresholds thresholds;          // that were applied
  std::vector<ShownFrame> shown;  // empty, or one pair
};
// The page of several cases as HTML; `title` is plain text. Throws Error (environment) if a picture
// cannot be encoded.
std::string golden_page(const std::string& title, const std::vector<GoldenSection>& sections);

}  // namespace polhode
