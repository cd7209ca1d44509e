// SPDX-License-Identifier: MIT
// Angles, and the cones that axes and vectors draw.
#include <cmath>

#include "frame/elements/parts.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr double kPrecessionSlant = 1.2;
constexpr double kAngleRadius = 0.55;
constexpr double kSideLength = 1.12;    // of the sides of an angle, in the radius of its arc
constexpr double kSideRadius = 0.0065;  // in that of the body: inside the rod of a trail
constexpr double kNarrowCone = 0.08;    // radius of the rim, in that of the body; narrower: no name

// an angle: an arc between two directions, and what it is measured from and to
void add_arc(const Scenery& scenery,
             const Sample& sample,
             const Vec3& from,
             const Vec3& to,
             double radius,
             Glyphs& glyphs) {
  const double angle = angle_between(from, to);
  if (angle < 1e-3 || angle > kPi - 1e-3) return;
  glyphs.arcs.push_back({sample.reference_S,
                         from,
                         to,
                         radius * scenery.scale.body,
                         0.6 * kAxisShape.shaft_radius * scenery.scale.body,
                         drawn_through(scenery, plain(scenery.theme.position, 0.1f))});
  // its sides, thin: inside the shafts of axes that are drawn too
  for (const Vec3& side : {from, to}) {
    glyphs.rods.push_back({sample.reference_S,
                           sample.reference_S + kSideLength * radius * scenery.scale.body * side,
                           kSideRadius * scenery.scale.body,
                           drawn_through(scenery, plain(scenery.theme.position, 0.1f))});
  }
}

void add_cone(const Scenery& scenery,
              const Sample& sample,
              const Vec3& axis,
              double half_angle,
              double slant,
              const Material& material,
              Glyphs& glyphs) {
  if (half_angle < kSmallestCone || slant <= 0.0) return;
  glyphs.cones.push_back(
      {sample.reference_S, axis, half_angle, slant, kRimRadius * scenery.scale.body, material});
}

// Around the rim; where nobody seeks a place for it, as in models, opposite to the line on which
// omega lies: there the rim is far from its arrow and the other cone.
void name_rim(const Scenery& scenery,
              const Sample& sample,
              const Vec3& axis,
              const char* name,
              const glm::vec3& color,
              Glyphs& glyphs) {
  const Vec3 tip =
      drawn_length(scenery, scenery.scale.omega * sample.w_S.norm()) * sample.w_S.normalized();
  const Vec3 across = tip - tip.dot(axis) * axis;
  if (across.norm() < kNarrowCone * scenery.scale.body) return;
  add_name(scenery, sample.reference_S + tip - 2.0 * across, -across, name, color, 1.0f, glyphs);
  glyphs.labels.back().circle =
      CircleGlyph{sample.reference_S + tip - across, across, axis.cross(across)};
}

}  // namespace

// between each axis of space and that of the body with the same number
void add_angles(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  for (int i = 0; i < 3; ++i) {
    add_arc(scenery,
            sample,
            Vec3::Unit(i),
            sample.q_SB * Vec3::Unit(i),
            kAngleRadius + 0.12 * i,
            glyphs);
  }
}

// between the vertical and the body's axis, theta
void add_tilt(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3& up = scenery.motion.model().up_S;
  const Vec3 figure = sample.q_SB * figure_axis_B(scenery.motion.model());
  const std::size_t before = glyphs.arcs.size();
  add_arc(scenery, sample, up, figure, 1.05, glyphs);
  if (glyphs.arcs.size() == before || angle_between(up, figure) < 0.1) return;
  const Vec3 middle = point_of(glyphs.arcs.back(), 0.5);
  glyphs.labels.push_back(
      {middle, 0.2 * (middle - sample.reference_S), "<i>θ</i>", scenery.theme.position});
}

// the two cones touch along omega and end at its tip
void add_space_cone(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  add_cone(scenery,
           sample,
           sample.L_S.normalized(),
           angle_between(sample.L_S, sample.w_S),
           drawn_length(scenery, scenery.scale.omega * sample.w_S.norm()),
           shell(scenery.theme.space_cone, 0.30f),
           glyphs);
  name_rim(
      scenery, sample, sample.L_S.normalized(), "space cone", scenery.theme.space_cone, glyphs);
}

void add_body_cone(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3 figure = sample.q_SB * figure_axis_B(scenery.motion.model());
  const Vec3 axis = figure.dot(sample.w_S) < 0.0 ? Vec3(-figure) : figure;
  add_cone(scenery,
           sample,
           axis,
           angle_between(axis, sample.w_S),
           drawn_length(scenery, scenery.scale.omega * sample.w_S.norm()),
           shell(scenery.theme.body_cone, 0.30f),
           glyphs);
  name_rim(scenery, sample, axis, "body cone", scenery.theme.body_cone, glyphs);
}

// about the vertical, through the body axis of this moment; a flat disc where that is level, and
// about the other direction beyond
void add_precession_cone(const Scenery& scenery, const Sample& sample, Glyphs& glyphs) {
  const Vec3 figure = sample.q_SB * figure_axis_B(scenery.motion.model());
  const Vec3& up = scenery.motion.model().up_S;
  const Vec3 axis = figure.dot(up) < 0.0 ? Vec3(-up) : up;
  add_cone(scenery,
           sample,
           axis,
           angle_between(axis, figure),
           kPrecessionSlant * scenery.scale.body,
           shell(scenery.theme.precession_cone, 0.20f),
           glyphs);
}

}  // namespace polhode
