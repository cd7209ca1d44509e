// SPDX-License-Identifier: MIT
#include "export/gltf_looks.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace polhode {

std::string hex(const glm::vec3& color) {
  const auto byte = [](float c) {
    return static_cast<int>(std::lround(255.0f * c));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b));
}

int material_in(GltfDocument& document,
                const Material& look,
                bool both_sides,
                const std::string& name) {
  const auto same = [&](const GltfMaterial& one) {
    const Material& other = one.look;
    return one.both_sides == both_sides && other.color == look.color && other.alpha == look.alpha &&
           other.gloss == look.gloss && other.mark_color == look.mark_color &&
           other.mark_width == look.mark_width && other.finish == look.finish &&
           other.flat == look.flat && other.vivid == look.vivid && other.soft == look.soft &&
           other.covers == look.covers && other.hidden == look.hidden &&
           other.dashes == look.dashes && other.grain == look.grain && other.thin == look.thin &&
           other.turned == look.turned;
  };
  std::vector<GltfMaterial>& list = document.materials;
  const auto found = std::find_if(list.begin(), list.end(), same);
  if (found == list.end()) {
    list.push_back({name, look, both_sides});
    return static_cast<int>(list.size()) - 1;
  }
  return static_cast<int>(found - list.begin());
}

int mesh_in(GltfDocument& document, const MeshPtr& mesh, int material, PaintMarks paint) {
  std::vector<GltfMesh>& list = document.meshes;
  const auto found = std::find_if(list.begin(), list.end(), [&](const GltfMesh& one) {
    return one.mesh == mesh && one.material == material;
  });
  if (found != list.end()) return static_cast<int>(found - list.begin());
  const GltfMaterial& of = document.materials[static_cast<std::size_t>(material)];
  GltfMesh added{of.name, mesh, material};
  if (of.look.mark_width > 0.0f && paint != nullptr) {
    float reach = 0.0f;
    for (const Vertex& vertex : mesh->vertices)
      reach = std::max({reach, std::abs(vertex.position.x), std::abs(vertex.position.y)});
    added.texture = paint(of.look, static_cast<double>(reach));
  }
  list.push_back(added);
  return static_cast<int>(list.size()) - 1;
}

}  // namespace polhode
