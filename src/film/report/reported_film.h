// SPDX-License-Identifier: MIT
// Reads a report back into the plan of its film, for `verify`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "film/render_plan.h"
#include "film/report/json_fields.h"

namespace polhode {

// The film that a report describes.
struct ReportedFilm {
  RenderPlan plan;                  // with the output as named in the report, and one job
  std::string gl_renderer;          // GL_RENDERER that drew it
  std::vector<std::string> hashes;  // frame_hash() (video/plain_sinks.h) of each frame
  // Why the report does not fit: its scene, or a mesh file that it names, has another hash now, or
  // it has another number of hashes than frames. Absent: it fits. With it, plan.range is unchecked.
  std::optional<std::string> broken;
  Json record = {};  // all that the report says
};

// Reads the report in that file. Scenes that it names, beside which their meshes are, are looked
// for where they were and then from the folder of the report. Throws Error, with the file as place:
// (input) if it is missing, not a report or longer than 1 GiB, if it was written with other
// versions() (film/report/motion_report.h), or if it has a value that no scene, option or encoder
// accepts; (environment) as settle_encoder (video/encoders.h) does.
ReportedFilm read_report(const std::string& file);

}  // namespace polhode
