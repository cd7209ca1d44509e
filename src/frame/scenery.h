// SPDX-License-Identifier: MIT
// What all moments of a film share: the body's meshes, the scales of vectors, and the drawn paths.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "frame/body_look.h"
#include "frame/curves.h"
#include "frame/theme.h"
#include "model/figure_axis.h"
#include "motion/motion.h"

namespace polhode {

// How long quantities are drawn: metres of space per unit of the quantity, 0 for a quantity that is
// zero in the whole film.
struct Scale {
  double body = 1.0;      // "the body's radius": distance of the farthest point of the body, of
                          // show.points or of show.trail_points from the reference point, m
  double omega = 1.0;     // metres per rad/s
  double momentum = 1.0;  // metres per kg m^2/s
  double velocity = 1.0;  // metres per m/s
  double force = 1.0;     // metres per N
  double torque = 1.0;    // metres per N m
  double weight = 1.0;    // the length of the weight, m
  double slip = 0.0;      // metres per m/s of slip on a table
};

// What of the whole motion the pictures of a film draw, made once: the curves that the scene asks
// for; those that it does not ask for, and curves that are a single point, are empty or null.
struct Paths {
  Trail axis;                  // of the body's axis
  std::vector<Trail> points;   // of the points in ShowSpec::trail_points
  std::vector<Trail> contact;  // of the lowest point of a body on a table, each time it touches
  std::vector<Trail> contact_on_body;  // the same on the body, in B
  Trail omega_tip, momentum_tip;       // of the vectors in ShowSpec::trail_tips
  Trail herpolhode;                    // of the tip of omega, in space
  double herpolhode_radius = 0.0;      // how far it goes from the line of L, m
  // The curves of omega on the inertia ellipsoid and of L on Binet's ellipsoid, in principal axes
  // from the reference point, in units of the body's radius.
  MeshPtr polhode, binet;
  std::vector<MeshPtr> polhodes;        // family of polhodes, likewise
  std::vector<MeshPtr> separatrix;      // the two that part them; empty if two moments are equal
  Vec3 on_separatrix_P = Vec3::Zero();  // where its name stands, rad/s
};

// The radius of the sphere on which the path of the body's axis is drawn, in units of the body's
// radius.
inline constexpr double kTrailRadius = 1.25;
// The length of the longest force and of the longest torque of a film, in units of the body's
// radius.
inline constexpr double kForceLength = 0.8;
// The height of the stand under a pivot, in units of the body's radius, unless the body comes
// lower.
inline constexpr double kStandHeight = 0.55;
// The radii of the gimbal rings around the pivot, in units of the body's radius: the inner one
// holds the axle of the body, the outer one stands on the floor and turns about the vertical.
inline constexpr double kInnerGimbal = 1.07;
inline constexpr double kOuterGimbal = 1.17;

// Half the width of the lines of the dial on the floor, in its radius, unless that is too thin for
// the pixels.
inline constexpr double kDialLine = 0.007;

// The usual length of the axes of space, in units of the body's radius.
inline constexpr double kSpaceAxisLength = 1.2;

// What all moments of a film share. A value: copies share only the meshes, which never change.
struct Scenery {
  Motion motion;
  Theme theme;
  std::vector<LookPart> look = {};
  Scale scale = {};
  double thickness = 1.0;              // of arrows, as a multiple of what their shapes say
  double stand_height = kStandHeight;  // in units of the body's radius
  // Of the axes of space, likewise: one that a vector goes along all the time ends beyond it.
  std::array<double, 3> axis_lengths = {kSpaceAxisLength, kSpaceAxisLength, kSpaceAxisLength};
  Vec3 table_middle = Vec3::Zero();  // of where a body goes on its table, S, m
  double table_reach = 0.0;          // how far it goes from there, m
  bool table_goes_along = false;     // a camera follows it, so that only the table around is seen
  std::vector<Vec3> hull_B = {};     // hull_of(look), m
  MeshPtr ball = {};                 // unit sphere, coarse, for points
  MeshPtr sphere = {};               // unit sphere, fine
  MeshPtr disc = {};                 // unit disc about z
  MeshPtr ring = {};                 // a thin tube along the rim of the disc
  MeshPtr stand = {};                // stand_mesh() (frame/stand.h)
  MeshPtr rough_stand = {};          // the same, for its shadow
  MeshPtr gimbal = {};               // a round tube along the rim of the disc
  MeshPtr rough_gimbal = {};         // the same, for its shadow
  MeshPtr dial = {};                 // dial() (frame/mesh.h)
  double dial_line = kDialLine;      // half the width of its lines, in its radius
  ShowSpec options = {};             // the [show] table
  int segments = 96;                 // pieces of a circle as large as the picture
  int body_segments = 96;            // pieces of a circle as large as the body is ever drawn
  std::vector<Vec3> field_points_B = {};  // points of the velocity field, m
  Paths paths = {};
  std::vector<Motion> ensemble = {};  // motions beside it, of the same model and duration
};

// Makes the scenery. `body` is that of the motion. Scales are chosen for the whole film, so that
// they stay constant, unless `scale` gives them. segments: straight pieces that stand for a circle
// as large as the picture. Throws Error (input) as body_look and make_theme do, and (check_failed)
// as Motion::at does.
Scenery make_scenery(const Motion& motion,
                     const BodySpec& body,
                     const ThemeSpec& theme,
                     const ShowSpec& show,
                     int segments,
                     const std::optional<Scale>& scale = {});

// One scale for several pictures side by side: bodies and thicknesses as large as the largest body
// has them, and no vector longer than in a picture by itself.
Scale common_scale(const std::vector<Scale>& scales);

// Whether the scene asks for an element (frame/elements.h) by name.
bool asks_for(const Scenery& scenery, const std::string& element);

// Replaces the body's meshes by ones with `segments` pieces of a full circle. Throws Error (input)
// as body_look does.
void make_look(Scenery& scenery, const BodySpec& body, int segments);

// The paths and names of scenery.motion that scenery.options asks for. Throws Error (check_failed)
// as Motion::at does.
Paths make_paths(const Scenery& scenery);

// `length` (m), at most 50 times the body's radius, so that vectors of a diverging integration
// still fit into single precision.
double drawn_length(const Scenery& scenery, double length);
// The tip of a vector from `from` to `end` (S, m) with its length limited in the same way.
Vec3 drawn_tip(const Scenery& scenery, const Vec3& from, const Vec3& end);

// The drawn tips of angular velocity and angular momentum, S, m.
Vec3 omega_tip(const Scenery& scenery, const Sample& sample);
Vec3 momentum_tip(const Scenery& scenery, const Sample& sample);

// Times (s of motion) from 0 to the end (scattered_times() in motion/deviation.h) at which the film
// looks at the motion for scales, elements and shutter.
std::vector<double> framing_times(const Motion& motion);
// The greatest angular speed at these times, rad/s. Throws Error (check_failed) as Motion::at does.
double fastest_turn(const Motion& motion);

}  // namespace polhode
