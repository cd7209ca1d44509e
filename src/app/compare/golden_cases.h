// SPDX-License-Identifier: MIT
// A folder of golden pictures as values, and how a case of it is drawn.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/system/scratch_folder.h"
#include "image/image.h"
#include "scene/golden_file.h"

namespace polhode {

// A picture that a case may look like.
struct Reference {
  std::string cause;           // "" for the first
  std::filesystem::path file;  // NAME.png or NAME.CAUSE.png
  bool has_sidecar = false;
  GoldenSidecar sidecar;  // its verdict is the rule; without a sidecar, the case's
};

struct LoadedCase {
  GoldenCase spec;
  GoldenVerdict verdict;              // its own or the folder's
  std::vector<Reference> references;  // the one without a cause first; may be empty
};

// The cases of DIR/cases.toml with their references; `names` with commas between chooses some of
// them. Throws Error (input) for a missing folder, a wrong file, an unknown name.
std::vector<LoadedCase> load_cases(const std::filesystem::path& folder, const std::string& names);

// DIR/NAME.png or DIR/NAME.CAUSE.png
std::filesystem::path reference_file(const std::filesystem::path& folder,
                                     const std::string& name,
                                     const std::string& cause);

// The picture's own name with .toml behind it, which no scene has.
std::filesystem::path sidecar_file(const std::filesystem::path& reference);

// A case as this machine draws it.
struct DrawnCase {
  Image image;
  GoldenSidecar sidecar;  // all but cause and verdict
};

// Throws Error. Files of its own go into the scratch folder. May run on several threads at once.
DrawnCase draw_case(const std::filesystem::path& folder,
                    const GoldenCase& one,
                    const std::string& backend,
                    const ScratchFolder& scratch);

}  // namespace polhode
