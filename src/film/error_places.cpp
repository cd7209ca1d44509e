// SPDX-License-Identifier: MIT
#include "film/error_places.h"

namespace polhode {
namespace {

// What the command line says of body and motion, for errors about them that name another key.
std::string settings_beside(const Scene& scene, const std::string& key) {
  const auto is_mechanics = [](const std::string& path) {
    return path.starts_with("body") || path.starts_with("motion");
  };
  std::string given;
  for (const auto& [path, place] : scene.options) {
    if (is_mechanics(key) && is_mechanics(path) && place.key.starts_with("--set"))
      given += (given.empty() ? " (with " : ", ") + place.key;
  }
  return given.empty() ? "" : given + ")";
}

}  // namespace

Error placed(const Scene& scene, const Error& error) {
  const Place& place = error.place();
  if (place.key.empty() || !place.file.empty()) return error;
  // the option may have given a table around the key
  for (std::string path = place.key; !path.empty();) {
    const auto option = scene.options.find(path);
    if (option != scene.options.end()) {
      const std::string inside = path == place.key ? "" : place.key + ": ";
      return {error.fault(), inside + error.message(), option->second};
    }
    const std::size_t end = path.find_last_of(".[");
    path = end == std::string::npos ? "" : path.substr(0, end);
  }
  const std::string message = error.message() + settings_beside(scene, place.key);
  return {error.fault(), message, {scene.file, line_of(scene, place.key), place.key}};
}

}  // namespace polhode
