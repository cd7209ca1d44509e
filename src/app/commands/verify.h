// SPDX-License-Identifier: MIT
// The command `verify`: checks that an output of `render` (film, pictures or frame hashes) is what
// its report says.
#pragma once

#include <string>

#include "base/system/progress.h"

namespace polhode {

// The options of `verify`.
struct VerifyJob {
  std::string output;  // as it was given to `render`
  std::string report;  // file; empty: the name of the output with the ending .json
  ProgressKind progress = ProgressKind::automatic;
};

// Whether the film is the same, and what the command prints.
struct Verified {
  bool same = false;  // false also if the report was altered or the output is damaged
  std::string text;   // one line: the result, with the first frame that differs and its time
};

// Renders all frames again from the report alone, compares their hashes with those of the report,
// encodes them with the same settings into a temporary folder, and compares the files or, if their
// bytes differ, the decoded frames of both value by value. Captions are compared too. Draws on the
// calling thread, with an OpenGL context of its own. Throws Error (input), with the file as place,
// if output or report is missing, if the output is standard output or a kind that writes no file,
// and if the report was written with other versions or another OpenGL renderer, on which pixels
// depend; otherwise as find_sink_kind (video/sink_kinds.h), read_report
// (film/report/reported_film.h) and render_film (app/commands/render.h) do, and (environment) as
// FilmReader and its next() (video/film_reader.h) do.
Verified verify(const VerifyJob& job);

}  // namespace polhode
