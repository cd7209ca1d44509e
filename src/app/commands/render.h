// SPDX-License-Identifier: MIT
// The use case `render`: from a scene file to a film or a picture.
#pragma once

#include "film/render_plan.h"

namespace polhode {

// Throws Error; nothing half-written stays behind.
void render_film(const RenderJob& job);

}  // namespace polhode
