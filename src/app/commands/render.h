// SPDX-License-Identifier: MIT
// The command `render`: makes a film or a picture from a scene file.
#pragma once

#include "app/made.h"
#include "film/render_plan.h"

namespace polhode {

// Makes the output, and the report if job.report names one. No partial files remain after an error,
// except the segments of --resume. Throws Error (input) as plan_render, PreparedFilm and make_sink
// do, and naming --report; (environment); (check_failed) as simulate does; (interrupted).
Made render_film(const RenderJob& job);

}  // namespace polhode
