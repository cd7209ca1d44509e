// SPDX-License-Identifier: MIT
// The things that a picture can show, each a name in [show]: from the exact quantities of a moment
// to glyphs. One table; reading, help, the schema and the tests iterate it.
#pragma once

#include <string>
#include <vector>

#include "frame/body_look.h"
#include "frame/curves.h"
#include "frame/glyphs.h"
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

struct Element {
  std::string name;
  std::string doc;
  // is it shown when the scene does not say?
  bool (*by_default)(const Scenery& scenery);
  // "" when this motion has it, else the reason why not
  std::string (*why_not)(const Scenery& scenery);
  void (*add)(const Scenery& scenery, const Sample& sample, Glyphs& glyphs);
};

// Of two cones that touch, the first is listed first.
const std::vector<Element>& elements();

// Adds the named points: balls, with r from the reference point, and from the origin of space when
// the fixed frame is shown.
void add_points(const Scenery& scenery, const Sample& sample, bool from_origin, Glyphs& glyphs);

// Adds the paths of the named points.
void add_point_trails(const Scenery& scenery, const Sample& sample, Glyphs& glyphs);

// Where the tips of the two vectors are drawn, space, m.
Vec3 omega_tip(const Scenery& scenery, const Sample& sample);
Vec3 momentum_tip(const Scenery& scenery, const Sample& sample);

// Times that stand for the whole film, in order, the first 0 and the last its end.
std::vector<double> framing_times(const Motion& motion);

}  // namespace polhode
