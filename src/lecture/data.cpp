// SPDX-License-Identifier: MIT
#include "lecture/data.h"

#include <algorithm>
#include <set>

#include "base/hash.h"
#include "base/system/atomic_file.h"
#include "base/version.h"
#include "film/report/motion_report.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

// The data folder as it is written.
class DataFolder {
 public:
  explicit DataFolder(fs::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& name, const std::string& bytes) {
    std::error_code failed;
    const fs::path file = folder_ / name;
    fs::create_directories(file.parent_path(), failed);
    if (failed) {
      throw environment_error(
          "cannot make the folder '{}': {}", file.parent_path().string(), failed.message());
    }
    write_file(file, bytes);
    files_.push_back({{"name", name}, {"bytes", bytes.size()}, {"hash", content_hash(bytes)}});
    names_.insert(name);
  }

  // removes what the manifest before this one lists and this one does not
  void forget_old() const {
    const fs::path old = folder_ / "manifest.json";
    std::error_code missing;
    if (!fs::exists(old, missing)) return;
    const Json manifest = Json::parse(read_file(old), nullptr, false);
    if (!manifest.is_object() || !manifest.contains("files") || !manifest["files"].is_array())
      return;
    for (const Json& file : manifest["files"]) {
      const std::string name = file.is_object() ? file.value("name", "") : "";
      const fs::path path = name;
      const bool ours = (name.starts_with("source/") || name.starts_with("motions/")) &&
                        std::find(path.begin(), path.end(), "..") == path.end();
      if (ours && !names_.contains(name)) fs::remove(folder_ / path, missing);
    }
  }

  const Json& files() const { return files_; }

 private:
  fs::path folder_;
  Json files_ = Json::array();
  std::set<std::string> names_;
};

// where a file of the deck goes in source/: where it stood, or by its name if that was elsewhere
std::string place_of(const std::string& name) {
  const fs::path path = fs::path(name).lexically_normal();
  const bool elsewhere = path.is_absolute() || path.begin() == path.end() || *path.begin() == "..";
  return "source/" + (elsewhere ? path.filename() : path).string();
}

Json licences(const LectureData& data) {
  Json list = Json::array();
  list.push_back({{"what", "text and scenes of the deck"},
                  {"licence", data.licence.empty() ? "not told by the deck" : data.licence}});
  list.push_back({{"what", "styles and scripts of index.html, slides.html and handout.pdf"},
                  {"licence", "MIT (Polhode)"}});
  if (!data.reveal_version.empty()) {
    list.push_back({{"what", fmt::format("reveal.js {}, inside slides.html", data.reveal_version)},
                    {"licence", "MIT"}});
  }
  if (data.formula_font) {
    list.push_back(
        {{"what", "Latin Modern Math, inside the pages"}, {"licence", "GUST Font License"}});
  }
  list.push_back({{"what", "Inter, Nimbus Roman, DejaVu as drawn in pictures"},
                  {"licence", "fonts' own; pictures made with them are free"}});
  return list;
}

}  // namespace

void write_data(const LectureData& data, const fs::path& folder) {
  DataFolder out(folder / "data");
  const DeckRoot& root = data.deck->root;
  const std::string deck_name = fs::path(data.deck->file).filename().string();
  out.add("source/" + deck_name, data.deck_text);
  for (const std::string& image : data.deck->images)
    out.add(place_of(image), read_file(trusted_file(root, root.folder, image)));

  Json scenes = Json::array();
  std::set<std::string> taken;
  for (const LectureData::SceneData& one : data.scenes) {
    const DeckScene& scene = *one.scene;
    out.add(place_of(scene.name), read_file(scene.file));
    for (const std::string& mesh : mesh_files(scene.file)) {
      const std::string beside = (fs::path(scene.name).parent_path() / mesh).string();
      out.add(place_of(beside), read_file(trusted_file(root, scene.file.parent_path(), mesh)));
    }
    Json row = {
        {"scene", place_of(scene.name)}, {"title", scene.scene.title}, {"scene_hash", scene.hash}};
    if (!one.csv.empty()) {
      std::string name = scene.file.stem().string();
      while (!taken.insert(name).second)
        name += "_";
      out.add("motions/" + name + ".csv", read_file(folder / "media" / one.csv));
      row["motion"] = "motions/" + name + ".csv";
    }
    scenes.push_back(row);
  }

  Json products = Json::array();
  for (const auto& [stem, facts] : data.products) {
    products.push_back(
        {{"name", stem}, {"kind", facts.value("kind", "")}, {"files", facts.at("files")}});
  }
  std::string to;
  for (const std::string& output : data.outputs)
    to += (to.empty() ? "" : ",") + output;
  const Json manifest = {
      {"deck", "source/" + deck_name},
      {"deck_hash", content_hash(data.deck_text)},
      {"program", "polhode " + program_version()},
      {"versions", versions()},
      {"rebuild",
       fmt::format("cd data/source && polhode lecture '{}' -o ../../again --to {}", deck_name, to)},
      {"licences", licences(data)},
      {"columns",
       "t,qw,qx,qy,qz,wx,wy,wz,Lx,Ly,Lz,x,y,z,energy: s, attitude body to space, rad/s in body "
       "axes, "
       "kg m^2/s in space axes, m, J"},
      {"scenes", scenes},
      {"files", out.files()},
      {"pictures", products}};
  out.forget_old();
  write_file(folder / "data/manifest.json",
             manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace polhode
