// SPDX-License-Identifier: MIT
// What a colleague needs to make a lecture again: motions as tables, scenes, a manifest.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lecture/products.h"

namespace polhode {

struct LectureData {
  struct SceneData {
    std::shared_ptr<DeckScene> scene;
    std::string csv;  // in media/; empty: the motion could not be found
  };
  const Deck* deck = nullptr;
  std::string deck_text;
  std::string licence;
  std::vector<std::string> outputs;
  std::string reveal_version;
  bool formula_font = false;  // inside the pages
  std::vector<SceneData> scenes;
  std::vector<std::pair<std::string, Json>> products;  // stem, facts
};

// Writes FOLDER/data: source/ (the deck, its scenes, their meshes and pictures, where they stood),
// motions/NAME.csv, manifest.json last. Files of earlier versions that the old manifest lists go.
// Throws Error (environment).
void write_data(const LectureData& data, const std::filesystem::path& folder);

}  // namespace polhode
