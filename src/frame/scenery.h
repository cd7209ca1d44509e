// SPDX-License-Identifier: MIT
// What all moments of a film share: the body's look, scales, and the paths that are drawn.
#pragma once

#include <vector>

#include "frame/body_look.h"
#include "frame/curves.h"
#include "frame/theme.h"
#include "motion/motion.h"

namespace polhode {

// Lengths of what is drawn, in metres of the scene.
struct Scale {
  double body = 1.0;      // farthest drawn point of the body from the reference point
  double omega = 1.0;     // metres per rad/s
  double momentum = 1.0;  // metres per kg m^2/s
  double velocity = 1.0;  // metres per m/s
  double force = 1.0;     // metres per N
  double torque = 1.0;    // metres per N m
};

// Curves of a whole film, made once; those that the scene asks for.
struct Paths {
  Trail axis;                     // of the body's axis
  std::vector<Trail> points;      // of the points in ShowSpec::trail_points
  Trail herpolhode;               // of the tip of omega
  MeshPtr polhode, binet;         // in principal axes, in units of the body's radius
  std::vector<MeshPtr> polhodes;  // the same
};

// Where the path of the body's axis is drawn, in units of the body's radius.
inline constexpr double kTrailRadius = 1.25;
// The longest force and torque of a film.
inline constexpr double kForceLength = 0.8;

// What all moments of a film share.
struct Scenery {
  Motion motion;
  Theme theme;
  std::vector<LookPart> look = {};
  Scale scale = {};
  std::vector<Vec3> hull_B = {};          // of the look, m
  MeshPtr ball = {};                      // unit sphere, for small ones
  MeshPtr sphere = {};                    // the same, for large ones
  MeshPtr disc = {};                      // unit disc about z
  MeshPtr ring = {};                      // a thin tube along its rim
  MeshPtr stand = {};                     // unit cone, its apex under the pivot
  ShowSpec options = {};                  // as the scene gives them
  int segments = 96;                      // pieces of a circle as large as the frame
  std::vector<Vec3> field_points_B = {};  // where the velocity field is drawn, m
  Paths paths = {};
};

// Scales are chosen over the whole film, so that vectors keep theirs. segments: pieces of a full
// circle.
Scenery make_scenery(const Motion& motion,
                     const BodySpec& body,
                     const ThemeSpec& theme,
                     const ShowSpec& show,
                     int segments);

// Makes the look anew, with so many pieces of a circle as large as the body.
void make_look(Scenery& scenery, const BodySpec& body, int segments);

// The paths of the scenery's motion that its options ask for.
Paths make_paths(const Scenery& scenery);

// A vector of that length, m, as long as it is drawn: one that a failing method has blown up still
// fits single precision.
double drawn_length(const Scenery& scenery, double length);
// Where a vector ends that is drawn so.
Vec3 drawn_tip(const Scenery& scenery, const Vec3& from, const Vec3& end);

// Where the tips of the two vectors are drawn, space, m.
Vec3 omega_tip(const Scenery& scenery, const Sample& sample);
Vec3 momentum_tip(const Scenery& scenery, const Sample& sample);

// Times that stand for the whole film, in order, the first 0 and the last its end.
std::vector<double> framing_times(const Motion& motion);

}  // namespace polhode
