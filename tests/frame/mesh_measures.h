// SPDX-License-Identifier: MIT
// What a mesh encloses, and whether it is closed.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "frame/mesh.h"

namespace polhode::test {

// signed volume of a closed mesh by the divergence theorem: positive when triangles face outwards
inline double signed_volume(const Mesh& mesh) {
  double six = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = mesh.vertices[mesh.indices[i]].position;
    const glm::dvec3 b = mesh.vertices[mesh.indices[i + 1]].position;
    const glm::dvec3 c = mesh.vertices[mesh.indices[i + 2]].position;
    six += glm::dot(a, glm::cross(b, c));
  }
  return six / 6.0;
}

// how many directed edges have no partner that runs the other way (0 for a closed surface)
inline int open_edges(const Mesh& mesh) {
  const auto key = [](const glm::vec3& p) {
    return std::array<long, 3>{
        std::lround(p.x * 1e6), std::lround(p.y * 1e6), std::lround(p.z * 1e6)};
  };
  std::map<std::pair<std::array<long, 3>, std::array<long, 3>>, int> balance;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = key(mesh.vertices[mesh.indices[i + k]].position);
      const auto b = key(mesh.vertices[mesh.indices[i + (k + 1) % 3]].position);
      if (a == b) continue;
      ++balance[{a, b}];
      --balance[{b, a}];
    }
  }
  int open = 0;
  for (const auto& [edge, count] : balance)
    open += count != 0 ? 1 : 0;
  return open;
}

}  // namespace polhode::test
