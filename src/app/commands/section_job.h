// SPDX-License-Identifier: MIT
// What `section` is asked for, and the motion that it begins with.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/piecewise.h"
#include "base/system/progress.h"
#include "model/body_model.h"
#include "scene/scene.h"
#include "scene/setting.h"

namespace polhode {

// The keys of a map and what their values are, see app/commands/map_options.h.
struct SectionMapAxes {
  std::string x, y;
  std::optional<std::string> x_range, y_range;
  std::string cells = "32x32";
};

// The options of `section`.
struct SectionJob {
  std::filesystem::path scene;
  std::vector<Setting> settings;
  std::string output;                 // folder, created if needed; empty: output/SCENE_section
  int starts = 60;                    // beside that of the scene, 1 to 10,000
  int crossings = 500;                // of each motion, 1 to 100,000; at most 1e7 of all
  std::optional<SectionMapAxes> map;  // set: a map instead of a section (section_map())
  int jobs = 0;                       // threads; 0: one per processor
  PartOptions part;
  ProgressKind progress = ProgressKind::automatic;
};

// The cost of a motion goes with its crossings, and is measured on so many of them.
inline constexpr int kSampledCrossings = 40;

// The body and the start of a scene. Throws Error (input) as make_model and start_state do, and
// with the key that keeps the scene from having a section.
std::pair<BodyModel, State> start_of_section(const Scene& scene);

}  // namespace polhode
