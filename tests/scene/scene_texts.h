// SPDX-License-Identifier: MIT
// Scenes that must be read and scenes that must be refused, shared by the tests of the reader, of
// the canonical form and of the schema.
#pragma once

#include <string>
#include <vector>

#include "scene/reader.h"
#include "scene/scene_file.h"

namespace polhode {

// a body that is right, in two lines
inline const std::string kBody = "[body]\nmoments = [1, 2, 3]\n";

// the scene of a text, which errors call test.toml
inline Scene read(const std::string& text) {
  return parse_scene(text, "test.toml");
}

inline std::string repeated(const std::string& piece, int times) {
  std::string text;
  for (int i = 0; i < times; ++i)
    text += piece;
  return text;
}

struct SceneText {
  std::string name;
  std::string text;
};

// A scene that must be refused, and the line and dotted key that the error must name.
struct BadSceneText {
  std::string name;
  std::string text;
  int line = 0;  // 0: the fault is an absence in the whole file
  std::string key;
  std::string message;     // a part of it
  bool schema_too = true;  // false: what a schema cannot say
};

std::vector<SceneText> good_scenes();
std::vector<BadSceneText> bad_scenes();

}  // namespace polhode
