// SPDX-License-Identifier: MIT
#include "frame/attitude_tolerance.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "frame/body_look.h"

namespace polhode {

double attitude_tolerance(const CameraSpec& camera,
                          double pixels,
                          const DrawnReach& drawn,
                          PictureSize size) {
  // an automatic camera keeps everything that is drawn inside the frame, so a radian moves a point
  // by at most half a diagonal
  const double half_diagonal = 0.5 * std::hypot(size.width, size.height);
  const double zoom = std::max(camera.zoom, 1.0);
  if (!camera.eye) return pixels / (half_diagonal * zoom);
  const double reach = std::max(kReachOfVectors * drawn.body, drawn.points);
  const double distance = (*camera.eye - camera.target.value_or(Vec3::Zero())).norm();
  if (!(distance > 0.0)) {
    throw input_error("must differ from camera.target").at({{}, 0, "camera.eye"});
  }
  double least = distance;
  for (const Vec3& place : drawn.places) {
    const Vec3 away = *camera.eye - place;
    // of a camera that goes round the vertical, when it is nearest
    const Vec3 middle = camera.target.value_or(drawn.places.front());
    const double around =
        std::abs((*camera.eye - middle).head<2>().norm() - (place - middle).head<2>().norm());
    least = std::min(least, camera.orbit != 0.0 ? std::hypot(around, away.z()) : away.norm());
    if (camera.follow != "auto" && camera.follow != "none") break;
  }
  const double nearest = std::max(least - reach, 0.05 * least);
  const double focal_px = camera.zoom * 0.5 * size.height / std::tan(0.5 * camera.fov);
  return pixels * nearest / (focal_px * reach);
}

}  // namespace polhode
