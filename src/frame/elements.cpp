// SPDX-License-Identifier: MIT
#include "frame/elements.h"

#include <algorithm>
#include <cmath>

#include "frame/elements/parts.h"

namespace polhode {
namespace {

bool always(const Scenery&) {
  return true;
}
bool on_table(const Scenery& scenery) {
  return scenery.motion.model().table.has_value();
}
bool never(const Scenery&) {
  return false;
}
bool on_pivot(const Scenery& scenery) {
  return scenery.motion.model().on_pivot;
}
// Does the body go round the vertical? A pendulum that swings in a plane has no such cone.
bool precesses(const Scenery& scenery) {
  const BodyModel& model = scenery.motion.model();
  if (!model.on_pivot) return false;
  double about_vertical = 0.0, most = 0.0;
  for (const double t : framing_times(scenery.motion)) {
    const Vec3 L = scenery.motion.at(t).L_S;
    about_vertical = std::max(about_vertical, std::abs(L.dot(model.up_S)));
    most = std::max(most, L.norm());
  }
  return about_vertical > 1e-9 * most;
}
std::string nothing_against(const Scenery&) {
  return {};
}
std::string needs_ensemble(const Scenery& scenery) {
  return scenery.ensemble.empty() ? "needs motion.ensemble" : "";
}
std::string needs_weight(const Scenery& scenery) {
  return scenery.motion.model().chi_P.squaredNorm() > 0.0
             ? ""
             : "needs a pivot, and gravity that acts beside it";
}

std::string needs_parts(const Scenery& scenery) {
  return asks_for(scenery, "euler_rates") || asks_for(scenery, "omega_components")
             ? ""
             : "needs euler_rates or omega_components";
}

std::string needs_frame_rotation(const Scenery& scenery) {
  return frame_rotation_of(scenery.motion.model()) ? "" : "needs motion.frame_rotation";
}

bool in_orbit(const Scenery& scenery) {
  return gradient_of(scenery) != nullptr;
}

std::string needs_weight_or_orbit(const Scenery& scenery) {
  return in_orbit(scenery) ? "" : needs_weight(scenery);
}

}  // namespace

// Long, because it is one table: a row for each.
const std::vector<Element>& elements() {
  static const std::vector<Element> table = {
      {"body", "the body", always, nothing_against, add_body},
      {"ghosts",
       "earlier positions of the body, at equal intervals of time",
       never,
       nothing_against,
       add_ghosts},
      {"ensemble",
       "the axes of the motions of motion.ensemble, as points, and some of their bodies, pale",
       [](const Scenery& scenery) { return !scenery.ensemble.empty(); },
       needs_ensemble,
       add_ensemble},
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
      {"sum",
       "dashed lines that add up euler_rates, else omega_components, to the angular velocity",
       [](const Scenery& scenery) { return asks_for(scenery, "euler_rates"); },
       needs_parts,
       add_sum},
      {"momentum", "angular momentum", always, nothing_against, add_momentum},
      {"torque", "torque about the reference point", never, nothing_against, add_torque},
      {"space_cone",
       "the cone that omega traces in space (symmetric free top)",
       has_cones,
       needs_cones,
       add_space_cone},
      {"body_cone",
       "the cone that omega traces in the body (symmetric free top)",
       has_cones,
       needs_cones,
       add_body_cone},
      {"axis_plane",
       "the plane that contains L, omega and the axis (symmetric free top)",
       never,
       needs_cones,
       add_axis_plane},
      {"precession_cone",
       "the cone about the vertical that passes through the body's axis (pivot)",
       precesses,
       needs_pivot,
       add_precession_cone},
      {"ellipsoid",
       "the energy ellipsoid, which rolls on the invariable plane (free body)",
       never,
       needs_free,
       add_ellipsoid},
      {"plane",
       "the invariable plane, perpendicular to L (free body)",
       never,
       needs_free,
       add_plane},
      {"polhode",
       "the curve of omega in the body, on the ellipsoid (free body)",
       never,
       needs_free,
       add_polhode},
      {"polhodes",
       "polhodes of other motions with the same energy, and the separatrix (free body)",
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
       "the sphere that contains the path of the body's axis",
       never,
       nothing_against,
       add_trail_sphere},
      {"pivot",
       "the stand under the fixed point",
       [](const Scenery& scenery) {
         return on_pivot(scenery) && stays_above_stand(scenery) && !in_gimbals(scenery);
       },
       needs_pivot,
       add_stand},
      {"hinge",
       "the fixed point, as a ball (pivot)",
       [](const Scenery& scenery) {
         return on_pivot(scenery) && !stays_above_stand(scenery) && !in_gimbals(scenery);
       },
       needs_pivot,
       add_hinge},
      {"gimbals",
       "two rings that carry the axle of the body, the outer one on a stand (pivot)",
       never,
       needs_pivot,
       add_gimbals},
      {"floor",
       "a floor, with the shadow of the body and its stand",
       [](const Scenery& scenery) {
         if (on_table(scenery)) return true;
         // on dark ground the shadow would hardly be seen, and a floor costs a fifth of a frame
         if (!on_pivot(scenery)) return hovers(scenery) && is_light(scenery.theme.background);
         return needs_weight(scenery).empty() &&
                (in_gimbals(scenery) || stays_above_stand(scenery));
       },
       nothing_against,
       add_floor},
      {"contact",
       "the point where the body touches the table, with normal force and friction (table)",
       on_table,
       needs_table,
       add_contact},
      {"slip",
       "the velocity at which the body slips on the table (table)",
       never,
       needs_table,
       add_slip},
      {"contact_trail",
       "the path of the contact on the table and on the body (table)",
       on_table,
       needs_table,
       add_contact_trail},
      {"forces",
       "the forces of motion.torque at their points of action, springs as coils",
       has_forces,
       needs_forces,
       add_forces},
      {"gravity",
       "the weight on the centre of mass: on a pivot downwards, of a satellite to the Earth",
       in_orbit,
       needs_weight_or_orbit,
       add_gravity},
      {"frame_rotation",
       "the axis about which space turns (motion.frame_rotation)",
       [](const Scenery& scenery) { return needs_frame_rotation(scenery).empty(); },
       needs_frame_rotation,
       add_frame_rotation},
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
