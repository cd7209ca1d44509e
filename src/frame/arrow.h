// SPDX-License-Identifier: MIT
// Draws vectors as arrows. The tip is exactly at the end of the vector.
#pragma once

#include <vector>

#include "frame/draw_list.h"
#include "math/notation.h"

namespace polhode {

// The unit meshes that all arrows share.
struct ArrowMeshes {
  MeshPtr shaft;  // unit cylinder
  MeshPtr head;   // unit cone
};
// The arguments are the numbers of pieces of a full circle.
ArrowMeshes arrow_meshes(int around_shaft, int around_head);

// Sizes in metres. A vector shorter than the head gets a smaller head.
struct ArrowShape {
  double shaft_radius = 0.01;
  double head_radius = 0.03;
  double head_length = 0.09;
};

// Adds the items of the arrow from `from` to `tip` (S, m) to `items`; nothing if its length is
// zero.
void add_arrow(std::vector<DrawItem>& items,
               const ArrowMeshes& meshes,
               const Vec3& from,
               const Vec3& tip,
               const ArrowShape& shape,
               const Material& material);

// Adds a tube with flat ends (S, m; radius in m); nothing if its length is zero.
void add_tube(std::vector<DrawItem>& items,
              const ArrowMeshes& meshes,
              const Vec3& from,
              const Vec3& to,
              double radius,
              const Material& material);

}  // namespace polhode
