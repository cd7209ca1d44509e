// SPDX-License-Identifier: MIT
// The command `new`: writes a commented scene to start from.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace polhode {

// What can be written.
struct NewKind {
  const char* name;
  const char* doc;                 // a phrase
  std::vector<const char*> files;  // of template_files(); the first gets the name that is asked for
};
// All kinds. To add one: a row in app/commands/new_scene.cpp, and its files in src/app/templates/.
const std::vector<NewKind>& new_kinds();

// The text of each file of src/app/templates/ by its name, embedded at build time.
const std::map<std::string, std::string>& template_files();

// Writes the files of a kind and returns what to do next, in a line. `output` is the name of the
// first; empty: its own name, in the current folder. Others, such as the scene of a deck, are
// written beside it. No file is replaced. Throws Error (input): with "new" as key for an unknown
// kind, with --output as key for a file that is already there; (environment) as AtomicFile
// (base/system/atomic_file.h) does.
std::string write_new(const std::string& kind, const std::filesystem::path& output);

}  // namespace polhode
