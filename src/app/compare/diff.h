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
  std::string actual;     // the side to check: a name for open_frames(), or a scene (.toml)
  std::string reference;  // the expected side, likewise
  Thresholds thresholds;
  bool json = false;  // true: the result is JSON, with the numbers of every frame
  std::string html;   // folder for the HTML page index.html; empty: none

  // The members below say how sides that are scenes are rendered. Such a side has no background if
  // the other side is a picture or sequence whose first frame has alpha.

  // An absent size is that of the other side, unless that is a scene. An absent fps is that of the
  // other side if it is a film. Otherwise the scene's own values are used.
  Overrides overrides;
  std::optional<double> still;   // s of motion, for one picture; absent: 0 against a picture or a
                                 // scene, else the whole film
  bool text = true;              // with labels, clock, title and caption
  std::string backend = "auto";  // for open_context() (render/context.h)
  ProgressKind progress = ProgressKind::automatic;
};

// What the command prints, and whether the two are the same.
struct DiffResult {
  bool same = true;  // whether no frame exceeds the thresholds
  std::string text;  // for standard output: a summary, or JSON
};

// Compares the two sides frame by frame; scenes are first rendered into a temporary folder. Writes
// the HTML page if it is asked for. Throws Error (input) with the file as place if the sides cannot
// be compared (missing or damaged file, different sizes, frames without a partner, no frames), and
// with the option as key for --still, --size or --fps without a scene, --still against a film or a
// sequence, and an --html folder that cannot be made. Throws Error as check_thresholds
// (image/verdict.h), open_frames (video/frame_source.h), FramePairs::next
// (app/compare/frame_pairs.h) and, for scenes, render_film (app/commands/render.h) do;
// (environment) also if the page cannot be written or there is no temporary folder.
DiffResult diff(const DiffJob& job);

}  // namespace polhode
