// SPDX-License-Identifier: MIT
// What the elements of a picture are made of, and the elements themselves; seen by
// frame/elements.cpp and the files beside this one only.
#pragma once

#include <string>

#include "frame/glyphs.h"
#include "frame/scenery.h"

namespace polhode {

// Sizes of arrows, in units of the body's radius: heads are long for L, blunt for forces and
// torques. Where two are parallel, the shorter one is the thicker one: both are seen.
inline constexpr ArrowShape kOmegaShape{0.025, 0.064, 0.17};
inline constexpr ArrowShape kMomentumShape{0.018, 0.050, 0.23};
inline constexpr ArrowShape kForceShape{0.016, 0.066, 0.11};
inline constexpr ArrowShape kAxisShape{0.010, 0.030, 0.10};
inline constexpr ArrowShape kComponentShape{0.015, 0.042, 0.12};  // may lie along an axis
inline constexpr ArrowShape kFieldShape{0.008, 0.024, 0.08};
inline constexpr double kRimRadius = 0.008;  // of tubes along rims and curves

inline constexpr double kSmallestCone = 1e-4;  // rad; below this there is no wobble to draw

Material plain(const glm::vec3& color, float gloss);
Material shell(const glm::vec3& color, float alpha);

// `shape` is in units of the body's radius. With a name, the arrow gets a label.
void add_vector(const Scenery& scenery,
                const Vec3& from,
                const Vec3& end,
                const ArrowShape& shape,
                const Material& material,
                Glyphs& glyphs,
                const char* name = nullptr);
// The same from the reference point; `along` in m.
void add_at_reference(const Scenery& scenery,
                      const Sample& sample,
                      const Vec3& along,
                      const ArrowShape& shape,
                      const Material& material,
                      Glyphs& glyphs,
                      const char* name = nullptr);
// The axis that a picture follows, in body axes: of symmetry, else towards the centre of mass, else
// the third.
Vec3 figure_axis_B(const Scenery& scenery);

// From body axes to space at this moment, the body's origin included.
Placement body_placement(const Scenery& scenery, const Sample& sample);
// From principal axes about the reference point to space.
Placement principal_placement(const Scenery& scenery, const Sample& sample);
// The unit disc about z with its middle at `center`, square to `normal` (unit); radius in m.
Placement disc_placement(const Vec3& center, const Vec3& normal, double radius);
// So many points along its rim, for framing.
void add_rim_reach(const Placement& disc, int count, Glyphs& glyphs);

// Angular velocity in principal axes, rad/s, and twice the energy of turning with it, J.
Vec3 principal_rate(const BodyModel& model, const Sample& sample);
double twice_the_energy(const BodyModel& model, const Vec3& w_P);

// Conditions that several elements share: "" or why not.
std::string needs_cones(const Scenery& scenery);
std::string needs_pivot(const Scenery& scenery);
std::string needs_free(const Scenery& scenery);
std::string needs_forces(const Scenery& scenery);
bool has_cones(const Scenery& scenery);
bool has_forces(const Scenery& scenery);
bool stays_above_stand(const Scenery& scenery);

// Each adds one element.
using Add = void(const Scenery& scenery, const Sample& sample, Glyphs& glyphs);
Add add_body, add_ghosts;
Add add_body_axes, add_space_axes, add_fixed_frame;
Add add_omega, add_omega_components, add_euler_rates, add_momentum, add_torque;
Add add_velocity_field, add_forces, add_gravity;
Add add_angles, add_tilt, add_space_cone, add_body_cone, add_precession_cone;
Add add_stand, add_floor;
Add add_ellipsoid, add_plane, add_polhode, add_polhodes, add_herpolhode, add_binet, add_axis_plane;
Add add_trail, add_trail_sphere;

// The part of a path between two times, s.
void add_path(const Trail& trail, double from, double to, const glm::vec3& color, Glyphs& glyphs);

}  // namespace polhode
