// SPDX-License-Identifier: MIT
// What a deck can have made of a scene, and the settings of that.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// What is made of a scene.
enum class PictureKind { film, loop, turn, still, compare, chart, stability, inspect };

// A setting that a picture may have in the deck: ![…](a.toml){.film NAME=VALUE}.
struct PictureSetting {
  std::string name;
  std::string doc;  // what it sets, with its unit, and the default in parentheses
};

// A class of pictures: what it makes of a scene and which settings it accepts. To add one:
// see ARCHITECTURE.md.
struct PictureClass {
  PictureKind kind;
  std::string name;  // the class in the deck, without its dot: "film"
  std::string doc;   // what it makes
  std::vector<PictureSetting> settings;
};
// All classes; docs/lecture.md documents them. The table exists until the program ends.
const std::vector<PictureClass>& picture_classes();

}  // namespace polhode
