// SPDX-License-Identifier: MIT
#include "frame/compose.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace polhode {
namespace {

// proportions, in units of the body's radius
constexpr double kOmegaLength = 1.3;
constexpr double kMomentumLength = 1.5;
constexpr double kBodyAxisLength = 1.2;
constexpr double kSpaceAxisLength = 1.2;
constexpr double kPrecessionSlant = 1.2;
constexpr double kStandHeight = 0.55;
constexpr double kStandRadius = 0.17;
constexpr ArrowShape kVectorShape{0.020, 0.056, 0.17};
constexpr ArrowShape kAxisShape{0.010, 0.030, 0.10};
constexpr double kRimRadius = 0.008;
constexpr double kReach = kMomentumLength;

constexpr double kFrameMargin = 0.045;  // of the frame, on each side
constexpr int kFramingTimes = 240;      // moments that the automatic camera looks at
constexpr double kSmallestCone = 1e-4;  // rad; below this there is no wobble to draw
constexpr double kWidestCone = 0.995 * kPi / 2.0;

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

bool has_cones(const Motion& motion) {
  const Model& model = motion.model();
  if (model.chi_P.squaredNorm() > 0.0 || !model.kind.symmetric()) return false;
  const Sample start = motion.at(0.0);
  return angle_between(start.w_S, start.L_S) > kSmallestCone;
}

// what a scene shows when it does not say
Shown resolve(const ShowSpec& spec, const Motion& motion, bool stand) {
  const bool cones = has_cones(motion);
  const bool pivot = motion.model().on_pivot;
  const auto asked = [](const std::optional<bool>& value) {
    return value.value_or(false);
  };
  if (!cones && (asked(spec.space_cone) || asked(spec.body_cone))) {
    throw input_error("the space and body cones need a free symmetric top that wobbles")
        .at({{}, 0, asked(spec.space_cone) ? "show.space_cone" : "show.body_cone"});
  }
  if (!pivot && (asked(spec.precession_cone) || asked(spec.pivot))) {
    throw input_error("needs a body on a pivot (motion.hold = \"pivot\")")
        .at({{}, 0, asked(spec.pivot) ? "show.pivot" : "show.precession_cone"});
  }
  Shown shown;
  shown.body = spec.body.value_or(true);
  shown.axes = spec.axes.value_or(false);
  shown.space_axes = spec.space_axes.value_or(true);
  shown.omega = spec.omega.value_or(true);
  shown.momentum = spec.momentum.value_or(true);
  shown.space_cone = spec.space_cone.value_or(cones);
  shown.body_cone = spec.body_cone.value_or(cones);
  shown.precession_cone = spec.precession_cone.value_or(pivot);
  shown.pivot = spec.pivot.value_or(pivot && stand);
  return shown;
}

ArrowShape times(const ArrowShape& shape, double factor) {
  return {shape.shaft_radius * factor, shape.head_radius * factor, shape.head_length * factor};
}

Scale make_scale(const Motion& motion, double radius) {
  // the longest vector of the film has the full length; a body at rest has none to scale
  double fastest = 0.0;
  double largest = 0.0;
  for (int i = 0; i <= kFramingTimes; ++i) {
    const Sample sample = motion.at(motion.duration() * i / kFramingTimes);
    fastest = std::max(fastest, sample.w_S.norm());
    largest = std::max(largest, sample.L_S.norm());
  }
  return {radius,
          fastest > 0.0 ? kOmegaLength * radius / fastest : 0.0,
          largest > 0.0 ? kMomentumLength * radius / largest : 0.0};
}

Material plain(const glm::vec3& color, float gloss) {
  Material material;
  material.color = color;
  material.gloss = gloss;
  return material;
}

Material shell(const glm::vec3& color, float alpha) {
  Material material = plain(color, 0.15f);
  material.alpha = alpha;
  return material;
}

}  // namespace

Composer::Composer(const Motion& motion,
                   const BodySpec& body,
                   const CameraSpec& camera,
                   const ShowSpec& show,
                   const ThemeSpec& theme,
                   FrameSize size)
    : motion_(motion),
      theme_(make_theme(theme)),
      look_(body_look(body, motion.model(), theme_, circle_segments(0.5 * size.height))),
      scale_(make_scale(motion, body_radius(look_, motion.model()))),
      shown_(resolve(show, motion, stays_above_stand())),
      arrows_(arrow_meshes(circle_segments(0.05 * size.height))),
      cones_(cone_meshes(circle_segments(0.5 * size.height))),
      drawing_(make_drawing_frame()),
      camera_(make_camera(camera, size)) {}

// the axis that a picture follows: of symmetry, else towards the centre of mass, else the third
Vec3 Composer::figure_axis_B() const {
  const Model& model = motion_.model();
  const Vec3 arm = model.body.center - model.pivot_B;
  const bool off_pivot = model.on_pivot && arm.norm() > 1e-9 * scale_.body;
  if (model.kind.symmetric()) {
    const Vec3 axis = model.R_BP.col(model.kind.axis);
    return off_pivot && axis.dot(arm) < 0.0 ? Vec3(-axis) : axis;
  }
  if (off_pivot) return arm.normalized();
  return Vec3::UnitZ();
}

Vec3 Composer::omega_tip(const Sample& sample) const {
  return sample.reference_S + scale_.omega * sample.w_S;
}

Vec3 Composer::momentum_tip(const Sample& sample) const {
  return sample.reference_S + scale_.momentum * sample.L_S;
}

std::vector<Cone> Composer::cones_at(const Sample& sample) const {
  std::vector<Cone> cones;
  const auto add =
      [&](const Vec3& axis, double half_angle, double slant, const glm::vec3& color, float alpha) {
        if (half_angle < kSmallestCone || half_angle > kWidestCone) return;
        cones.push_back({sample.reference_S,
                         axis,
                         half_angle,
                         slant,
                         kRimRadius * scale_.body,
                         shell(color, alpha)});
      };

  // the two cones touch along omega and end at its tip
  const double slant = scale_.omega * sample.w_S.norm();
  Vec3 figure = sample.q_SB * figure_axis_B();
  if (shown_.space_cone) {
    add(sample.L_S.normalized(),
        angle_between(sample.L_S, sample.w_S),
        slant,
        theme_.space_cone,
        0.30f);
  }
  if (shown_.body_cone) {
    const Vec3 axis = figure.dot(sample.w_S) < 0.0 ? Vec3(-figure) : figure;
    add(axis, angle_between(axis, sample.w_S), slant, theme_.body_cone, 0.30f);
  }

  // about the vertical, through the body axis of this moment
  if (shown_.precession_cone) {
    const Vec3& up = motion_.model().up_S;
    const Vec3 axis = figure.dot(up) < 0.0 ? Vec3(-up) : up;
    add(axis,
        angle_between(axis, figure),
        kPrecessionSlant * scale_.body,
        theme_.precession_cone,
        0.20f);
  }
  return cones;
}

void Composer::add_body(DrawList& list, const Sample& sample) const {
  const Model& model = motion_.model();
  Placement space_from_body = Placement::Identity();
  space_from_body.linear() = sample.q_SB.toRotationMatrix();
  space_from_body.translation() =
      sample.reference_S - space_from_body.linear() * model.reference_B();
  for (const LookPart& part : look_) {
    Placement place = space_from_body * part.body_from_mesh;
    place.linear() /= drawing_.unit;
    place.translation() = drawing_.point(place.translation());
    list.opaque.push_back({part.mesh, to_glm(place.matrix()), part.material, Faces::front});
  }
}

void Composer::add_vector(DrawList& list,
                          const Vec3& from,
                          const Vec3& tip,
                          const ArrowShape& shape,
                          const glm::vec3& color,
                          float gloss) const {
  add_arrow(list.opaque,
            arrows_,
            drawing_.point(from),
            drawing_.point(tip),
            times(shape, drawing_.length(scale_.body)),
            plain(color, gloss));
}

void Composer::add_axes(DrawList& list, const Sample& sample) const {
  const Vec3& from = sample.reference_S;
  for (int i = 0; i < 3; ++i) {
    if (shown_.axes) {
      const Vec3 tip = from + kBodyAxisLength * scale_.body * (sample.q_SB * Vec3::Unit(i));
      add_vector(list, from, tip, kAxisShape, theme_.body_axes, 0.2f);
    }
    if (shown_.space_axes) {
      const Vec3 tip = from + kSpaceAxisLength * scale_.body * Vec3::Unit(i);
      add_vector(list, from, tip, kAxisShape, theme_.space_axes, 0.1f);
    }
  }
}

void Composer::add_stand(DrawList& list) const {
  Placement place = Placement::Identity();
  const Vec3& up = motion_.model().up_S;
  const double size = drawing_.length(scale_.body);
  place.translation() = drawing_.point(-kStandHeight * scale_.body * up);
  place.linear() = Quat::FromTwoVectors(Vec3::UnitZ(), up).toRotationMatrix() *
                   (size * Vec3(kStandRadius, kStandRadius, kStandHeight)).asDiagonal();
  list.opaque.push_back(
      {arrows_.head, to_glm(place.matrix()), plain(theme_.stand, 0.3f), Faces::front});
}

// a stand under the pivot would be in the way of a body that hangs
bool Composer::stays_above_stand() const {
  const Vec3 axis_B = figure_axis_B();
  for (int i = 0; i <= kFramingTimes; ++i) {
    const Sample sample = motion_.at(motion_.duration() * i / kFramingTimes);
    if ((sample.q_SB * axis_B).dot(motion_.model().up_S) < -0.3) return false;
  }
  return true;
}

DrawList Composer::at(double t) const {
  const Sample sample = motion_.at(t);
  DrawList list;
  list.view = camera_.view(drawing_);
  list.background = theme_.background;
  if (shown_.body) add_body(list, sample);
  add_axes(list, sample);
  const Vec3& from = sample.reference_S;
  if (shown_.omega) add_vector(list, from, omega_tip(sample), kVectorShape, theme_.omega, 0.25f);
  if (shown_.momentum) {
    add_vector(list, from, momentum_tip(sample), kVectorShape, theme_.momentum, 0.25f);
  }
  if (shown_.pivot) add_stand(list);
  std::vector<Cone> cones = cones_at(sample);
  for (Cone& cone : cones) {
    cone.apex = drawing_.point(cone.apex);
    cone.slant = drawing_.length(cone.slant);
    cone.rim_radius = drawing_.length(cone.rim_radius);
  }
  add_cones(list, cones_, cones, drawing_.point(camera_.eye()));
  return list;
}

DrawingFrame Composer::make_drawing_frame() const {
  const Vec3 origin = motion_.at(0.0).reference_S;
  constexpr double kDigits = 1e-10;  // of double precision that a picture can spare
  if (scale_.body < kDigits * origin.norm()) {
    throw input_error("the body is too small ({:.3g} m) to be drawn {:.3g} m from the origin",
                      scale_.body,
                      origin.norm())
        .at({{}, 0, "motion.position"});
  }
  return {origin, scale_.body};
}

std::vector<std::string> Composer::warnings() const {
  std::vector<std::string> found;
  const std::vector<Vec3> points = points_to_frame();
  const auto seen = [&](const Vec3& point) {
    return camera_.sees(point);
  };
  if (std::none_of(points.begin(), points.end(), seen)) {
    found.emplace_back(
        "the camera sees nothing of the scene; without camera.eye it frames the film by itself");
    return found;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kFramingTimes; ++i) {
    const Sample sample = motion_.at(motion_.duration() * i / kFramingTimes);
    nearest = std::min(nearest, (camera_.eye() - sample.reference_S).norm());
  }
  if (shown_.body && nearest < scale_.body) {
    found.push_back(
        fmt::format("the camera comes within {:.3g} m of the body's middle, which reaches {:.3g} m",
                    nearest,
                    scale_.body));
  }
  if (shown_.body && scale_.body * camera_.pixels_per_metre(motion_.at(0.0).reference_S) < 0.5) {
    found.emplace_back("the body is smaller than a pixel at the start of the film");
  }
  return found;
}

std::vector<Vec3> Composer::points_to_frame() const {
  std::vector<Vec3> points;
  const std::vector<Vec3> body_B = shown_.body ? points_of(look_) : std::vector<Vec3>();
  for (int i = 0; i <= kFramingTimes; ++i) {
    const Sample sample = motion_.at(motion_.duration() * i / kFramingTimes);
    const Vec3 from = sample.reference_S;
    points.push_back(from);
    for (const Vec3& p : body_B) {
      points.push_back(from + sample.q_SB * (p - motion_.model().reference_B()));
    }
    if (shown_.omega) points.push_back(omega_tip(sample));
    if (shown_.momentum) points.push_back(momentum_tip(sample));
    for (int k = 0; k < 3; ++k) {
      if (shown_.axes) {
        points.push_back(from + kBodyAxisLength * scale_.body * (sample.q_SB * Vec3::Unit(k)));
      }
      if (shown_.space_axes)
        points.push_back(from + kSpaceAxisLength * scale_.body * Vec3::Unit(k));
    }

    // rims of the cones
    for (const Cone& cone : cones_at(sample)) {
      const Mat3 R = Quat::FromTwoVectors(Vec3::UnitZ(), cone.axis).toRotationMatrix();
      for (int k = 0; k < 24; ++k) {
        const double angle = 2.0 * kPi * k / 24;
        const double across = std::sin(cone.half_angle);
        points.push_back(cone.apex + cone.slant * (R * Vec3(across * std::cos(angle),
                                                            across * std::sin(angle),
                                                            std::cos(cone.half_angle))));
      }
    }
  }
  if (shown_.pivot) {
    points.push_back(-1.05 * kStandHeight * scale_.body * motion_.model().up_S);
  }
  return points;
}

Camera Composer::make_camera(const CameraSpec& spec, FrameSize size) const {
  const std::vector<Vec3> points = points_to_frame();
  if (!spec.eye) {
    const Vec3 direction = spec.direction.value_or(kDefaultDirection);
    if (direction.stableNorm() == 0.0) {
      throw input_error("must not be zero").at({{}, 0, "camera.direction"});
    }
    return framing_camera(points, spec.target, direction, spec.fov, size, kFrameMargin);
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

double attitude_tolerance(const CameraSpec& camera,
                          double pixels,
                          double body_radius,
                          FrameSize size) {
  // an automatic camera keeps everything that is drawn inside the frame, so a radian moves a point
  // by at most half a diagonal
  const double half_diagonal = 0.5 * std::hypot(size.width, size.height);
  if (!camera.eye) return pixels / half_diagonal;
  const double reach = kReach * body_radius;
  const double distance = (*camera.eye - camera.target.value_or(Vec3::Zero())).norm();
  if (!(distance > 0.0)) {
    throw input_error("must differ from camera.target").at({{}, 0, "camera.eye"});
  }
  const double nearest = std::max(distance - reach, 0.05 * distance);
  const double focal_px = 0.5 * size.height / std::tan(0.5 * camera.fov);
  return pixels * nearest / (focal_px * reach);
}

double body_radius(const std::vector<LookPart>& look, const Model& model) {
  double radius = 0.0;
  for (const Vec3& point : points_of(look)) {
    radius = std::max(radius, (point - model.reference_B()).norm());
  }
  return radius;
}

}  // namespace polhode
