// SPDX-License-Identifier: MIT
// The use case `diff`: are two pictures, sequences, films or scenes the same to the eye?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/system/progress.h"
#include "film/overrides.h"
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

}  // namespace polhode
