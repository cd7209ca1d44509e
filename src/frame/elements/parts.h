// SPDX-License-Identifier: MIT
// Declares the elements and the helpers that they share. Private to frame/elements.cpp and
// frame/elements/.
#pragma once

#include <functional>
#include <string>

#include "frame/glyphs.h"
#include "frame/scenery.h"

namespace polhode {

// Sizes of arrows in units of the body's radius: {shaft radius, head radius, head length}. Heads
// are long for L and blunt for forces and torques. Of arrows that can be parallel, the shorter one
// is thicker, so that both are visible; L, which is thin, has a rim besides (rim_around()).
inline constexpr ArrowShape kOmegaShape{0.025, 0.064, 0.17};
inline constexpr ArrowShape kMomentumShape{0.018, 0.050, 0.23};
inline constexpr ArrowShape kForceShape{0.016, 0.066, 0.11};
inline constexpr ArrowShape kAxisShape{0.010, 0.030, 0.10};
inline constexpr ArrowShape kComponentShape{0.015, 0.042, 0.12};  // may lie along an axis
inline constexpr ArrowShape kFieldShape{0.008, 0.024, 0.08};
// The radius of tubes along rims and curves, in units of the body's radius.
inline constexpr double kRimRadius = 0.008;
// Polhodes, herpolhodes and Binet's curve are what their pictures are about.
inline constexpr double kCurveRadius = 0.016;

// How far the floor is below the middle of a free body, in units of the body's radius.
inline constexpr double kFreeFloor = 1.25;

inline constexpr double kSmallestCone = 1e-4;  // rad; narrower cones are not drawn

// An opaque material. color: sRGB-encoded, 0..1; gloss: see Material.
Material plain(const glm::vec3& color, float gloss);
// A translucent material with the opacity `alpha`, 0..1.
Material shell(const glm::vec3& color, float alpha);

// The material of a line whose parts behind bodies are drawn as ShowSpec::hidden says.
Material drawn_through(const Scenery& scenery, Material material);

// Adds an arrow from `from` to `end` (S, m), shortened as drawn_tip() says. `shape` is in units of
// the body's radius. With a name (markup), the arrow gets a label, which fades while the
// arrow is shorter than 0.18 times the body's radius and is gone below 0.08 times.
void add_vector(const Scenery& scenery,
                const Vec3& from,
                const Vec3& end,
                const ArrowShape& shape,
                const Material& material,
                Glyphs& glyphs,
                const std::string& name = {});
// Adds such an arrow to a place, which is drawn as far as that is.
void add_position(const Scenery& scenery,
                  const Vec3& from,
                  const Vec3& place,
                  const ArrowShape& shape,
                  const Material& material,
                  Glyphs& glyphs,
                  const std::string& name = {});
// How visible the name of an arrow of this length (m) is, 0..1.
float name_presence(const Scenery& scenery, double length);
// Adds such an arrow from the reference point to the reference point + `along` (S, m).
void add_at_reference(const Scenery& scenery,
                      const Sample& sample,
                      const Vec3& along,
                      const ArrowShape& shape,
                      const Material& material,
                      Glyphs& glyphs,
                      const std::string& name = {});
// How far the foot of the stand, or of the gimbals, is below the pivot, m.
double foot_depth(const Scenery& scenery);
// Whether the scene asks for gimbals, which carry the body in place of a stand.
bool in_gimbals(const Scenery& scenery);

// Maps points in B (from the body origin) to S at this moment, m.
Placement body_placement(const Scenery& scenery, const Sample& sample);
// Maps points in P (from the reference point) to S at this moment, m.
Placement principal_placement(const Scenery& scenery, const Sample& sample);
// Maps the unit ball to the ball around `center` (S, m); radius in m.
Placement ball_placement(const Vec3& center, double radius);
// Maps the unit disc about z to the disc around `center` (S, m) perpendicular to the unit vector
// `normal`; radius in m.
Placement disc_placement(const Vec3& center, const Vec3& normal, double radius);
// Adds `count` points of the rim of a disc to glyphs.reach, for framing.
void add_rim_reach(const Placement& disc, int count, Glyphs& glyphs);

// Adds pieces between `count` + 1 points (S, m), evenly spaced among those of a curve, to
// glyphs.lines. point(i): the i-th of `points`.
void add_line(const std::function<Vec3(std::size_t i)>& point,
              std::size_t points,
              std::size_t count,
              Glyphs& glyphs);

// Adds points to glyphs.reach whose convex hull contains the image of the unit ball and is hardly
// larger, for framing.
void add_ball_reach(const Placement& place, Glyphs& glyphs);

// Adds the name of a curve or a surface, smaller than those of vectors, at a little distance from
// the point `at` (S, m) in the direction `off`. fade: multiplies its opacity.
void add_name(const Scenery& scenery,
              const Vec3& at,
              const Vec3& off,
              const char* name,
              const glm::vec3& color,
              float fade,
              Glyphs& glyphs);

// Angular velocity in P, rad/s; and twice the kinetic energy of a rotation with it, J.
Vec3 principal_rate(const BodyModel& model, const Sample& sample);
double twice_the_energy(const BodyModel& model, const Vec3& w_P);

// Conditions that several elements share. needs_* return "" if the motion meets the condition, else
// what it needs. Cones need a symmetric top that turns freely, apart from damping of L, and about
// another axis than its own; free means that no torque acts and that the body is no thin rod and
// not at rest; forces are the forces, couples and springs of motion.torque. stays_above_stand:
// whether figure_axis_B() never points far below the horizontal; hovers: whether a free body of
// handy size stays where it is, kFreeFloor above a floor that nothing else needs or reaches.
std::string needs_cones(const Scenery& scenery);
std::string needs_pivot(const Scenery& scenery);
std::string needs_free(const Scenery& scenery);
std::string needs_forces(const Scenery& scenery);
std::string needs_table(const Scenery& scenery);
bool has_cones(const Scenery& scenery);
bool has_forces(const Scenery& scenery);
bool stays_above_stand(const Scenery& scenery);
bool hovers(const Scenery& scenery);

// The functions `add` of the table of elements (frame/elements.h); the rows in frame/elements.cpp
// say what each draws.
using Add = void(const Scenery& scenery, const Sample& sample, Glyphs& glyphs);
Add add_body, add_ghosts, add_ensemble;
Add add_body_axes, add_space_axes, add_fixed_frame;
Add add_omega, add_omega_components, add_euler_rates, add_sum, add_momentum, add_torque;
// The gravity gradient among the loads; null: the body is no satellite.
const Load* gradient_of(const Scenery& scenery);

Add add_velocity_field, add_forces, add_gravity, add_frame_rotation;
Add add_angles, add_tilt, add_space_cone, add_body_cone, add_precession_cone;
Add add_stand, add_hinge, add_gimbals, add_floor;
Add add_ellipsoid, add_plane, add_polhode, add_polhodes, add_herpolhode, add_binet, add_axis_plane;
Add add_trail, add_trail_sphere;
Add add_contact, add_slip, add_contact_trail;

// The lowest point of a body on a table, from the centre of mass, in P, m.
Vec3 lowest_point(const Motion& motion, const Sample& sample);

// From when on paths of the body are shown at the time t: as long as the scene lets them be, s.
double trail_begins(const Scenery& scenery, double t);
// Adds the part of a path in S between two times (s of motion). color: sRGB-encoded, 0..1.
void add_path(const Trail& trail, double from, double to, const glm::vec3& color, Glyphs& glyphs);
// The camera frames that part too.
void add_path_reach(const Trail& trail, double from, double to, Glyphs& glyphs);

}  // namespace polhode
