// SPDX-License-Identifier: MIT
// The command `preview`: a contact sheet of a film.
#pragma once

#include <filesystem>
#include <string>

#include "app/made.h"
#include "film/overrides.h"

namespace polhode {

// The options of `preview`.
struct PreviewJob {
  std::filesystem::path scene;
  std::string output;  // empty: output/SCENE_preview.png
  Overrides overrides;
  std::string backend = "auto";
};

// Writes a PNG with twelve small pictures, from the first frame of the film to the last, each with
// its time. Throws Error as render_film does, and (input), with the output as place, unless it is a
// .png.
Made write_preview(const PreviewJob& job);

}  // namespace polhode
