// SPDX-License-Identifier: MIT
// Loads a folder of golden pictures, and renders its cases.
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
  std::string cause;           // empty for the first reference
  std::filesystem::path file;  // NAME.png or NAME.CAUSE.png
  bool has_sidecar = false;
  GoldenSidecar sidecar;  // its verdict is the rule; without a sidecar, that of the case
};

// A case with its references.
struct LoadedCase {
  GoldenCase spec;
  GoldenVerdict verdict;              // the case's own or the folder's
  std::vector<Reference> references;  // the one without a cause first; may be empty
};

// The cases of DIR/cases.toml with their references. `names` (comma-separated) selects cases;
// empty: all. Throws Error (input) with the folder as place if it or its cases.toml is missing,
// with file, line and key for faults in the files, and naming --cases for an unknown name.
std::vector<LoadedCase> load_cases(const std::filesystem::path& folder, const std::string& names);

// DIR/NAME.png or DIR/NAME.CAUSE.png.
std::filesystem::path reference_file(const std::filesystem::path& folder,
                                     const std::string& name,
                                     const std::string& cause);

// The name of the picture with .toml appended: NAME.png.toml.
std::filesystem::path sidecar_file(const std::filesystem::path& reference);

// A case as rendered on this machine.
struct DrawnCase {
  Image image;
  GoldenSidecar sidecar;  // all but cause and verdict
};

// Renders a case. Temporary files go into `scratch`. Thread-safe. Throws Error as render_film does.
DrawnCase draw_case(const std::filesystem::path& folder,
                    const GoldenCase& one,
                    const std::string& backend,
                    const ScratchFolder& scratch);

}  // namespace polhode
