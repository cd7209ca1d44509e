// SPDX-License-Identifier: MIT
// The table of elements that a picture can show, each a key of [show]. An element turns the
// quantities of a moment into glyphs. The reader, help, the schema and the tests use this table.
#pragma once

#include <string>
#include <vector>

#include "frame/glyphs.h"
#include "frame/scenery.h"

namespace polhode {

// A row of the table. To add an element: a function in frame/elements/ and a row in
// frame/elements.cpp. The functions are pure, may be called from any thread, and throw Error
// (check_failed) as Motion::at (motion/motion.h) does.
struct Element {
  std::string name;  // key of [show], and in the lists `show` and `hide` of a story
  std::string doc;   // one phrase for help and the schema
  // Whether it is shown if the scene does not say.
  bool (*by_default)(const Scenery& scenery);
  // "" if this motion has the element, else the reason why not.
  std::string (*why_not)(const Scenery& scenery);
  // Adds the glyphs of the element at the moment of `sample`, in S, m. Call it only if why_not() is
  // empty.
  void (*add)(const Scenery& scenery, const Sample& sample, Glyphs& glyphs);
};

// All elements; the table exists until the program ends. If two cones touch, the one listed first
// is drawn first.
const std::vector<Element>& elements();

// Adds the points of show.points at the moment of `sample` as balls, with position vectors from the
// reference point and, if from_origin, also from the origin of space.
void add_points(const Scenery& scenery, const Sample& sample, bool from_origin, Glyphs& glyphs);

// Adds the paths of show.trail_points up to the moment of `sample`, for the time ShowSpec::trail_s
// before it.
void add_point_trails(const Scenery& scenery, const Sample& sample, Glyphs& glyphs);
// Adds the paths of the tips of the vectors in show.trail_tips likewise, in their colours.
void add_tip_trails(const Scenery& scenery, const Sample& sample, Glyphs& glyphs);

}  // namespace polhode
