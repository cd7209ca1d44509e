// SPDX-License-Identifier: MIT
// The camera: a pinhole with a vertical field of view, and the one that frames a set of points.
#pragma once

#include <optional>
#include <vector>

#include "frame/draw_list.h"
#include "frame/view_spec.h"
#include "image/picture_size.h"
#include "math/notation.h"

namespace polhode {

// What is left free at the sides of a picture, as fractions of its width and height.
struct FrameMargins {
  double left = 0.045, right = 0.045;
  double top = 0.045, bottom = 0.045;
};

// Where drawing coordinates are in space: origin and unit near those of what is drawn, so that a
// molecule, and a body far from the origin, keep their digits in single precision.
struct DrawingFrame {
  Vec3 origin = Vec3::Zero();  // space, m
  double unit = 1.0;           // m

  Vec3 point(const Vec3& point_S) const { return (point_S - origin) / unit; }
  double length(double metres) const { return metres / unit; }
};

// Immutable. Space is z-up in pictures: the picture's upward direction is that of +Z.
class Camera {
 public:
  // eye and target in m, fov the vertical field of view in rad; near and far clip planes are set so
  // that the ball (center, radius) is inside.
  Camera(const Vec3& eye,
         const Vec3& target,
         double fov,
         PictureSize size,
         const Vec3& center,
         double radius);

  // Pixel coordinates of a point in front of the camera: x to the right, y down, (0, 0) the upper
  // left corner of the upper left pixel.
  Vec2 project(const Vec3& point_S) const;
  // Pixels per metre, across the line of sight, at the depth of the point.
  double pixels_per_metre(const Vec3& point_S) const;
  const Vec3& eye() const { return eye_; }
  // Is the point in front of the camera and inside the picture?
  bool sees(const Vec3& point_S) const;
  // The same camera, moved together with a rig: rig_from_space takes space to where the rig stands
  // still.
  Camera moved(const Eigen::Isometry3d& rig_from_space) const;
  // On the way from a to b, part 0..1: directions turn at a constant rate, the distance to `focus`
  // changes evenly. Both of the same picture size.
  static Camera between(const Camera& a, const Camera& b, double part, const Vec3& focus);
  // Of a draw list in these coordinates.
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

struct Ball {
  Vec3 center;  // space, m
  double radius;
};

// About the mean of the points, for the clip planes; a single point gets a radius of 1 m.
Ball ball_around(const std::vector<Vec3>& points);

// The nearest camera with this line of sight that keeps every point inside the frame less its
// margins. direction: from the scene towards the camera; target: in
// the middle of the picture, when there is one.
Camera framing_camera(const std::vector<Vec3>& points,
                      const std::optional<Vec3>& target,
                      const Vec3& direction,
                      double fov,
                      PictureSize size,
                      const FrameMargins& margins);

}  // namespace polhode
