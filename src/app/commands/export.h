// SPDX-License-Identifier: MIT
// The command `export`: writes what a film shows, and how it moves, as binary glTF.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/system/progress.h"
#include "export/gltf_scene.h"
#include "film/overrides.h"

namespace polhode {

// The options of `export`.
struct ExportJob {
  std::filesystem::path scene;
  std::string output;  // a .glb file, or "-" for standard output
  Overrides overrides;
  std::optional<double> from, to;  // s of motion; absent: start and end of the motion
  std::string author, licence;     // for the file's notices; empty: none
  ProgressKind progress = ProgressKind::none;
};

// What was written.
struct Exported {
  std::string output;
  std::size_t bytes = 0;
  ExportReport report;
};

// The bytes of the file, and what was found. Overrides::accuracy counts for playback too. Throws
// Error as check_time_range (film/frame_times.h), solve (film/solved_scene.h), export_scene and
// glb_of do.
struct GlbFile {
  std::string bytes;
  ExportReport report;
};
GlbFile glb_of_scene(const Scene& scene, const ExportJob& job);

// Writes the file. Throws Error as load_single and glb_of_scene do; (input) for an output that is
// an input file, has another ending than .glb, or cannot be written; (environment) if writing
// fails.
Exported write_glb(const ExportJob& job);

}  // namespace polhode
