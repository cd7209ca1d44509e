// SPDX-License-Identifier: MIT
// The table of elements that a picture can show, each a key of [show]. An element turns the
// quantities of a moment into glyphs. The reader, help, the schema and the tests use this table.
#pragma once

#include <string>
#include <vector>

#include "frame/glyphs.h"
#include "frame/scenery.h"

namespace polhode {

// To add one: a function in frame/elements/ and a row in frame/elements.cpp.
struct Element {
  std::string name;
  std::string doc;
  // whether it is shown if the scene does not say
  bool (*by_default)(const Scenery& scenery);
  // "" if this motion has it, else the reason why not
  std::string (*why_not)(const Scenery& scenery);
  // adds its glyphs, in S, m
  void (*add)(const Scenery& scenery, const Sample& sample, Glyphs& glyphs);
};

// All elements. If two cones touch, the one listed first is drawn first.
const std::vector<Element>& elements();

// Adds the points of show.points as balls, with position vectors from the reference point and, if
// from_origin, from the origin of space.
void add_points(const Scenery& scenery, const Sample& sample, bool from_origin, Glyphs& glyphs);

// Adds the paths of show.trail_points.
void add_point_trails(const Scenery& scenery, const Sample& sample, Glyphs& glyphs);

}  // namespace polhode
