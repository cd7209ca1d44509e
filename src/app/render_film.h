// SPDX-License-Identifier: MIT
// The use case `render`: from a scene file to a film or a picture.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/load.h"
#include "app/progress.h"
#include "video/video_spec.h"

namespace polhode {

// Named settings of picture and encoder.
struct Quality {
  std::string name;
  std::string doc;
  int shrink = 1;                // the picture's sides are divided by this
  std::string preset;            // effort, one of encoder_presets()
  Grade grade = Grade::lecture;  // the codec's own constant rate factor and pixels
};
const std::vector<Quality>& qualities();

struct RenderJob {
  std::filesystem::path scene;
  std::string output;  // empty: output/SCENE.mp4
  Overrides overrides;
  std::optional<double> from;   // s of the motion; absent: 0
  std::optional<double> to;     // s; absent: the whole motion
  std::optional<double> still;  // s; one picture
  std::string quality = "lecture";
  std::optional<std::string> codec;
  std::optional<std::string> preset;
  std::optional<int> crf;
  std::string backend = "auto";
  bool transparent = false;
  bool text = true;    // false: no labels, clock, title or caption
  std::string report;  // file for the JSON report; empty: none
  ProgressKind progress = ProgressKind::automatic;
};

// Throws Error; nothing half-written stays behind.
void render_film(const RenderJob& job);

}  // namespace polhode
