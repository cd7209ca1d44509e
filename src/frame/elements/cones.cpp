// SPDX-License-Identifier: MIT
// Angles, and the cones that axes and vectors draw.
#include <cmath>

#include "frame/elements/parts.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr double kPrecessionSlant = 1.2;
constexpr double kAngleRadius = 0.55;
constexpr double kWidestCone = 0.995 * kPi / 2.0;

void add_arc(const Stage& stage,
             const Sample& sample,
             const Vec3& from,
             const Vec3& to,
             double radius,
             Marks& marks) {
  const double angle = angle_between(from, to);
  if (angle < 1e-3 || angle > kPi - 1e-3) return;
  marks.arcs.push_back({sample.reference_S,
                        from,
                        to,
                        radius * stage.scale.body,
                        0.6 * kAxisShape.shaft_radius * stage.scale.body,
                        plain(stage.theme.position, 0.1f)});
}

void add_cone(const Stage& stage,
              const Sample& sample,
              const Vec3& axis,
              double half_angle,
              double slant,
              const Material& material,
              Marks& marks) {
  if (half_angle < kSmallestCone || half_angle > kWidestCone) return;
  marks.cones.push_back(
      {sample.reference_S, axis, half_angle, slant, kRimRadius * stage.scale.body, material});
}

}  // namespace

// between each axis of space and that of the body with the same number
void add_angles(const Stage& stage, const Sample& sample, Marks& marks) {
  for (int i = 0; i < 3; ++i) {
    add_arc(
        stage, sample, Vec3::Unit(i), sample.q_SB * Vec3::Unit(i), kAngleRadius + 0.12 * i, marks);
  }
}

// between the vertical and the body's axis, theta
void add_tilt(const Stage& stage, const Sample& sample, Marks& marks) {
  const Vec3& up = stage.motion.model().up_S;
  const Vec3 figure = sample.q_SB * figure_axis_B(stage);
  const std::size_t before = marks.arcs.size();
  add_arc(stage, sample, up, figure, 1.05, marks);
  if (marks.arcs.size() == before || angle_between(up, figure) < 0.1) return;
  const Vec3 middle = point_of(marks.arcs.back(), 0.5);
  marks.labels.push_back(
      {middle, 0.2 * (middle - sample.reference_S), "<i>θ</i>", stage.theme.position});
}

// the two cones touch along omega and end at its tip
void add_space_cone(const Stage& stage, const Sample& sample, Marks& marks) {
  add_cone(stage,
           sample,
           sample.L_S.normalized(),
           angle_between(sample.L_S, sample.w_S),
           drawn_length(stage, stage.scale.omega * sample.w_S.norm()),
           shell(stage.theme.space_cone, 0.30f),
           marks);
}

void add_body_cone(const Stage& stage, const Sample& sample, Marks& marks) {
  const Vec3 figure = sample.q_SB * figure_axis_B(stage);
  const Vec3 axis = figure.dot(sample.w_S) < 0.0 ? Vec3(-figure) : figure;
  add_cone(stage,
           sample,
           axis,
           angle_between(axis, sample.w_S),
           drawn_length(stage, stage.scale.omega * sample.w_S.norm()),
           shell(stage.theme.body_cone, 0.30f),
           marks);
}

// about the vertical, through the body axis of this moment
void add_precession_cone(const Stage& stage, const Sample& sample, Marks& marks) {
  const Vec3 figure = sample.q_SB * figure_axis_B(stage);
  const Vec3& up = stage.motion.model().up_S;
  const Vec3 axis = figure.dot(up) < 0.0 ? Vec3(-up) : up;
  add_cone(stage,
           sample,
           axis,
           angle_between(axis, figure),
           kPrecessionSlant * stage.scale.body,
           shell(stage.theme.precession_cone, 0.20f),
           marks);
}

}  // namespace polhode
