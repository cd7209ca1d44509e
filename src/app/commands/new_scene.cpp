// SPDX-License-Identifier: MIT
#include "app/commands/new_scene.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/ranges.h>

#include "base/at_place.h"
#include "base/error.h"
#include "base/nearest.h"
#include "base/one_line.h"
#include "base/shell_word.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"

namespace polhode {

const std::vector<NewKind>& new_kinds() {
  static const std::vector<NewKind> table = {
      {"free_top", "a symmetric body in free flight, with its cones", {"free_top.toml"}},
      {"heavy_top", "a wooden top on its tip", {"heavy_top.toml"}},
      {"racket", "a tennis racket that flips over", {"racket.toml"}},
      {"table_top", "a tippe top on a table, which turns over", {"table_top.toml"}},
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

[[noreturn]] void refuse(const std::string& why) {
  throw input_error("{}; give another name or folder with -o", why).at({{}, 0, "--output"});
}

// what polhode would not take up again under that name
void refuse_name(const NewKind& kind, const std::filesystem::path& first) {
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
  std::vector<std::pair<std::filesystem::path, std::string>> missing;  // files and their templates
  std::string kept;
  for (const std::string name : found->files) {
    const bool is_first = name == found->files[0];
    const std::filesystem::path file = is_first ? first : first.parent_path() / name;
    std::error_code unknown;
    if (!std::filesystem::exists(std::filesystem::symlink_status(file, unknown))) {
      missing.emplace_back(file, name);
    } else if (is_first) {
      refuse(fmt::format("{} is already there", one_line(file.string())));
    } else if (is_there(file) && read_file(file) == template_files().at(name)) {
      kept = fmt::format(" (with the {} that was there)", one_line(file.string()));
    } else {
      refuse(fmt::format("{} is already there, and is not the scene that the {} needs",
                         one_line(file.string()),
                         kind));
    }
  }
  // all of them, or none
  std::vector<std::unique_ptr<AtomicFile>> files;
  std::vector<std::string> written;
  for (const auto& [file, name] : missing) {
    files.push_back(std::make_unique<AtomicFile>(file));
    files.back()->write(template_files().at(name));
    written.push_back(one_line(file.string()));
  }
  for (const auto& file : files)
    file->commit();
  const char* command = first.extension() == ".md" ? "lecture" : "render";
  return fmt::format("{}{}; next: polhode {} {}",
                     fmt::join(written, ", "),
                     kept,
                     command,
                     shell_word(first.string()));
}

}  // namespace polhode
