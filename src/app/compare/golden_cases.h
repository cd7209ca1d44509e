// SPDX-License-Identifier: MIT
// Loads a folder of golden pictures (described in app/compare/golden_job.h), and renders its cases.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/system/scratch_folder.h"
#include "image/image.h"
#include "scene/golden_file.h"

namespace polhode {

// An accepted picture of a case.
struct Reference {
  std::string cause;           // CAUSE in its name; empty for NAME.png
  std::filesystem::path file;  // NAME.png or NAME.CAUSE.png
  bool has_sidecar = false;    // whether NAME.png.toml exists
  GoldenSidecar sidecar;       // default if there is none; then LoadedCase::verdict holds
};

// A case with its references.
struct LoadedCase {
  GoldenCase spec;
  GoldenVerdict verdict;              // thresholds: the case's own, else those of the folder
  std::vector<Reference> references;  // by cause, the one without a cause first; may be empty
};

// The cases of `folder`/cases.toml, in that order, with their references, whose pixels are not read
// yet. `names` (separated by commas) selects cases; empty: all. Throws Error (input) with the
// folder as place if it or its cases.toml is missing, with file, line and key for faults in
// cases.toml or a sidecar, and with --cases as key for an unknown name.
std::vector<LoadedCase> load_cases(const std::filesystem::path& folder, const std::string& names);

// The file of a reference: `folder`/NAME.png, or `folder`/NAME.CAUSE.png if `cause` is not empty.
// It need not exist.
std::filesystem::path reference_file(const std::filesystem::path& folder,
                                     const std::string& name,
                                     const std::string& cause);

// The sidecar file of a reference picture: its name with .toml appended, NAME.png.toml.
std::filesystem::path sidecar_file(const std::filesystem::path& reference);

// The files that the scenes of the cases are read from, as far as these can be read.
std::vector<std::filesystem::path> scene_files(const std::filesystem::path& folder,
                                               const std::vector<LoadedCase>& cases);

// A case as rendered on this machine.
struct DrawnCase {
  Image image;
  GoldenSidecar sidecar;  // what drew it; cause and verdict are not set
};

// Renders the case `one` of `folder`. `backend` is for open_context() (render/context.h). Temporary
// files, named after the case, go into `scratch`. Different cases may be drawn on several threads
// at once. Throws Error as render_film (app/commands/render.h), read_png (image/png.h) and
// read_file (base/system/atomic_file.h) do.
DrawnCase draw_case(const std::filesystem::path& folder,
                    const GoldenCase& one,
                    const std::string& backend,
                    const ScratchFolder& scratch);

}  // namespace polhode
