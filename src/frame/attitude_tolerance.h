// SPDX-License-Identifier: MIT
// How exact an attitude must be for a picture.
#pragma once

#include <vector>

#include "frame/camera.h"
#include "frame/view_spec.h"

namespace polhode {

// How far drawn things are from the body's reference point.
struct DrawnReach {
  double body = 0.0;              // body_radius() (frame/body_look.h), m
  double points = 0.0;            // the farthest of show.points and show.trail_points, m
  std::vector<Vec3> places = {};  // where the reference point is seen, S, m
};

// The attitude error, rad, that moves no drawn point by more than `pixels` (positive) in a picture
// of that size. An automatic camera keeps all points in the picture; for one with camera.eye,
// points are taken to be as far from the target and from `places` as those of the scene reach, and
// vectors kReachOfVectors times as far as the body. A target that is not given counts as the
// origin. A camera that moves with the body stays as far from it as it is from the first place.
// Throws Error (input), naming camera.eye, if the camera is at its target.
double attitude_tolerance(const CameraSpec& camera,
                          double pixels,
                          const DrawnReach& drawn,
                          PictureSize size);

}  // namespace polhode
