// SPDX-License-Identifier: MIT
// A deck is somebody else's text. What it may reach and what it may say is decided here.
#pragma once

#include <filesystem>
#include <string>

namespace polhode {

// The folder that a deck may read from.
struct DeckRoot {
  std::filesystem::path folder;  // of the deck
  bool allow_outside = false;    // the user trusts the deck
};

// The ordinary file that a deck or one of its scenes names, as folder / name; `from` is the folder
// that the name counts from. Throws Error (input) for a name that leaves the deck's folder
// (absolute, with "..", by a symbolic link), has control characters, or names no ordinary file.
std::filesystem::path trusted_file(const DeckRoot& root,
                                   const std::filesystem::path& from,
                                   const std::string& name);

// The scene of that name; the mesh files that it names are held to the same rule before any is
// opened. Throws Error (input).
std::filesystem::path trusted_scene(const DeckRoot& root, const std::string& name);

// Throws Error (input) for a link that is none of http, https, mailto and #place.
void check_link(const std::string& target);

// Throws Error (input) for TeX that is no mathematics: what reads, writes, defines or runs.
void check_formula(const std::string& tex);

// "a%20b" to "a b"; what is no escape stays.
std::string percent_decoded(const std::string& text);
// For an address in a page: everything but letters, digits and "-_./" as %XX.
std::string percent_encoded(const std::string& text);

}  // namespace polhode
