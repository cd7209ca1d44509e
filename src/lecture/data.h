// SPDX-License-Identifier: MIT
// Writes the data folder of a lecture, which lets others reproduce it: scenes, motions as
// tables, a manifest.
#pragma once

#include <filesystem>
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
    std::string csv;  // file in FOLDER/media; empty: the motion could not be computed
  };
  const Deck* deck = nullptr;                 // not owned, never null; read by DataFolder()
  std::string deck_text;                      // contents of the file
  std::string licence;                        // of the deck, as its author words it; empty: unknown
  std::map<std::string, std::string> images;  // Deck::images -> FOLDER/ what documents show
  // LectureOutput::name (lecture/lecture.h) of those that are made, for the command in the manifest
  // that makes the lecture again
  std::vector<std::string> outputs;
  LectureSettings settings;    // likewise
  std::string reveal_version;  // empty: no slides
  std::string three_version;   // empty: nothing is to be turned
  bool formula_font = false;   // the pages contain Latin Modern Math
  std::vector<SceneData> scenes;
  // Media::stem_of() of each product that was made, and its facts as Media::obtain() returns them
  // (lecture/media.h): "files" is required, "kind" is used.
  std::vector<std::pair<std::string, Json>> products;
};

// FOLDER/data: source/ (the deck, its scenes, meshes and pictures under their relative paths; files
// from outside the deck's folder under their names or, if such a name is taken, those of its folder
// in a folder of their own), motions/NAME.csv (copied from FOLDER/media; NAME is the name of the
// scene file without its ending, with _ appended until it is unique), and manifest.json.
class DataFolder {
 public:
  // Writes all of it, but no file has its name before commit(). Throws Error (input) as
  // trusted_file() (lecture/deck/sandbox.h), named_files() (scene/scene.h), check_unchanged(),
  // read_file() and AtomicFile (base/system/atomic_file.h) do, (environment) if a folder cannot be
  // made or the disk is full.
  DataFolder(const LectureData& data, const std::filesystem::path& folder);
  ~DataFolder();
  DataFolder(const DataFolder&) = delete;
  DataFolder& operator=(const DataFolder&) = delete;

  // Gives the files their names, the manifest last, and deletes those of source/ and motions/ that
  // only the old manifest lists. Call it once. Throws Error (environment) if the disk tells so late
  // that it is full.
  void commit();

 private:
  class Files;
  std::unique_ptr<Files> files_;
};

}  // namespace polhode
