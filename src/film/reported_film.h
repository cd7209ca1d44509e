// SPDX-License-Identifier: MIT
// From a report back to the film that it tells of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "film/render_plan.h"

namespace polhode {

struct ReportedFilm {
  RenderPlan plan;                    // with the output as it was given then
  std::string gl_renderer;            // that drew it
  std::vector<std::string> hashes;    // of all frames
  std::optional<std::string> broken;  // what contradicts itself in the report
};

// Throws Error (input) when the file is missing, is no report, or tells of other versions of what
// pixels depend on than these.
ReportedFilm read_report(const std::string& file);

}  // namespace polhode
