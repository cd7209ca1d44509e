// SPDX-License-Identifier: MIT
// Composers of a body in motion, and where their items are drawn.
#pragma once

#include <glm/vec4.hpp>

#include "frame/compose.h"
#include "frame/to_glm.h"
#include "support/motions.h"

namespace polhode::test {

inline constexpr PictureSize kSize{640, 360};

inline Composer composer(const BodySpec& body,
                         const MotionSpec& motion,
                         const ShowSpec& show = {},
                         const CameraSpec& camera = {}) {
  return {moving(body, motion), body, camera, show, ThemeSpec{}, kSize};
}

// where a point of an item's mesh is drawn
inline Vec3 drawn(const DrawItem& item, const Vec3& point) {
  const glm::vec4 at = item.world_from_mesh * glm::vec4(to_glm(point), 1.0f);
  return {at.x, at.y, at.z};
}

}  // namespace polhode::test
