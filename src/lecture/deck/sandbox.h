// SPDX-License-Identifier: MIT
// Decides which files, links and formulas a deck may use. Decks are untrusted text.
#pragma once

#include <filesystem>
#include <string>

namespace polhode {

// The folder that a deck may read files from.
struct DeckRoot {
  std::filesystem::path folder;  // the deck's own folder; empty: the current folder
  bool allow_outside = false;    // the user trusts the deck: files anywhere are allowed
};

// Whether a name may lead out of the folder that it is relative to: it is absolute or has "..",
// whose meaning symbolic links change.
bool may_leave(const std::filesystem::path& name);

// The path of a file that a deck or one of its scenes names: from / name. `from` is the folder that
// the name is relative to, that of the deck or of the scene. Throws Error (input), without a place,
// for a name that is empty or has control characters, for a file that is missing or not a regular
// file, and, unless root.allow_outside, for one that may_leave() or does by a symbolic link.
std::filesystem::path trusted_file(const DeckRoot& root,
                                   const std::filesystem::path& from,
                                   const std::string& name);

// The path of a scene of the deck, `name` being relative to the deck's folder. The mesh files that
// the scene names, relative to its own folder, are checked in the same way. Throws Error (input) as
// trusted_file and named_files (scene/scene.h) do.
std::filesystem::path trusted_scene(const DeckRoot& root, const std::string& name);

// Throws Error (input), without a place, unless the link begins with http://, https://, mailto: or
// # and has no control characters.
void check_link(const std::string& target);

// Throws Error (input), without a place, for TeX that is not mathematics: commands that read,
// write, define, link or run something (the list is in sandbox.cpp), "^^", and control characters
// other than tabs and line breaks.
void check_formula(const std::string& tex);

// Replaces the escapes of a URL by the bytes they stand for ("a%20b" becomes "a b"); "%" without
// two hexadecimal digits is not changed.
std::string percent_decoded(const std::string& text);
// Text as part of a URL: all bytes except ASCII letters, digits and "-_./" become %XX.
std::string percent_encoded(const std::string& text);

}  // namespace polhode
