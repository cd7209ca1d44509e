// SPDX-License-Identifier: MIT
// Decides which files, links and formulas a deck may use. Decks are untrusted text.
#pragma once

#include <filesystem>
#include <string>

namespace polhode {

// The folder that a deck may read files from.
struct DeckRoot {
  std::filesystem::path folder;  // the deck's own folder
  bool allow_outside = false;    // the user trusts the deck: files anywhere are allowed
};

// The path of a file that a deck or one of its scenes names, relative to the folder `from`. Throws
// Error (input), without a place, for a name that leaves the deck's folder (absolute, with "..", or
// by a symbolic link), has control characters, or is not a regular file.
std::filesystem::path trusted_file(const DeckRoot& root,
                                   const std::filesystem::path& from,
                                   const std::string& name);

// The path of a scene of the deck. The mesh files that it names are checked in the same way. Throws
// Error (input) as trusted_file does.
std::filesystem::path trusted_scene(const DeckRoot& root, const std::string& name);

// Throws Error (input), without a place, unless the link is http:, https:, mailto: or #place.
void check_link(const std::string& target);

// Throws Error (input), without a place, for TeX that is not mathematics: commands that read,
// write, define or run something.
void check_formula(const std::string& tex);

// "a%20b" as "a b"; text that is not an escape is not changed.
std::string percent_decoded(const std::string& text);
// Text as part of a URL: all bytes except letters, digits and "-_./" become %XX.
std::string percent_encoded(const std::string& text);

}  // namespace polhode
