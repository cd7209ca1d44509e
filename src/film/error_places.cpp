// SPDX-License-Identifier: MIT
#include "film/error_places.h"

namespace polhode {

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
  return error.at({scene.file, line_of(scene, place.key), {}});
}

}  // namespace polhode
