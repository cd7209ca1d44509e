// SPDX-License-Identifier: MIT
// Writes the data folder of a lecture, which lets others reproduce it: scenes, motions as
// tables, a manifest.
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
    std::shared_ptr<DeckScene> scene;  // never null
    std::string csv;                   // file in media/; empty: the motion could not be computed
  };
  const Deck* deck = nullptr;        // not owned, never null; read by write_data()
  std::string deck_text;             // contents of the file
  std::string licence;               // of the deck; empty: unknown
  std::vector<std::string> outputs;  // LectureOutput::name of those that are made
  std::string reveal_version;        // empty: no slides
  bool formula_font = false;         // the pages contain the formula font
  std::vector<SceneData> scenes;
  // Media::stem_of() and facts of each product that was made.
  std::vector<std::pair<std::string, Json>> products;
};

// Writes FOLDER/data: source/ (the deck, its scenes, meshes and pictures under their relative
// paths; files from outside the deck's folder under their names), motions/NAME.csv (copied from
// FOLDER/media), and manifest.json last. Files of source/ and motions/ that only the old manifest
// lists are deleted. Throws Error (input) as trusted_file(), mesh_files(), read_file() and
// write_file() do, (environment) if a folder cannot be made or the disk is full.
void write_data(const LectureData& data, const std::filesystem::path& folder);

}  // namespace polhode
