// SPDX-License-Identifier: MIT
// What `golden run`, `update` and `show` are asked: a folder of pictures that scenes must go on
// looking like. DIR/cases.toml lists them; DIR/NAME.png is the reference of a case,
// DIR/NAME.CAUSE.png another that is accepted as well, and NAME.png.toml beside each tells what
// drew it and how to compare.
#pragma once

#include <string>

#include "base/system/progress.h"

namespace polhode {

struct GoldenJob {
  std::string folder;
  std::string cases;  // names with commas between; empty: all
  std::string backend = "auto";
  int jobs = 0;  // cases at a time; 0: one per processor
  bool json = false;
  ProgressKind progress = ProgressKind::automatic;

  // run
  std::string html;                      // folder for the page; empty: none
  std::string output = "output/golden";  // where failures leave their pictures

  // update
  std::string cause;         // writes NAME.CAUSE.png; empty: NAME.png
  bool all = false;          // also what is within its thresholds
  bool allow_dirty = false;  // though the git tree holds changes
};

struct GoldenResult {
  int exit_code = 0;  // 0; 1: a picture is different or has no reference; 2: a case cannot be drawn
  std::string text;   // for standard output: words, or JSON
};

}  // namespace polhode
