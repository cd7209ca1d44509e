// SPDX-License-Identifier: MIT
// The options and results of `golden run`, `golden update` and `golden show`. A folder DIR holds
// the reference pictures of scenes: DIR/cases.toml lists the cases, DIR/NAME.png is the reference
// of a case, DIR/NAME.CAUSE.png is another accepted one, and NAME.png.toml beside each says what
// drew it and how to compare.
#pragma once

#include <string>

#include "base/system/progress.h"

namespace polhode {

// The options.
struct GoldenJob {
  std::string folder;
  std::string cases;  // comma-separated names; empty: all
  std::string backend = "auto";
  int jobs = 0;  // cases rendered at the same time; 0: one per processor
  bool json = false;
  ProgressKind progress = ProgressKind::automatic;

  // run
  std::string html;                      // folder for the HTML page; empty: none
  std::string output = "output/golden";  // folder for the pictures of failed cases

  // update
  std::string cause;         // write NAME.CAUSE.png; empty: NAME.png
  bool all = false;          // also update cases that pass
  bool allow_dirty = false;  // update although the git tree has changes
};

// What the command prints, and its exit code.
struct GoldenResult {
  // 0; 1: a picture is different or has no reference; 2: a case cannot be rendered
  int exit_code = 0;
  std::string text;  // for standard output: a summary, or JSON
};

}  // namespace polhode
