// SPDX-License-Identifier: MIT
#include "frame/elements.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frame/elements/parts.h"

namespace polhode {
namespace {

// lengths of the longest vectors of a film, in units of the body's radius
constexpr double kOmegaLength = 1.3;
constexpr double kMomentumLength = kReachOfVectors;
constexpr double kVelocityLength = 0.6;

constexpr int kFramingTimes = 240;
constexpr std::size_t kFieldPoints = 48;

// points spread over the body: each the farthest from those before it
std::vector<Vec3> spread(const std::vector<Vec3>& points, std::size_t count) {
  std::vector<Vec3> chosen;
  if (points.empty()) return chosen;
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  std::size_t next = 0;
  while (chosen.size() < std::min(count, points.size())) {
    chosen.push_back(points[next]);
    for (std::size_t i = 0; i < points.size(); ++i)
      nearest[i] = std::min(nearest[i], (points[i] - chosen.back()).squaredNorm());
    next = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) -
                                    nearest.begin());
    if (nearest[next] == 0.0) break;
  }
  return chosen;
}

// the longest vector of the film has the full length; a body at rest has none to scale
Scale make_scale(const Scenery& scenery, double radius) {
  const BodyModel& model = scenery.motion.model();
  double turning = 0.0, momentum = 0.0, speed = 0.0, force = 0.0, turned_by = 0.0;
  for (const double t : framing_times(scenery.motion)) {
    const Sample sample = scenery.motion.at(t);
    for (const Load& load : model.loads.listed) {
      const Quat q_SP = sample.q_SB * Quat(model.R_BP);
      force = std::max(force, point_force(load, t, q_SP, sample.reference_S).norm());
    }
    turned_by = std::max(turned_by, torque(model, t, scenery.motion.state_at(t)).norm());
    turning = std::max(turning, sample.w_S.norm());
    momentum = std::max(momentum, sample.L_S.norm());
    for (const Vec3& r_B : scenery.field_points_B)
      speed = std::max(speed, point_velocity(model, sample, r_B).norm());
  }
  const auto per = [&](double length, double most) {
    return most > 0.0 ? length * radius / most : 0.0;
  };
  return {radius,
          per(kOmegaLength, turning),
          per(kMomentumLength, momentum),
          per(kVelocityLength, speed),
          per(kForceLength, force),
          per(kForceLength, turned_by)};
}

bool always(const Scenery&) {
  return true;
}
bool never(const Scenery&) {
  return false;
}
bool on_pivot(const Scenery& scenery) {
  return scenery.motion.model().on_pivot;
}
std::string nothing_against(const Scenery&) {
  return {};
}
std::string needs_weight(const Scenery& scenery) {
  return scenery.motion.model().chi_P.squaredNorm() > 0.0
             ? ""
             : "needs gravity that acts beside the pivot";
}

}  // namespace

std::vector<double> framing_times(const Motion& motion) {
  std::vector<double> times;
  for (int i = 0; i <= kFramingTimes; ++i)
    times.push_back(motion.duration() * i / kFramingTimes);
  return times;
}

void make_look(Scenery& scenery, const BodySpec& body, int segments) {
  scenery.look = body_look(body, scenery.motion.model(), scenery.theme, segments);
  for (LookPart& part : scenery.look)
    part.material.finish = finish_named(scenery.options.material);
}

Scenery make_scenery(const Motion& motion,
                     const BodySpec& body,
                     const ThemeSpec& theme_spec,
                     const ShowSpec& show,
                     int segments) {
  const Theme theme = make_theme(theme_spec);
  const auto shared = [](Mesh mesh) {
    return std::make_shared<const Mesh>(std::move(mesh));
  };
  Scenery scenery{motion, theme};
  scenery.options = show;
  scenery.segments = segments;
  make_look(scenery, body, segments);
  scenery.ball = shared(unit_sphere(std::max(16, segments / 4)));
  // what surrounds the body may be as large as the frame, and bends in two directions
  const int large = segments * 3 / 2;
  scenery.sphere = shared(unit_sphere(large));
  scenery.stand = shared(unit_cone(segments));
  scenery.disc = shared(unit_disc(large));
  scenery.ring = shared(torus(1.0, 0.006, large));
  scenery.hull_B = hull_of(scenery.look);
  scenery.field_points_B = spread(scenery.hull_B, kFieldPoints);
  double radius = body_radius(scenery.look, motion.model());
  for (const std::vector<Vec3>* points : {&show.points, &show.trail_points}) {
    for (const Vec3& point : *points)
      radius = std::max(radius, (point - motion.model().reference_B()).norm());
  }
  scenery.scale = make_scale(scenery, radius);
  scenery.paths = make_paths(scenery);
  return scenery;
}

Vec3 omega_tip(const Scenery& scenery, const Sample& sample) {
  return drawn_tip(
      scenery, sample.reference_S, sample.reference_S + scenery.scale.omega * sample.w_S);
}

Vec3 momentum_tip(const Scenery& scenery, const Sample& sample) {
  return drawn_tip(
      scenery, sample.reference_S, sample.reference_S + scenery.scale.momentum * sample.L_S);
}

const std::vector<Element>& elements() {
  static const std::vector<Element> table = {
      {"body", "the body", always, nothing_against, add_body},
      {"ghosts", "the body where it was, at equal times back", never, nothing_against, add_ghosts},
      {"axes", "body axes", never, nothing_against, add_body_axes},
      {"space_axes",
       "space axes, from the reference point",
       always,
       nothing_against,
       add_space_axes},
      {"omega", "angular velocity", always, nothing_against, add_omega},
      {"omega_components",
       "angular velocity along the body axes",
       never,
       nothing_against,
       add_omega_components},
      {"euler_rates",
       "angular velocity about the vertical, the line of nodes and the third body axis",
       never,
       nothing_against,
       add_euler_rates},
      {"momentum", "angular momentum", always, nothing_against, add_momentum},
      {"torque", "torque about the reference point", never, nothing_against, add_torque},
      {"space_cone",
       "the cone that omega draws in space (symmetric free top)",
       has_cones,
       needs_cones,
       add_space_cone},
      {"body_cone",
       "the cone that omega draws in the body (symmetric free top)",
       has_cones,
       needs_cones,
       add_body_cone},
      {"axis_plane",
       "the plane that L, omega and the axis of a symmetric free top share",
       never,
       needs_cones,
       add_axis_plane},
      {"precession_cone",
       "the cone about the vertical through the body axis (pivot)",
       on_pivot,
       needs_pivot,
       add_precession_cone},
      {"ellipsoid",
       "the energy ellipsoid, that rolls on the invariable plane (free body)",
       never,
       needs_free,
       add_ellipsoid},
      {"plane", "the invariable plane, square to L (free body)", never, needs_free, add_plane},
      {"polhode",
       "the curve of omega in the body, on the ellipsoid (free body)",
       never,
       needs_free,
       add_polhode},
      {"polhodes",
       "polhodes of other motions with the same energy (free body)",
       never,
       needs_free,
       add_polhodes},
      {"herpolhode",
       "the curve of omega in space, on the plane (free body)",
       never,
       needs_free,
       add_herpolhode},
      {"binet",
       "Binet's ellipsoid and the sphere of |L|, with the curve of L in the body (free body)",
       never,
       needs_free,
       add_binet},
      {"trail", "the path of the body's axis", never, nothing_against, add_trail},
      {"trail_sphere",
       "the sphere on which the body's axis writes",
       never,
       nothing_against,
       add_trail_sphere},
      {"pivot",
       "the stand under the fixed point",
       [](const Scenery& scenery) { return on_pivot(scenery) && stays_above_stand(scenery); },
       needs_pivot,
       add_stand},
      {"floor", "a floor with the body's shadow", never, nothing_against, add_floor},
      {"forces",
       "the forces of motion.torque where they act, springs as rods",
       has_forces,
       needs_forces,
       add_forces},
      {"gravity", "the weight on the centre of mass (pivot)", never, needs_weight, add_gravity},
      {"velocity_field",
       "velocities V + Omega x r of points of the body, as small arrows",
       never,
       nothing_against,
       add_velocity_field},
      {"fixed_frame",
       "space axes at the origin of space, and R from there to the reference point",
       never,
       nothing_against,
       add_fixed_frame},
      {"angles",
       "the angle between each space axis and its body axis, as an arc",
       never,
       nothing_against,
       add_angles},
      {"tilt",
       "the angle theta between the vertical and the body's axis",
       never,
       nothing_against,
       add_tilt},
  };
  return table;
}

std::vector<ShowName> show_names() {
  std::vector<ShowName> names;
  for (const Element& element : elements())
    names.push_back({element.name, element.doc});
  return names;
}

std::vector<std::string> element_names() {
  std::vector<std::string> names;
  for (const Element& element : elements())
    names.push_back(element.name);
  return names;
}

}  // namespace polhode
