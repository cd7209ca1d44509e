// SPDX-License-Identifier: MIT
// The things that a picture can show, each a name in [show]: from the exact quantities of a moment
// to glyphs. One table; reading, help, the schema and the tests iterate it.
#pragma once

#include <string>
#include <vector>

#include "frame/glyphs.h"
#include "frame/scenery.h"

namespace polhode {

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

}  // namespace polhode
