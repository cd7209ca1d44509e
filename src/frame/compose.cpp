// SPDX-License-Identifier: MIT
#include "frame/compose.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace polhode {
namespace {

// what a scene shows, with every default resolved
std::map<std::string, bool> resolve(const ShowSpec& spec, const Stage& stage) {
  std::map<std::string, bool> shown;
  for (const Element& element : elements()) {
    const auto found = spec.asked.find(element.name);
    const std::optional<bool> asked = found == spec.asked.end() ? std::nullopt : found->second;
    shown[element.name] = asked ? *asked : element.by_default(stage);
    if (!asked.value_or(false)) continue;
    const std::string wrong = element.why_not(stage);
    if (!wrong.empty()) throw input_error("{}", wrong).at({{}, 0, "show." + element.name});
  }
  const bool cones = shown["space_cone"] || shown["body_cone"] || shown["precession_cone"];
  if (spec.body_opacity < 1.0 && cones) {
    throw input_error("a body that is seen through goes without cones; set the cones to false")
        .at({{}, 0, "show.body_opacity"});
  }
  return shown;
}

DrawingFrame make_drawing_frame(const Stage& stage) {
  const Vec3 origin = stage.motion.at(0.0).reference_S;
  const double size = stage.scale.body;
  constexpr double kDigits = 1e-10;  // of double precision that a picture can spare
  if (size < kDigits * origin.norm()) {
    throw input_error("the body is too small ({:.3g} m) to be drawn {:.3g} m from the origin",
                      size,
                      origin.norm())
        .at({{}, 0, "motion.position"});
  }
  return {origin, size};
}

Camera make_camera(const CameraSpec& spec,
                   const std::vector<Vec3>& points,
                   FrameSize size,
                   const FrameMargins& margins) {
  if (!spec.eye) {
    const Vec3 direction = spec.direction.value_or(kDefaultDirection);
    if (direction.stableNorm() == 0.0) {
      throw input_error("must not be zero").at({{}, 0, "camera.direction"});
    }
    return framing_camera(points, spec.target, direction, spec.fov, size, margins);
  }

  // the scene's own camera; the ball of what is drawn sets the clip planes
  Vec3 center = Vec3::Zero();
  for (const Vec3& point : points)
    center += point / static_cast<double>(points.size());
  double radius = 0.0;
  for (const Vec3& point : points)
    radius = std::max(radius, (point - center).norm());
  if (radius == 0.0) radius = 1.0;  // nothing but a point
  const Vec3 target = spec.target.value_or(center);
  if ((*spec.eye - target).norm() < 1e-9 * (radius + target.norm())) {
    throw input_error("the camera is where it looks at").at({{}, 0, "camera.eye"});
  }
  return {*spec.eye, target, spec.fov, size, center, radius};
}

}  // namespace

Composer::Composer(const Motion& motion,
                   const BodySpec& body,
                   const CameraSpec& camera,
                   const ShowSpec& show,
                   const ThemeSpec& theme,
                   FrameSize size,
                   const FrameMargins& margins)
    : stage_(make_stage(motion, body, theme, show, circle_segments(0.5 * size.height))),
      shown_(resolve(show, stage_)),
      meshes_{arrow_meshes(circle_segments(0.05 * size.height)),
              cone_meshes(circle_segments(0.5 * size.height))},
      drawing_(make_drawing_frame(stage_)),
      camera_(make_camera(camera, points_to_frame(), size, margins)) {}

Composer::Composer(const Composer& other, const Motion& motion) : Composer(other) {
  stage_.motion = motion;
}

Marks Composer::marks_at(const Sample& sample) const {
  Marks marks;
  marks.middle = sample.reference_S;
  for (const Element& element : elements()) {
    if (shows(element.name)) element.add(stage_, sample, marks);
  }
  add_points(stage_, sample, shows("fixed_frame"), marks);
  add_point_trails(stage_, sample, marks);
  return marks;
}

Shot Composer::shot(double t) const {
  Shot shot;
  const Marks marks = marks_at(stage_.motion.at(t));
  shot.list.view = camera_.view(drawing_);
  shot.list.background = stage_.theme.background;
  add_items(marks, meshes_, drawing_, camera_.eye(), shot.list);
  for (const LabelMark& label : marks.labels) {
    if (camera_.sees(label.at)) shot.labels.push_back(seen(label));
  }
  return shot;
}

SeenLabel Composer::seen(const LabelMark& label) const {
  const Vec2 at = camera_.project(label.at);
  // a little way along; where that is towards the eye, the label stands above
  const Vec3 step = 0.05 * stage_.scale.body * label.away.stableNormalized();
  const Vec2 along = camera_.project(label.at + step) - at;
  const double pixel = 0.05 * stage_.scale.body * camera_.pixels_per_metre(label.at);
  const Vec2 away = along + 0.1 * pixel * Vec2(0.0, -1.0);
  const Vec2 from =
      camera_.sees(label.at - label.away) ? camera_.project(label.at - label.away) : at;
  return {from, at, away.normalized(), label.markup, label.color};
}

std::vector<Vec3> Composer::points_to_frame() const {
  std::vector<Vec3> points;
  for (const double t : framing_times(stage_.motion)) {
    const Sample sample = stage_.motion.at(t);
    points.push_back(sample.reference_S);
    add_extent(marks_at(sample), points);
  }
  return points;
}

std::vector<Error> Composer::warnings() const {
  const std::vector<Vec3> points = points_to_frame();
  const auto seen = [&](const Vec3& point) {
    return camera_.sees(point);
  };
  if (std::none_of(points.begin(), points.end(), seen)) {
    return {input_error("the camera sees nothing of the scene; without camera.eye it frames the "
                        "film by itself")
                .at({{}, 0, "camera.eye"})};
  }
  if (!shows("body")) return {};
  double nearest = std::numeric_limits<double>::infinity();
  double largest = 0.0;  // pixels
  for (const double t : framing_times(stage_.motion)) {
    const Vec3 middle = stage_.motion.at(t).reference_S;
    nearest = std::min(nearest, (camera_.eye() - middle).norm());
    if (camera_.sees(middle)) {
      largest = std::max(largest, stage_.scale.body * camera_.pixels_per_metre(middle));
    }
  }
  if (nearest < stage_.scale.body) {
    return {input_error("the camera comes within {:.3g} m of the body's middle, but the body "
                        "reaches {:.3g} m; move it away",
                        nearest,
                        stage_.scale.body)
                .at({{}, 0, "camera.eye"})};
  }
  if (largest > 0.0 && largest < 1.0) {
    return {
        input_error("the body, {:.3g} m, is never as large as a pixel; the film goes too far or "
                    "the camera stands too far away",
                    stage_.scale.body)
            .at({{}, 0, "camera"})};
  }
  return {};
}

double attitude_tolerance(const CameraSpec& camera,
                          double pixels,
                          double body_radius,
                          FrameSize size) {
  // an automatic camera keeps everything that is drawn inside the frame, so a radian moves a point
  // by at most half a diagonal
  const double half_diagonal = 0.5 * std::hypot(size.width, size.height);
  if (!camera.eye) return pixels / half_diagonal;
  const double reach = kReachOfVectors * body_radius;
  const double distance = (*camera.eye - camera.target.value_or(Vec3::Zero())).norm();
  if (!(distance > 0.0)) {
    throw input_error("must differ from camera.target").at({{}, 0, "camera.eye"});
  }
  const double nearest = std::max(distance - reach, 0.05 * distance);
  const double focal_px = 0.5 * size.height / std::tan(0.5 * camera.fov);
  return pixels * nearest / (focal_px * reach);
}

}  // namespace polhode
