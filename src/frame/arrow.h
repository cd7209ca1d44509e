// SPDX-License-Identifier: MIT
// Vectors as arrows whose tip is exactly at the end of the vector.
#pragma once

#include <vector>

#include "frame/draw_list.h"
#include "math/notation.h"

namespace polhode {

// The unit pieces that every arrow shares.
struct ArrowMeshes {
  MeshPtr shaft;  // unit cylinder
  MeshPtr head;   // unit cone
};
// Pieces of a circle, around each.
ArrowMeshes arrow_meshes(int around_shaft, int around_head);

// Sizes in metres. A vector shorter than the head gets a smaller head, never a shifted tip.
struct ArrowShape {
  double shaft_radius = 0.01;
  double head_radius = 0.03;
  double head_length = 0.09;
};

// Adds the arrow from `from` to `tip` (space, m); nothing for a vector of no length.
void add_arrow(std::vector<DrawItem>& items,
               const ArrowMeshes& meshes,
               const Vec3& from,
               const Vec3& tip,
               const ArrowShape& shape,
               const Material& material);

// Adds a tube with flat ends; nothing for one of no length.
void add_tube(std::vector<DrawItem>& items,
              const ArrowMeshes& meshes,
              const Vec3& from,
              const Vec3& to,
              double radius,
              const Material& material);

}  // namespace polhode
