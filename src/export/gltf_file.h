// SPDX-License-Identifier: MIT
// Writes glTF documents (with tinygltf, which only this unit includes).
#pragma once

#include <string>

#include "export/gltf_document.h"

namespace polhode {

// The bytes of a binary glTF 2.0 file with everything in it. Numbers that tracks share, meshes that
// nodes share, and corners of triangles that meshes share are stored once. Throws Error
// (environment) if it cannot be written.
std::string glb_of(const GltfDocument& document);

}  // namespace polhode
