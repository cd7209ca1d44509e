// SPDX-License-Identifier: MIT
#include "base/system/files.h"

#include <algorithm>
#include <system_error>

#include "base/system/system_error.h"

namespace polhode {
namespace fs = std::filesystem;

std::vector<fs::path> entries_of(const fs::path& folder, Fault fault) {
  std::vector<fs::path> found;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed))
    found.push_back(it->path());
  if (failed) {
    const Error error = system_error(failed.value(), "cannot be read");
    const bool lacks = error.fault() == Fault::environment;
    throw Error(lacks ? error.fault() : fault, error.message(), {folder.string(), 0, {}});
  }
  std::sort(found.begin(), found.end());
  return found;
}

fs::path working_folder() {
  std::error_code failed;
  fs::path folder = fs::current_path(failed);
  if (failed) {
    throw environment_error("the working folder cannot be found: {}; change to another folder",
                            failed.message());
  }
  return folder;
}

fs::path absolute_path(const fs::path& file) {
  const fs::path whole = file.is_absolute() ? file : working_folder() / file;
  return whole.lexically_normal();
}

bool is_there(const fs::path& file) {
  std::error_code failed;
  const bool there = fs::exists(file, failed);
  if (failed) {
    throw system_error(failed.value(), "cannot be looked at").at({file.string(), 0, {}});
  }
  return there;
}

void make_folder(const fs::path& folder, const Place& place) {
  const std::string what = fmt::format("cannot make the folder '{}'", folder.string());
  std::error_code failed;
  fs::create_directories(folder, failed);
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return;
  if (fs::exists(folder, ignored))
    throw input_error("{}: there is a file of that name", what).at(place);
  throw system_error(failed.value(), what).at(place);
}

void move_file(const fs::path& from, const fs::path& to) {
  std::error_code failed;
  fs::rename(from, to, failed);
  if (failed) throw environment_error("cannot write '{}': {}", to.string(), failed.message());
}

void remove_file(const fs::path& file) {
  std::error_code failed;
  fs::remove_all(file, failed);
  if (failed) throw environment_error("cannot remove '{}': {}", file.string(), failed.message());
}

}  // namespace polhode
