// SPDX-License-Identifier: MIT
// A pinhole camera, and the automatic camera that frames a set of points.
#pragma once

#include <optional>
#include <vector>

#include "frame/draw_list.h"
#include "frame/view_spec.h"
#include "image/picture_size.h"
#include "math/notation.h"

namespace polhode {

// The margins of a picture, as fractions of its width and height.
struct FrameMargins {
  double left = 0.045, right = 0.045;
  double top = 0.045, bottom = 0.045;
};

// The coordinates of draw lists relative to space S. Origin and unit are chosen near what is drawn,
// so that single precision is enough for a molecule and for a body far from the origin.
struct DrawingFrame {
  Vec3 origin = Vec3::Zero();  // in S, m
  double unit = 1.0;           // m

  // The drawing coordinates of a point, and a length in drawing coordinates.
  Vec3 point(const Vec3& point_S) const { return (point_S - origin) / unit; }
  double length(double metres) const { return metres / unit; }
};

// A ball in space.
struct Ball {
  Vec3 center;    // in S, m
  double radius;  // m
};

// A pinhole camera. Immutable, so any thread may use it. The upward direction of pictures is +Z of
// S (+Y for a camera that looks along Z) for cameras made by the constructor or framing_camera();
// moved() and between() turn it.
class Camera {
 public:
  // eye, target (different from eye), center and radius in S, m; fov: vertical field of view, rad,
  // in (0, pi). The clip planes contain what of the ball (center, radius) is in front of the eye,
  // from a thousandth of the far distance on.
  Camera(const Vec3& eye,
         const Vec3& target,
         double fov,
         PictureSize size,
         const Vec3& center,
         double radius);

  // Pixel coordinates of a point in front of the camera: x to the right, y down, with (0, 0) at the
  // upper left corner of the upper left pixel.
  Vec2 project(const Vec3& point_S) const;
  // Pixels per metre perpendicular to the line of sight, at the depth of a point in front of the
  // camera.
  double pixels_per_metre(const Vec3& point_S) const;
  // The position, in S, m; a reference to a member.
  const Vec3& eye() const { return eye_; }
  // Maps coordinates of the camera (x to the right, y up, -z forwards) to S, m.
  Eigen::Isometry3d space_from_camera() const;
  // The vertical field of view, rad.
  double field_of_view() const { return fov_; }
  // The distances of the clip planes from the eye, m.
  double nearest() const { return clip_.near_plane; }
  double farthest() const { return clip_.far_plane; }
  // Whether the point is in front of the camera and inside the picture.
  bool sees(const Vec3& point_S) const;
  // The direction in the picture (unit vector, x to the right, y down) to a ball that is wholly
  // beyond one of its edges, behind the eye or beyond the clip planes; nothing for any other.
  std::optional<Vec2> way_to(const Ball& ball) const;
  // The camera moved with its rig. rig_from_space maps space to the frame in which the rig is at
  // rest.
  Camera moved(const Eigen::Isometry3d& rig_from_space) const;
  // The camera with everything `factor` (positive) times as large in the picture, about its middle.
  Camera zoomed(double factor) const;
  // The camera with clip planes that also contain what is up to `more` (m) beyond them.
  Camera seeing_farther(double more) const;
  // The turn that takes the axes of this camera to those of the other, as a vector (rad) in the
  // axes of either. Of all such turns, which differ by whole ones, it is the one nearest to
  // `nearest`.
  Vec3 turn_to(const Camera& other, const Vec3& nearest = Vec3::Zero()) const;
  // The camera at the fraction `part` (0..1; outside, that of a or b) of the way from a to b: its
  // axes turn at a constant rate by `turn`, one of a.turn_to(b); field of view and the position of
  // `focus` (S, m) in its axes change linearly. a and b have the same picture size.
  static Camera between(
      const Camera& a, const Camera& b, double part, const Vec3& focus, const Vec3& turn);
  // The view of a draw list in the coordinates of `frame`. The lights move with the camera.
  View view(const DrawingFrame& frame = {}) const;

 private:
  // Distances from the eye, m.
  struct ClipPlanes {
    double near_plane, far_plane;
  };
  static ClipPlanes clip_planes(double depth, double radius);
  Camera(const Mat3& R_CS, const Vec3& eye, double fov, PictureSize size, const ClipPlanes& clip);

  Vec3 eye_;
  Mat3 R_CS_;  // rows: right, up, back
  PictureSize size_;
  double fov_;
  ClipPlanes clip_;
  double focal_px_;
  Eigen::Matrix4d clip_from_world_;
};

// A ball around the mean of the points (S, m) that contains them, for the clip planes. If all
// points are at the same place, the radius is 1 m.
Ball ball_around(const std::vector<Vec3>& points);

// The nearest camera with the given line of sight for which all points (S, m; at least one) are
// inside the picture less its margins, but at least a tenth of the radius of ball_around() in front
// of the foremost point. target: the point in the middle of the picture (S, m); absent: the camera
// moves sideways too. direction: from the scene towards the camera, of any length but zero. fov:
// vertical field of view, rad, in (0, pi).
Camera framing_camera(const std::vector<Vec3>& points,
                      const std::optional<Vec3>& target,
                      const Vec3& direction,
                      double fov,
                      PictureSize size,
                      const FrameMargins& margins);

}  // namespace polhode
