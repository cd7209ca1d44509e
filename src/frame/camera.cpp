// SPDX-License-Identifier: MIT
#include "frame/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "frame/to_glm.h"

namespace polhode {
namespace {

// rows right, up, back of a camera that looks along -back
Mat3 camera_axes(const Vec3& back) {
  const Vec3 b = back.normalized();
  // looking straight up or down leaves +Z without a direction; then +Y is up
  const Vec3 upward = std::abs(b.z()) < 0.9999 ? Vec3::UnitZ() : Vec3::UnitY();
  const Vec3 right = upward.cross(b).normalized();
  Mat3 R_CS;
  R_CS << right.transpose(), b.cross(right).transpose(), b.transpose();
  return R_CS;
}

}  // namespace

Camera::Camera(const Vec3& eye,
               const Vec3& target,
               double fov,
               FrameSize size,
               const Vec3& center,
               double radius)
    : eye_(eye),
      R_CS_(camera_axes(eye - target)),
      size_(size),
      focal_px_(0.5 * size.height / std::tan(0.5 * fov)) {
  // clip planes close around what is drawn: depth keeps its precision
  const double depth = R_CS_.row(2).dot(eye - center);
  const double far_plane = std::max(depth + 1.5 * radius, 1e-6 * radius);
  const double near_plane = std::max(depth - 1.5 * radius, 1e-3 * far_plane);
  const double f = 1.0 / std::tan(0.5 * fov);
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = f * size.height / size.width;
  projection(1, 1) = f;
  projection(2, 2) = -(far_plane + near_plane) / (far_plane - near_plane);
  projection(2, 3) = -2.0 * far_plane * near_plane / (far_plane - near_plane);
  projection(3, 2) = -1.0;
  Eigen::Matrix4d world_to_camera = Eigen::Matrix4d::Identity();
  world_to_camera.topLeftCorner<3, 3>() = R_CS_;
  world_to_camera.topRightCorner<3, 1>() = -R_CS_ * eye;
  clip_from_world_ = projection * world_to_camera;
}

Vec2 Camera::project(const Vec3& point_S) const {
  const Vec3 p = R_CS_ * (point_S - eye_);
  return {0.5 * size_.width - focal_px_ * p.x() / p.z(),
          0.5 * size_.height + focal_px_ * p.y() / p.z()};
}

double Camera::pixels_per_metre(const Vec3& point_S) const {
  return focal_px_ / -R_CS_.row(2).dot(point_S - eye_);
}

View Camera::view() const {
  View view;
  view.clip_from_world = to_glm(clip_from_world_);
  view.eye = to_glm(eye_);
  // lights travel with the camera: from its upper left, and weakly from its right
  const Mat3 R_SC = R_CS_.transpose();
  view.key_light = to_glm(Vec3((R_SC * Vec3(-0.45, 0.75, 0.65)).normalized()));
  view.fill_light = to_glm(Vec3((R_SC * Vec3(0.8, -0.1, 0.45)).normalized()));
  return view;
}

Camera framing_camera(const std::vector<Vec3>& points,
                      const Vec3& direction,
                      double fov,
                      FrameSize size,
                      double margin) {
  CHECK(!points.empty());
  const Mat3 R_CS = camera_axes(direction);
  // tangents of the half-angles that the points may fill
  const double shrink = 1.0 - 2.0 * margin;
  const double tan_v = shrink * std::tan(0.5 * fov);
  const std::array<double, 2> tangent = {tan_v * size.width / size.height, tan_v};

  // In the plane of one picture axis a, with z towards the camera, a point is inside the frame when
  // |a - a_eye| <= tan * (z_eye - z). The two sides give the tightest a_eye and z_eye at once.
  std::array<double, 2> sum{}, difference{};
  sum.fill(-std::numeric_limits<double>::infinity());
  difference.fill(-std::numeric_limits<double>::infinity());
  double front = -std::numeric_limits<double>::infinity();
  for (const Vec3& point : points) {
    const Vec3 p = R_CS * point;
    front = std::max(front, p.z());
    for (int axis = 0; axis < 2; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      sum[a] = std::max(sum[a], p.z() * tangent[a] + p[axis]);
      difference[a] = std::max(difference[a], p.z() * tangent[a] - p[axis]);
    }
  }
  Vec3 eye_C;
  eye_C.z() = front;
  for (int axis = 0; axis < 2; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    eye_C[axis] = 0.5 * (sum[a] - difference[a]);
    eye_C.z() = std::max(eye_C.z(), 0.5 * (sum[a] + difference[a]) / tangent[a]);
  }

  // the ball around the points, for the clip planes
  Vec3 center = Vec3::Zero();
  for (const Vec3& point : points)
    center += point / static_cast<double>(points.size());
  double radius = 0.0;
  for (const Vec3& point : points)
    radius = std::max(radius, (point - center).norm());
  radius = std::max(radius, 1e-9);
  if (eye_C.z() - front < 0.1 * radius) eye_C.z() = front + 0.1 * radius;
  const Vec3 eye = R_CS.transpose() * eye_C;
  return {eye, eye - R_CS.row(2).transpose(), fov, size, center, radius};
}

}  // namespace polhode
