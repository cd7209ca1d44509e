// SPDX-License-Identifier: MIT
// The command `render`: makes a film or a picture from a scene file.
#pragma once

#include "app/divided_work.h"
#include "app/made.h"
#include "film/render_plan.h"

namespace polhode {

// Makes the output, and the report if job.report names one. No partial files remain after an error,
// except the finished segments of a film made with --resume. With one job it draws on the calling
// thread, with an OpenGL context of its own, and may run on several threads at once for different
// outputs; with more jobs it forks, see open_frame_renderer() (film/frame_workers.h). Throws Error
// (input) as plan_render, open_output (film/output/open_output.h), RenderOutput::begin,
// PreparedFilm (film/prepared_film.h), open_frame_renderer and, for the report, AtomicFile
// (base/system/atomic_file.h) do, with --report as key for a report on standard output beside the
// film, and without a place for an output or report that would overwrite the scene or each other;
// (environment) if a program, library, memory or disk space is missing; (check_failed) as simulate
// (motion/simulate.h) does; (interrupted).
//
// With job.resume and job.shard it only makes a part of the pieces, and no report: the run without
// job.shard joins them and writes it. It also throws Error (input) as refuse_other_work()
// (app/piecewise.h) does.
Made render_film(const RenderJob& job);

// The same work in pieces before it is begun, whatever job.resume says; job.pieces, if absent, are
// chosen by the measured cost. Throws Error as render_film() does.
DividedWork divided_film(RenderJob job);

}  // namespace polhode
