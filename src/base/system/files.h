// SPDX-License-Identifier: MIT
// Looks at files and folders, moves and removes them, and reports failure as Error.
#pragma once

#include <filesystem>
#include <vector>

#include "base/error.h"

namespace polhode {

// The paths of all files and folders in `folder`, sorted. Throws Error, with the folder as place,
// if it cannot be read: (environment) if system_error() (base/system/system_error.h) says so, else
// (`fault`).
std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder,
                                              Fault fault = Fault::input);

// Whether there is a file or folder of that name. Throws as system_error() does, with the name as
// place, if that cannot be found out, for example without the right to look into its folder.
bool is_there(const std::filesystem::path& file);

// Throws Error (environment) if it is gone.
std::filesystem::path working_folder();

// The path from the root, without `.` and `..`. Throws as working_folder() does.
std::filesystem::path absolute_path(const std::filesystem::path& file);

// Makes a folder and those above it; one that is there is no error. Throws as system_error() does,
// with `place`, if that fails.
void make_folder(const std::filesystem::path& folder, const Place& place = {});

// Renames a file or folder; a file of the new name is replaced. Throws Error (environment) if that
// fails.
void move_file(const std::filesystem::path& from, const std::filesystem::path& to);

// Removes a file, or a folder with all that is in it; one that is missing is no error. Throws Error
// (environment) if that fails.
void remove_file(const std::filesystem::path& file);

}  // namespace polhode
