// SPDX-License-Identifier: MIT
// The options and results of `golden run`, `golden update` and `golden show`. A folder DIR holds
// the reference (golden) pictures of scenes: DIR/cases.toml lists the cases, DIR/NAME.png is the
// reference of a case, DIR/NAME.CAUSE.png is another accepted one (CAUSE, such as mesa-25, says why
// it differs), and the sidecar file NAME.png.toml or NAME.CAUSE.png.toml beside each says what drew
// it and how to compare with it. NAME and CAUSE consist of letters, digits, _ and -.
#pragma once

#include <string>

#include "base/system/progress.h"

namespace polhode {

// The options. `golden show` uses only folder, cases and json.
struct GoldenJob {
  std::string folder;            // DIR
  std::string cases;             // names of cases, separated by commas; empty: all
  std::string backend = "auto";  // for open_context() (render/context.h)
  int jobs = 0;                  // cases rendered at the same time; 0: one per processor
  bool json = false;             // true: the result is JSON
  ProgressKind progress = ProgressKind::automatic;

  // for `golden run` only
  std::string html;                      // folder for the HTML page; empty: none
  std::string output = "output/golden";  // folder for the pictures of failed cases

  // for `golden update` only
  std::string cause;         // CAUSE: write NAME.CAUSE.png; empty: write NAME.png
  bool all = false;          // also update cases that pass
  bool allow_dirty = false;  // update even if the git tree has uncommitted changes
};

// What the command prints, and its exit code.
struct GoldenResult {
  // of `golden run`: 0: all cases pass; 1: a picture is different or has no reference; 2: a case
  // cannot be rendered or its references cannot be read. Of the other two it is 0.
  int exit_code = 0;
  std::string text;  // for standard output: a summary, or JSON
};

}  // namespace polhode
