// SPDX-License-Identifier: MIT
// Reads a report back into the plan of its film, for `verify`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "film/render_plan.h"

namespace polhode {

// The content of a report.
struct ReportedFilm {
  RenderPlan plan;                    // with the output as named in the report
  std::string gl_renderer;            // GL_RENDERER that drew it
  std::vector<std::string> hashes;    // frame_hash() of all frames
  std::optional<std::string> broken;  // the contradiction in the report, if there is one
};

// Throws Error (input), with the file as place, if it is missing, not a report, or was written with
// other versions of the program or the libraries that pixels depend on.
ReportedFilm read_report(const std::string& file);

}  // namespace polhode
