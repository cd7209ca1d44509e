// SPDX-License-Identifier: MIT
#include "lecture/data.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/hash.h"
#include "base/shell_word.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "base/version.h"
#include "film/report/motion_report.h"
#include "lecture/media.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

// A file of the deck: its name there, and where it is.
struct Source {
  std::string name;
  fs::path file;
};

// Where files of a deck go in source/: where they stood. Those from elsewhere, which are named by
// an absolute path or with "..", go by their names; if such a name is taken, all files of its
// folder go into a folder of their own, so that a scene still has its meshes beside it.
class Places {
 public:
  explicit Places(const std::vector<Source>& sources) {
    std::vector<std::pair<fs::path, std::set<fs::path>>> elsewhere;  // folders with their files
    for (const Source& source : sources) {
      if (!is_elsewhere(source.name)) {
        take(normal(source.name));
        continue;
      }
      const fs::path folder = folder_of(source);
      auto found = std::find_if(
          elsewhere.begin(), elsewhere.end(), [&](const auto& one) { return one.first == folder; });
      if (found == elsewhere.end()) found = elsewhere.insert(found, {folder, {}});
      found->second.insert(source.file.filename());
    }
    for (const auto& [folder, files] : elsewhere) {
      std::string place, name = folder.has_filename() ? folder.filename().string() : "root";
      for (; !is_free(place, files); name += "_")
        place = name;
      for (const fs::path& file : files)
        take(fs::path(place) / file);
      folders_[folder] = place;
    }
  }

  // `source` is one of those that this object was made for
  std::string of(const Source& source) const {
    const bool elsewhere = is_elsewhere(source.name);
    const fs::path place =
        elsewhere ? folders_.at(folder_of(source)) / source.file.filename() : normal(source.name);
    return "source/" + place.string();
  }

  // Whether all have their places: the deck and the scenes name them as they are.
  bool kept() const { return folders_.empty(); }

 private:
  static fs::path normal(const std::string& name) { return fs::path(name).lexically_normal(); }
  static bool is_elsewhere(const std::string& name) { return name.empty() || may_leave(name); }
  static fs::path folder_of(const Source& source) {
    std::error_code ignored;  // the file was found: so is its folder
    return fs::weakly_canonical(fs::absolute(source.file, ignored).parent_path(), ignored);
  }
  void take(const fs::path& file) {
    taken_files_.insert(file);
    for (fs::path folder = file.parent_path(); !folder.empty(); folder = folder.parent_path())
      taken_folders_.insert(folder);
  }
  bool is_free(const fs::path& folder, const std::set<fs::path>& files) const {
    if (taken_files_.contains(folder)) return false;
    return std::none_of(files.begin(), files.end(), [&](const fs::path& file) {
      return taken_files_.contains(folder / file) || taken_folders_.contains(folder / file);
    });
  }

  std::set<fs::path> taken_files_, taken_folders_;  // in source/
  std::map<fs::path, fs::path> folders_;            // elsewhere to source/
};

Json licences(const LectureData& data) {
  Json list = Json::array();
  list.push_back({{"what", "text and scenes of the deck"},
                  {"licence", data.licence.empty() ? "not told by the deck" : data.licence}});
  list.push_back({{"what", "styles and scripts of index.html, slides.html and handout.pdf"},
                  {"licence", "MIT (Polhode)"}});
  if (!data.three_version.empty()) {
    list.push_back(
        {{"what",
          fmt::format("three.js {}, inside index.html and slides.html", data.three_version)},
         {"licence", "MIT"}});
  }
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

// The files as they are written.
class DataFolder::Files {
 public:
  explicit Files(fs::path folder) : folder_(std::move(folder)) {}

  // of a file that a deck names in two ways, once
  void add(const std::string& name, const std::string& bytes) {
    if (!names_.insert(name).second) return;
    write(name, bytes);
    list_.push_back({{"name", name}, {"bytes", bytes.size()}, {"hash", content_hash(bytes)}});
  }

  void add_manifest(const std::string& text) { write(kManifest, text); }

  void commit() {
    forget_old();
    for (const std::unique_ptr<AtomicFile>& part : parts_)
      part->commit();
  }

  const Json& list() const { return list_; }

 private:
  static constexpr const char* kManifest = "manifest.json";

  void write(const std::string& name, const std::string& bytes) {
    const fs::path file = folder_ / name;
    make_folder(file.parent_path());
    parts_.push_back(std::make_unique<AtomicFile>(file));
    parts_.back()->write(bytes);
  }

  // removes what the manifest before this one lists and this one does not, unless somebody has
  // changed it since, or it is elsewhere, where a link leads
  void forget_old() const {
    const fs::path old = folder_ / kManifest;
    std::error_code missing;
    if (!fs::exists(old, missing)) return;
    const Json manifest = parse_foreign_json(read_file(old));
    if (!manifest.is_object() || !manifest.contains("files") || !manifest["files"].is_array())
      return;
    const fs::path here = fs::weakly_canonical(folder_, missing);
    for (const Json& file : manifest["files"]) {
      if (!file.is_object() || !file.contains("name") || !file["name"].is_string()) continue;
      const std::string name = file["name"];
      const fs::path path = name;
      const bool ours = (name.starts_with("source/") || name.starts_with("motions/")) &&
                        std::find(path.begin(), path.end(), "..") == path.end() &&
                        fs::weakly_canonical(folder_ / path, missing) == here / path;
      if (ours && !names_.contains(name) && is_as_listed(folder_, file))
        fs::remove(folder_ / path, missing);
    }
  }

  fs::path folder_;
  std::vector<std::unique_ptr<AtomicFile>> parts_;
  Json list_ = Json::array();
  std::set<std::string> names_;
};

DataFolder::DataFolder(const LectureData& data, const fs::path& folder)
    : files_(std::make_unique<Files>(folder / "data")) {
  Files& out = *files_;
  const DeckRoot& root = data.deck->root;
  const std::string deck_name = fs::path(data.deck->file).filename().string();
  std::vector<Source> sources = {{deck_name, data.deck->file}};
  for (const std::string& image : data.deck->images)
    sources.push_back({image, trusted_file(root, root.folder, image)});
  for (const LectureData::SceneData& one : data.scenes) {
    const DeckScene& scene = *one.scene;
    sources.push_back({scene.name, scene.file});
    for (const std::string& mesh : named_files(scene.file)) {
      sources.push_back({(fs::path(scene.name).parent_path() / mesh).string(),
                         trusted_file(root, scene.file.parent_path(), mesh)});
    }
  }
  const Places places(sources);
  out.add("source/" + deck_name, data.deck_text);
  for (auto source = sources.begin() + 1; source != sources.end(); ++source) {
    const auto shown = data.images.find(source->name);
    out.add(places.of(*source),
            read_file(shown == data.images.end() ? source->file : folder / shown->second));
  }
  // what was just read is what the pictures show
  for (const LectureData::SceneData& one : data.scenes)
    check_unchanged(*one.scene);

  Json scenes = Json::array();
  std::set<std::string> taken;
  for (const LectureData::SceneData& one : data.scenes) {
    const DeckScene& scene = *one.scene;
    Json row = {{"scene", places.of({scene.name, scene.file})},
                {"title", scene.scene.title},
                {"scene_hash", scene.hash}};
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
    products.push_back({{"name", stem},
                        {"kind", facts.value("kind", "")},
                        {"files", facts.at("files")},
                        {"warnings", facts.at("warnings")}});
  }
  std::string to;
  for (const std::string& output : data.outputs)
    to += (to.empty() ? "" : ",") + output;
  std::string options;
  const auto add_option = [&](const char* name, const std::optional<std::string>& value) {
    if (value) options += fmt::format(" {} {}", name, shell_word(*value));
  };
  add_option("--size", data.settings.size);
  add_option("--fps", data.settings.fps);
  add_option("--theme", data.settings.theme);
  if (data.settings.quality != LectureSettings{}.quality)
    add_option("--quality", data.settings.quality);
  const std::string rebuild =
      fmt::format("cd data/source && polhode lecture {} -o ../../again --to {}{}",
                  shell_word(deck_name),
                  to,
                  options);
  const Json manifest = {
      {"deck", "source/" + deck_name},
      {"deck_hash", content_hash(data.deck_text)},
      {"program", "polhode " + program_version()},
      {"versions", versions()},
      {"rebuild", places.kept() ? Json(rebuild) : Json(nullptr)},
      {"licences", licences(data)},
      {"columns",
       "t,qw,qx,qy,qz,wx,wy,wz,Lx,Ly,Lz,x,y,z,energy: s, attitude body to space, rad/s in body "
       "axes, "
       "kg m^2/s in space axes, m, J"},
      {"scenes", scenes},
      {"files", out.list()},
      {"pictures", products}};
  out.add_manifest(manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

DataFolder::~DataFolder() = default;

void DataFolder::commit() {
  files_->commit();
}

}  // namespace polhode
