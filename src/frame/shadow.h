// SPDX-License-Identifier: MIT
// The shadow of bodies on a floor. A floor has coordinates of its own: it is the unit disc z = 0,
// and what is above it has z > 0.
#pragma once

#include <vector>

#include "frame/mesh.h"
#include "frame/to_glm.h"

namespace polhode {

// The light is round and far away: its radius over its distance, for a light that stands overhead.
inline constexpr double kLightSize = 0.1;
// The least height of the light: a lower one is raised, so that no shadow becomes very long.
inline constexpr double kLeastLightHeight = 0.5;  // sine of the angle above the floor
// How far beyond its penumbra a shadow is smoothed, in radii of the floor.
inline constexpr double kShadowBlur = 0.08;
// Floors fade so near their rim, in their radius, and the shadows on them by as much.
inline constexpr double kFloorRim = 0.5;

// Something that stops light.
struct ShadowCaster {
  MeshPtr mesh;  // not null; a rough one will do
  Placement floor_from_mesh;
  double density = 1.0;  // the part of the light that it stops, 0..1
};

// The directions to points of the light around `to_light` (floor coordinates, not zero), as slopes:
// the shadow of a point p falls on (p.x, p.y) - p.z * slope. Their mean is that of the middle.
std::vector<Vec2> light_slopes(const Vec3& to_light);

// The shadow, as a flat mesh in the plane z = 0 of the floor. fineness (at least 1): how many times
// as fine, and as little smoothed, as is enough where the casters are as large as the floor. Its
// normals are not unit: their z is the darkness (0..1), for a material that is `soft`; their x is
// 0. Parts below the floor throw no shadow; within `rim` (radii of the floor, positive) of the rim
// the darkness falls smoothly to 0. Null if there is no shadow.
MeshPtr shadow_mesh(const std::vector<ShadowCaster>& casters,
                    const Vec3& to_light,
                    double fineness = 1.0,
                    double rim = kFloorRim);

// Directions to points of the sky but for its lowest part, from which equal parts of its light come
// to a floor (Lambert's cosine law), as slopes.
std::vector<Vec2> sky_slopes();
// How far beyond its penumbra the shade of the sky is smoothed, in radii of the floor.
inline constexpr double kSkyBlur = 0.35;

// The floor itself, as a mesh in the plane z = 0. Its normals are not unit, for a material that is
// `soft`: their z falls smoothly from 1, in the inner half, to 0 at the rim, and their x (0..1) is
// the part of the light of the sky that the casters keep: large where something stands on the
// floor, small and wide below what hovers. fineness: as of shadow_mesh().
MeshPtr floor_mesh(const std::vector<ShadowCaster>& casters, double fineness = 1.0);

}  // namespace polhode
