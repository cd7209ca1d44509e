// SPDX-License-Identifier: MIT
// The command `diff`: compares two pictures, sequences, films or scenes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/system/progress.h"
#include "film/overrides.h"
#include "image/verdict.h"

namespace polhode {

// The options of `diff`.
struct DiffJob {
  std::string actual;     // A: the one to check
  std::string reference;  // B: the expected one
  Thresholds thresholds;
  bool json = false;
  std::string html;  // folder for the HTML page; empty: none

  // how sides that are scenes are rendered
  Overrides overrides;          // size and fps; absent: those of the other side
  std::optional<double> still;  // s of motion; absent: 0 against a picture, else the whole film
  bool text = true;             // with labels, clock, title and caption
  std::string backend = "auto";
  ProgressKind progress = ProgressKind::automatic;
};

// What the command prints, and whether the two are the same.
struct DiffResult {
  bool same = true;
  std::string text;  // for standard output: a summary, or JSON
};

// Throws Error (input) if the two cannot be compared, with the file as place: missing files,
// different sizes, frames without a partner; and naming the option for --still and others that do
// not apply. Throws Error as check_thresholds and, for scenes, as render_film do.
DiffResult diff(const DiffJob& job);

}  // namespace polhode
