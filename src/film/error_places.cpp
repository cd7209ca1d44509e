// SPDX-License-Identifier: MIT
#include "film/error_places.h"

namespace polhode {

Error placed(const Scene& scene, const Error& error) {
  const Place& place = error.place();
  if (place.key.empty() || !place.file.empty()) return error;
  const auto option = scene.options.find(place.key);
  if (option == scene.options.end()) {
    return error.at({scene.file, line_of(scene, place.key), {}});
  }
  return {error.fault(), error.message(), {{}, 0, option->second}};
}

}  // namespace polhode
