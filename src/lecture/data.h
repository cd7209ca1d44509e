// SPDX-License-Identifier: MIT
// Writes the data folder of a lecture, which lets others reproduce it: scenes, motions as tables, a
// manifest.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lecture/products.h"

namespace polhode {

// What the folder is made from.
struct LectureData {
  struct SceneData {
    std::shared_ptr<DeckScene> scene;
    std::string csv;  // file in media/; empty: the motion could not be computed
  };
  const Deck* deck = nullptr;
  std::string deck_text;
  std::string licence;
  std::vector<std::string> outputs;
  std::string reveal_version;
  bool formula_font = false;  // the pages contain the formula font
  std::vector<SceneData> scenes;
  std::vector<std::pair<std::string, Json>> products;  // stem and facts of each
};

// Writes FOLDER/data: source/ (the deck, its scenes, meshes and pictures under their relative
// paths), motions/NAME.csv, and manifest.json last. Files that only the old manifest lists are
// deleted. Throws Error (environment), and (input) as write_file does.
void write_data(const LectureData& data, const std::filesystem::path& folder);

}  // namespace polhode
