// SPDX-License-Identifier: MIT
#include "app/commands/new_scene.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/at_place.h"
#include "base/error.h"
#include "base/nearest.h"
#include "base/system/atomic_file.h"

namespace polhode {

const std::vector<NewKind>& new_kinds() {
  static const std::vector<NewKind> table = {
      {"free_top", "a symmetric body in free flight, with its cones", {"free_top.toml"}},
      {"heavy_top", "a wooden top on its tip", {"heavy_top.toml"}},
      {"racket", "a tennis racket that flips over", {"racket.toml"}},
      {"gyroscope", "a wheel with a level axle on a stand", {"gyroscope.toml"}},
      {"comparison", "one motion by three methods, side by side", {"comparison.toml"}},
      {"film",
       "two scenes side by side in one film, with their scene",
       {"film.toml", "heavy_top.toml"}},
      {"deck", "a lecture of three slides, with its scene", {"deck.md", "heavy_top.toml"}},
  };
  return table;
}

namespace {

// what polhode would not take up again under that name
void refuse_name(const NewKind& kind, const std::filesystem::path& first) {
  const auto refuse = [](const std::string& why) {
    throw input_error("{}; give another name", why).at({{}, 0, "--output"});
  };
  const std::filesystem::path usual = kind.files.front();
  if (first.extension() != usual.extension())
    refuse(fmt::format("the name of a {} ends in {}", kind.name, usual.extension().string()));
  for (std::size_t i = 1; i < kind.files.size(); ++i) {
    if (first.filename() == kind.files[i])
      refuse(fmt::format("the scene of the {} is called {}", kind.name, kind.files[i]));
  }
}

}  // namespace

std::string write_new(const std::string& kind, const std::filesystem::path& output) {
  const std::vector<NewKind>& kinds = new_kinds();
  const auto found = std::find_if(
      kinds.begin(), kinds.end(), [&](const NewKind& row) { return row.name == kind; });
  if (found == kinds.end()) {
    std::vector<std::string> names(kinds.size());
    std::transform(
        kinds.begin(), kinds.end(), names.begin(), [](const NewKind& row) { return row.name; });
    throw input_error("nothing is called '{}'{}", kind, suggestion(kind, names)).at({{}, 0, "new"});
  }
  const std::filesystem::path first = output.empty() ? found->files.front() : output;
  refuse_name(*found, first);
  std::string written, kept;
  for (std::size_t i = 0; i < found->files.size(); ++i) {
    const std::filesystem::path file = i == 0 ? first : first.parent_path() / found->files[i];
    std::error_code unknown;
    const bool taken = std::filesystem::exists(std::filesystem::symlink_status(file, unknown));
    // a deck may stand beside a scene that has been changed
    if (taken && i > 0) {
      kept = fmt::format(" (with the {} that was there)", file.string());
      continue;
    }
    if (taken) {
      throw input_error("{} is already there; give another name with -o", file.string())
          .at({{}, 0, "--output"});
    }
    write_file(file, template_files().at(found->files[i]));
    written += fmt::format("{}{}", written.empty() ? "" : ", ", file.string());
  }
  const char* command = first.extension() == ".md" ? "lecture" : "render";
  return fmt::format("{}{}; next: polhode {} {}", written, kept, command, first.string());
}

}  // namespace polhode
