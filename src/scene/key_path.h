// SPDX-License-Identifier: MIT
// Values of a TOML tree by the path of their key, as a scene file spells it: "motion.spin.body[2]",
// "body.solid.radius_cm".
#pragma once

#include <string>

#include <toml++/toml.h>

namespace polhode {

// A key without the unit that it is spelled in: "radius_cm" is "radius".
std::string without_suffix(const std::string& key);
// A path without the units that its keys are spelled in, as in Scene::lines.
std::string without_suffixes(const std::string& path);

// The node at a path; null if the tree has none there. Throws Error (input), without a place, for
// text that is no path.
const toml::node* node_at(const toml::table& tree, const std::string& path);

// Puts a number where a number is, instead of any spelling of its key. A key that the tree lacks is
// added with the tables around it; an entry of a list is not. Throws Error (input), without a
// place, for text that is no path, for a path to something that is not a number, and for an entry
// of a list that does not exist.
void replace_number(toml::table& tree, const std::string& path, double value);

// Puts any value in the place of any other, or adds it likewise. `value` is TOML; words that are
// none, such as light or 1920x1080, count as text. Throws Error (input), without a place, for text
// that is no path, for an entry of a list that does not exist, and for a text, list or table that
// is no valid TOML.
void replace_value(toml::table& tree, const std::string& path, const std::string& value);
// The same with a value that has been parsed.
void replace_node(toml::table& tree, const std::string& path, const toml::node& value);

}  // namespace polhode
