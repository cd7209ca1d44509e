// SPDX-License-Identifier: MIT
#include "frame/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "frame/to_glm.h"
#include "math/so3.h"

namespace polhode {
namespace {

// rows right, up, back of a camera that looks along -back
Mat3 camera_axes(const Vec3& back) {
  const Vec3 b = back.stableNormalized();
  // looking straight up or down leaves +Z without a direction; then +Y is up
  const Vec3 upward = std::abs(b.z()) < 0.9999 ? Vec3::UnitZ() : Vec3::UnitY();
  const Vec3 right = upward.cross(b).normalized();
  Mat3 R_CS;
  R_CS << right.transpose(), b.cross(right).transpose(), b.transpose();
  return R_CS;
}

// Tangents of the angles from the line of sight, across and upwards, that points may fill.
struct Tangents {
  std::array<double, 2> low, high;  // left and down, right and up
};

// In the plane of one picture axis a, with z towards the camera, a point is inside the frame when
// -low * (z_eye - z) <= a - a_eye <= high * (z_eye - z). The two sides give the tightest z_eye;
// what room is left is shared between them.
Vec3 nearest_eye(const std::vector<Vec3>& points_C, const Tangents& tangent) {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  std::array<double, 2> above = {kNone, kNone};
  std::array<double, 2> below = {kNone, kNone};
  Vec3 eye_C(0, 0, kNone);
  for (const Vec3& p : points_C) {
    eye_C.z() = std::max(eye_C.z(), p.z());
    for (std::size_t a = 0; a < 2; ++a) {
      const double across = p[static_cast<Eigen::Index>(a)];
      above[a] = std::max(above[a], p.z() * tangent.high[a] + across);
      below[a] = std::max(below[a], p.z() * tangent.low[a] - across);
    }
  }
  for (std::size_t a = 0; a < 2; ++a)
    eye_C.z() = std::max(eye_C.z(), (above[a] + below[a]) / (tangent.low[a] + tangent.high[a]));
  for (std::size_t a = 0; a < 2; ++a) {
    const double least = above[a] - eye_C.z() * tangent.high[a];
    const double most = eye_C.z() * tangent.low[a] - below[a];
    eye_C[static_cast<Eigen::Index>(a)] = 0.5 * (least + most);
  }
  return eye_C;
}

// The same for an eye that can only move along z through the target.
Vec3 nearest_eye(const std::vector<Vec3>& points_C, const Tangents& tangent, const Vec3& target_C) {
  Vec3 eye_C = target_C;
  for (const Vec3& p : points_C) {
    for (std::size_t a = 0; a < 2; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      const double across = p[axis] - target_C[axis];
      const double slope = across < 0.0 ? tangent.low[a] : tangent.high[a];
      eye_C.z() = std::max(eye_C.z(), p.z() + std::abs(across) / slope);
    }
  }
  return eye_C;
}

}  // namespace

// close around what is drawn, a ball at that depth: depth keeps its precision. A floor may reach
// farther than what is framed.
Camera::ClipPlanes Camera::clip_planes(double depth, double radius) {
  const double far_plane = std::max(depth + 3.0 * radius, 1e-6 * radius);
  return {std::max(depth - 1.5 * radius, 1e-3 * far_plane), far_plane};
}

Camera::Camera(const Vec3& eye,
               const Vec3& target,
               double fov,
               PictureSize size,
               const Vec3& center,
               double radius)
    : Camera(camera_axes(eye - target),
             eye,
             fov,
             size,
             clip_planes((eye - target).stableNormalized().dot(eye - center), radius)) {}

Camera::Camera(
    const Mat3& R_CS, const Vec3& eye, double fov, PictureSize size, const ClipPlanes& clip)
    : eye_(eye),
      R_CS_(R_CS),
      size_(size),
      fov_(fov),
      clip_(clip),
      focal_px_(0.5 * size.height / std::tan(0.5 * fov)) {
  const auto [near_plane, far_plane] = clip;
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

Camera Camera::moved(const Eigen::Isometry3d& rig_from_space) const {
  return {R_CS_ * rig_from_space.linear(), rig_from_space.inverse() * eye_, fov_, size_, clip_};
}

Eigen::Isometry3d Camera::space_from_camera() const {
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.linear() = R_CS_.transpose();
  place.translation() = eye_;
  return place;
}

Camera Camera::zoomed(double factor) const {
  return {R_CS_, eye_, 2.0 * std::atan(std::tan(0.5 * fov_) / factor), size_, clip_};
}

Camera Camera::seeing_farther(double more) const {
  constexpr double kNearest = 1e-2;  // of the far distance: depth keeps its precision
  const double far_plane = clip_.far_plane + more;
  return {R_CS_,
          eye_,
          fov_,
          size_,
          {std::min(clip_.near_plane, std::max(clip_.near_plane - more, kNearest * far_plane)),
           far_plane}};
}

Vec3 Camera::turn_to(const Camera& other, const Vec3& nearest) const {
  const Eigen::AngleAxisd shortest(Mat3(other.R_CS_ * R_CS_.transpose()));
  const Vec3& axis = shortest.axis();
  const double whole = std::round((axis.dot(nearest) - shortest.angle()) / (2.0 * kPi));
  return (shortest.angle() + 2.0 * kPi * whole) * axis;
}

Camera Camera::between(
    const Camera& a, const Camera& b, double part, const Vec3& focus, const Vec3& turn) {
  if (part <= 0.0) return a;
  if (part >= 1.0) return b;
  const Mat3 R_CS = exp_rotation(part * turn).toRotationMatrix() * a.R_CS_;
  // where the focus is as the camera sees it
  const Vec3 seen_a = a.R_CS_ * (focus - a.eye_);
  const Vec3 seen_b = b.R_CS_ * (focus - b.eye_);
  const Vec3 seen = seen_a + part * (seen_b - seen_a);
  return {R_CS,
          focus - R_CS.transpose() * seen,
          a.fov_ + part * (b.fov_ - a.fov_),
          a.size_,
          {std::min(a.clip_.near_plane, b.clip_.near_plane),
           std::max(a.clip_.far_plane, b.clip_.far_plane)}};
}

Vec2 Camera::project(const Vec3& point_S) const {
  const Vec3 p = R_CS_ * (point_S - eye_);
  return {0.5 * size_.width - focal_px_ * p.x() / p.z(),
          0.5 * size_.height + focal_px_ * p.y() / p.z()};
}

double Camera::pixels_per_metre(const Vec3& point_S) const {
  return focal_px_ / -R_CS_.row(2).dot(point_S - eye_);
}

std::optional<Vec2> Camera::way_to(const Ball& ball) const {
  const Vec3 p = R_CS_ * (ball.center - eye_);
  const double radius = ball.radius;
  // the plane through the eye and an edge, whose distance from the middle is `reach` (px)
  const auto is_beyond_edge = [&](double across, double reach) {
    const double slope = reach / focal_px_;
    return std::abs(across) + slope * p.z() > radius * std::hypot(1.0, slope);
  };
  const bool is_out = is_beyond_edge(p.x(), 0.5 * size_.width) ||
                      is_beyond_edge(p.y(), 0.5 * size_.height) ||
                      p.z() - radius > -clip_.near_plane || p.z() + radius < -clip_.far_plane;
  if (!is_out) return {};
  const Vec2 way(p.x(), -p.y());
  return way.norm() > 0.0 ? Vec2(way.stableNormalized()) : Vec2(0.0, 1.0);
}

bool Camera::sees(const Vec3& point_S) const {
  if (R_CS_.row(2).dot(point_S - eye_) >= 0.0) return false;
  const Vec2 pixel = project(point_S);
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= size_.width &&
         pixel.y() <= size_.height;
}

View Camera::view(const DrawingFrame& frame) const {
  View view;
  // homogeneous coordinates take any factor: with 1/unit the depths are in drawing units too
  Eigen::Matrix4d world_from_drawing = Eigen::Matrix4d::Identity();
  world_from_drawing.topRightCorner<3, 1>() = frame.origin / frame.unit;
  world_from_drawing(3, 3) = 1.0 / frame.unit;
  view.clip_from_world = to_glm(Eigen::Matrix4d(clip_from_world_ * world_from_drawing));
  view.eye = to_glm(frame.point(eye_));
  // lights travel with the camera: from its upper left, and weakly from its right
  const Mat3 R_SC = R_CS_.transpose();
  view.key_light = to_glm(Vec3((R_SC * Vec3(-0.45, 0.75, 0.65)).normalized()));
  view.fill_light = to_glm(Vec3((R_SC * Vec3(0.8, -0.1, 0.45)).normalized()));
  return view;
}

std::vector<std::string> follow_names() {
  return {"auto", "none", "center", "body", "momentum", "upright"};
}

Ball ball_around(const std::vector<Vec3>& points) {
  Vec3 center = Vec3::Zero();
  for (const Vec3& point : points)
    center += point / static_cast<double>(points.size());
  double radius = 0.0;
  for (const Vec3& point : points)
    radius = std::max(radius, (point - center).norm());
  return {center, radius == 0.0 ? 1.0 : radius};
}

Camera framing_camera(const std::vector<Vec3>& points,
                      const std::optional<Vec3>& target,
                      const Vec3& direction,
                      double fov,
                      PictureSize size,
                      const FrameMargins& margins) {
  CHECK(!points.empty());
  const Mat3 R_CS = camera_axes(direction);
  std::vector<Vec3> points_C;
  points_C.reserve(points.size());
  double front = -std::numeric_limits<double>::infinity();
  for (const Vec3& point : points) {
    points_C.push_back(R_CS * point);
    front = std::max(front, points_C.back().z());
  }
  const double up = std::tan(0.5 * fov);
  const double across = up * size.width / size.height;
  const Tangents tangent = {
      {(1.0 - 2.0 * margins.left) * across, (1.0 - 2.0 * margins.bottom) * up},
      {(1.0 - 2.0 * margins.right) * across, (1.0 - 2.0 * margins.top) * up}};
  Vec3 eye_C =
      target ? nearest_eye(points_C, tangent, R_CS * *target) : nearest_eye(points_C, tangent);

  const auto [center, radius] = ball_around(points);
  if (eye_C.z() - front < 0.1 * radius) eye_C.z() = front + 0.1 * radius;
  const Vec3 eye = R_CS.transpose() * eye_C;
  return {eye, eye - radius * R_CS.row(2).transpose(), fov, size, center, radius};
}

}  // namespace polhode
