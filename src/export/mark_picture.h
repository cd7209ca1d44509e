// SPDX-License-Identifier: MIT
// The marks of a body as a texture.
#pragma once

#include <string>

#include "frame/draw_list.h"

namespace polhode {

// The strip and the darker half of a body, as the shader paints them (shaders/scene.frag), over the
// square of the half-width `reach` in x and y of the mesh, as PNG. Throws Error (environment) as
// encode_png (image/png.h) does.
std::string mark_picture(const Material& look, double reach);

}  // namespace polhode
