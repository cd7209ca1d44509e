// SPDX-License-Identifier: MIT
// Protects input files from being overwritten by a mistyped output name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace polhode {

// Throws Error (input), without a place, if the output `written`, or the unfinished file beside it
// (base/system/atomic_file.h), is the same file as one of the inputs `needed`, also by another path
// or a link, or if it ends in .toml, as scene files do. `what` names the output in the message:
// "the output", "--report". An empty `written` (no output) is accepted.
void refuse_same_file(const std::string& written,
                      const std::string& what,
                      const std::vector<std::filesystem::path>& needed);
// The same where what is written may end in .toml.
void refuse_needed_file(const std::string& written,
                        const std::string& what,
                        const std::vector<std::filesystem::path>& needed);
// As refuse_same_file(), for files of these names in a folder that --output names.
void refuse_same_files(const std::filesystem::path& folder,
                       const std::vector<std::string>& names,
                       const std::vector<std::filesystem::path>& needed);

// Remembers an existing file that the user gave, such as a scene, until the process ends.
// Thread-safe. What is not there is not remembered.
void protect_file(const std::filesystem::path& file);
// Throws Error (input), with `target` as its place, if a protected file, or one that is standard
// input, output or error, would be written there, also by a link such as /dev/stdout. AtomicFile
// (base/system/atomic_file.h) does this for all outputs.
void refuse_protected_file(const std::filesystem::path& target);

}  // namespace polhode
