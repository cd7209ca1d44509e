// SPDX-License-Identifier: MIT
// The command `preview`: a contact sheet of a film, one picture with small frames of the
// whole film.
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
  std::string backend = "auto";  // for open_context() (render/context.h)
};

// Writes a PNG with twelve small frames, equally spaced from the first frame of the film to the
// last, each with its time. They are drawn without clock, title and motion blur. Without job.output
// it creates the folder output/. Draws on the calling thread, with an OpenGL context of its own.
// Throws Error (input) as load_with_overrides, PreparedFilm (film/prepared_film.h), open_context
// and AtomicFile (base/system/atomic_file.h) do, with the output as place unless that is a .png,
// and without a place if the output is the scene file; (environment) without OpenGL or if the file
// cannot be written; (check_failed) as simulate (motion/simulate.h) does; (interrupted).
Made write_preview(const PreviewJob& job);

}  // namespace polhode
