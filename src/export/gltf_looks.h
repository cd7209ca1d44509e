// SPDX-License-Identifier: MIT
// Materials and meshes of a glTF document, each once.
#pragma once

#include <string>

#include "export/gltf_document.h"

namespace polhode {

// "#rrggbb" of a colour that is sRGB-encoded, 0..1.
std::string hex(const glm::vec3& color);

// The index of a material in the document, which gets it, under that name, if it has none like it.
int material_in(GltfDocument& document,
                const Material& look,
                bool both_sides,
                const std::string& name);

// Paints the marks of a body, as mark_picture() (export/mark_picture.h) does; null: nobody does.
using PaintMarks = std::string (*)(const Material& look, double reach);

// The index of a mesh with that material likewise. A marked body gets its marks as a texture.
// Throws Error (environment) as `paint` does.
int mesh_in(GltfDocument& document, const MeshPtr& mesh, int material, PaintMarks paint);

}  // namespace polhode
