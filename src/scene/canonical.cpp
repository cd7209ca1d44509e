// SPDX-License-Identifier: MIT
#include "scene/canonical.h"

#include <array>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "base/json.h"
#include "model/solids.h"
#include "scene/keys.h"
#include "scene/scene_file.h"
#include "scene/to_json.h"

namespace polhode {
namespace {

// The visitor that prints a spec as a JSON object.
class Canonical {
 public:
  template <class T>
  void field(const char* name, T& member, const Doc&) {
    put(name, member);
  }
  template <class T>
  void required(const char* name, T& member, const Doc&) {
    put(name, member);
  }
  template <class A, class B>
  void merged(const char* name, A& a, B& b, const Doc&) {
    Canonical both;
    fields(both, a);
    fields(both, b);
    json_[name] = both.json_;
  }
  void exactly_one_of(const std::vector<std::string>&) {}
  void at_most_one_of(const std::vector<std::string>&) {}

  const Json& json() const { return json_; }

 private:
  template <class T>
  static Json printed(T& value) {
    if constexpr (IsSpec<T>) {
      Canonical inside;
      fields(inside, value);
      return inside.json_;
    } else {
      return to_json_value(value);
    }
  }
  template <class T>
  static Json printed(std::vector<T>& list) {
    Json json = Json::array();
    for (T& element : list)
      json.push_back(printed(element));
    return json;
  }

  template <class T>
  void put(const char* name, T& value) {
    Json json = printed(value);
    // an empty table says no more than an absent one, and some tables must not be empty
    if (IsSpec<T> && json.empty()) return;
    json_[name] = std::move(json);
  }
  template <class T>
  void put(const char* name, std::optional<T>& value) {
    if (value) json_[name] = printed(*value);
  }
  template <class T>
  void put(const char* name, std::vector<T>& list) {
    if (!list.empty()) json_[name] = printed(list);
  }

  Json json_ = Json::object();
};

// JSON as a value of TOML
std::string inline_toml(const Json& json) {
  if (!json.is_structured()) return json.dump();
  std::string text;
  for (const auto& [key, value] : json.items()) {
    if (!text.empty()) text += ", ";
    if (json.is_object()) text += key + " = ";
    text += inline_toml(value);
  }
  return json.is_array() ? fmt::format("[{}]", text) : fmt::format("{{ {} }}", text);
}

}  // namespace

Json scene_to_json(const Scene& scene) {
  // visitors may write, so they get a copy
  Scene copy = scene;
  Canonical canonical;
  fields(canonical, copy);
  return canonical.json();
}

Scene scene_from_json(const Json& json, const std::string& name) {
  std::string text;
  for (const auto& [key, value] : json.items()) {
    text += fmt::format("{} = {}\n", key, inline_toml(value));
  }
  Scene scene = parse_scene(text, name);
  load_meshes(scene.body, std::filesystem::path(name).parent_path());
  return scene;
}

std::string scene_hash(const Scene& scene) {
  if (!scene.panels.empty()) {
    std::string all =
        fmt::format("{}\n{} {}\n", Json(scene.title).dump(), scene.same_cameras, scene.same_scales);
    if (scene.in_turn) all += "in turn\n";
    // what the panels share
    all += scene_to_json(scene).dump() + "\n";
    for (const ScenePanel& panel : scene.panels)
      all += Json(panel.caption).dump() + scene_hash(panel.scene) + "\n";
    return content_hash(all);
  }
  std::string content = scene_to_json(scene).dump();
  // what the files hold counts, not only their names
  const auto add = [&](const SolidSpec& solid) {
    if (!solid.mesh) return;
    for (const Vec3& point : solid.mesh->points)
      content.append(reinterpret_cast<const char*>(point.data()), sizeof(Vec3));
    for (const std::array<int, 3>& triangle : solid.mesh->triangles)
      content.append(reinterpret_cast<const char*>(triangle.data()), sizeof triangle);
  };
  if (scene.body.solid) add(*scene.body.solid);
  for (const SolidSpec& part : scene.body.parts)
    add(part);
  if (scene.body.look) add(*scene.body.look);
  return content_hash(content);
}

}  // namespace polhode
