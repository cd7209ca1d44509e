// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <fmt/format.h>

namespace polhode {

std::vector<std::string> mesh_names(const Scene& scene) {
  std::vector<std::string> names;
  const auto add = [&](const SolidSpec& solid) {
    if (solid.kind == "mesh" && solid.file) names.push_back(*solid.file);
  };
  if (scene.body.solid) add(*scene.body.solid);
  for (const auto& part : scene.body.parts)
    add(part);
  if (scene.body.look) add(*scene.body.look);
  return names;
}

std::vector<std::filesystem::path> input_files(const Scene& scene) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const Scene& one) {
    const std::filesystem::path file = one.file;
    files.push_back(file);
    for (const std::string& mesh : mesh_names(one))
      files.push_back(file.parent_path() / mesh);
  };
  if (scene.panels.empty()) {
    add(scene);
    return files;
  }
  files.emplace_back(scene.film_file);
  for (const ScenePanel& panel : scene.panels)
    add(panel.scene);
  return files;
}

double shown_duration(const Scene& scene) {
  const double count = scene.in_turn ? static_cast<double>(scene.panels.size()) : 1.0;
  return count * scene.motion.duration;
}

void refuse_panels(const Scene& scene) {
  if (scene.panels.empty()) return;
  throw input_error("is a film of {} scenes; name one of them, such as {}",
                    scene.panels.size(),
                    scene.panels.front().scene.file)
      .at({scene.film_file, 0, {}});
}

int line_of(const Scene& scene, const std::string& key) {
  std::string path = key;
  while (!path.empty()) {
    const auto found = scene.lines.find(path);
    if (found != scene.lines.end()) return found->second;
    const std::size_t end = path.find_last_of(".[");
    path = end == std::string::npos ? "" : path.substr(0, end);
  }
  return 0;
}

}  // namespace polhode
