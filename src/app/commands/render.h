// SPDX-License-Identifier: MIT
// The use case `render`: from a scene file to a film or a picture.
#pragma once

#include "app/made.h"
#include "film/render_plan.h"

namespace polhode {

// Throws Error; nothing half-written stays behind.
Made render_film(const RenderJob& job);

}  // namespace polhode
