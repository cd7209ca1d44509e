// SPDX-License-Identifier: MIT
// Finds scripts of others that pages contain, as npm installs them (tools/install-dependencies).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

// The first folder that has all of these files: the one that the environment variable `variable`
// names, then polhode/`name` in the data folders of the user (XDG_DATA_HOME, ~/.local/share) and of
// the system (/usr/local/share, /usr/share).
std::optional<std::filesystem::path> find_script_folder(const char* variable,
                                                        const std::string& name,
                                                        const std::vector<std::string>& files);

// What package.json in such a folder says: "5.1.0"; "of unknown version" if it says nothing. Throws
// Error (input) if the file cannot be read.
std::string version_of_scripts(const std::filesystem::path& folder);
// The contents of its file LICENSE; empty if it is missing. Throws Error (input) likewise.
std::string licence_of_scripts(const std::filesystem::path& folder);

// The same script, in which nothing ends the element <script> that it stands in.
std::string safe_in_script(std::string js);

}  // namespace polhode
