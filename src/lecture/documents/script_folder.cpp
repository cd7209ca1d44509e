// SPDX-License-Identifier: MIT
#include "lecture/documents/script_folder.h"

#include <algorithm>
#include <cstdlib>

#include "base/system/atomic_file.h"
#include "lecture/deck/deck.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

std::string value_of_variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::optional<fs::path> find_script_folder(const char* variable,
                                           const std::string& name,
                                           const std::vector<std::string>& files) {
  const fs::path within = fs::path("polhode") / name;
  std::vector<fs::path> places;
  if (const std::string own = value_of_variable(variable); !own.empty()) places.emplace_back(own);
  if (const std::string data = value_of_variable("XDG_DATA_HOME"); !data.empty())
    places.push_back(data / within);
  if (const std::string home = value_of_variable("HOME"); !home.empty())
    places.push_back(fs::path(home) / ".local/share" / within);
  places.push_back("/usr/local/share" / within);
  places.push_back("/usr/share" / within);
  for (const fs::path& place : places) {
    const bool whole = std::all_of(files.begin(), files.end(), [&](const std::string& file) {
      std::error_code missing;
      return fs::is_regular_file(place / file, missing);
    });
    if (whole) return place;
  }
  return {};
}

std::string version_of_scripts(const fs::path& folder) {
  std::error_code missing;
  const fs::path file = folder / "package.json";
  const Json package =
      Json::parse(fs::is_regular_file(file, missing) ? read_file(file) : "{}", nullptr, false);
  const bool told =
      package.is_object() && package.contains("version") && package["version"].is_string();
  return told ? package["version"].get<std::string>() : "of unknown version";
}

std::string licence_of_scripts(const fs::path& folder) {
  std::error_code missing;
  const fs::path file = folder / "LICENSE";
  return fs::is_regular_file(file, missing) ? read_file(file) : "";
}

std::string safe_in_script(std::string js) {
  for (std::size_t at = js.find("</script"); at != std::string::npos; at = js.find("</script", at))
    js.replace(at, 2, "<\\/");
  return js;
}

}  // namespace polhode
