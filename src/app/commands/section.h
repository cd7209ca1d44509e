// SPDX-License-Identifier: MIT
// The command `section`: the Poincaré section of a heavy body.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/system/progress.h"
#include "scene/setting.h"

namespace polhode {

// The options of `section`.
struct SectionJob {
  std::filesystem::path scene;
  std::vector<Setting> settings;
  std::string output;   // folder, created if needed; empty: output/SCENE_section
  int starts = 60;      // beside that of the scene, 1 to 10,000
  int crossings = 500;  // of each motion, 1 to 100,000; at most 1e7 of all
  int jobs = 0;         // threads; 0: one per processor
  ProgressKind progress = ProgressKind::automatic;
};

// Writes section.csv and section.png into the folder, together at the end. If it is interrupted or
// fails, finished motions are kept there in section.resume for the next run with the same options.
// Returns a summary of a few lines. Throws Error (input) as load_single (film/solved_scene.h),
// make_model, start_state, OutputFolder and KeptRows do, with --starts or --crossings as key for a
// number out of range, and without a key if the scene has no section; (check_failed) as
// trace_section (chart/section.h) does; (environment) without gnuplot or if a file cannot be
// written; (interrupted).
std::string section(const SectionJob& job);

}  // namespace polhode
