// SPDX-License-Identifier: MIT
// The use case `preview`: a film at a glance.
#pragma once

#include <filesystem>
#include <string>

#include "app/made.h"
#include "film/overrides.h"

namespace polhode {

struct PreviewJob {
  std::filesystem::path scene;
  std::string output;  // empty: output/SCENE_preview.png
  Overrides overrides;
  std::string backend = "auto";
};

// A sheet of twelve small pictures, from the first frame of the film to its last, each with its
// time. Throws Error as render_film does.
Made write_preview(const PreviewJob& job);

}  // namespace polhode
