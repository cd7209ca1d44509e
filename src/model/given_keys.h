// SPDX-License-Identifier: MIT
// Checks the keys that a scene gives to a solid or a load against those that its kind takes.
#pragma once

#include <string>
#include <vector>

namespace polhode {

// Whether `name` is in `names`.
bool contains(const std::vector<std::string>& names, const std::string& name);

// The name of a kind with its article: "a box", "an ellipsoid".
std::string with_article(const std::string& kind);

// Throws Error (input) naming `path`, the dotted key of the table, if one of `needed` is missing
// from `given`. kind: name of the solid or load, for the message.
void require_keys(const std::string& kind,
                  const std::vector<std::string>& needed,
                  const std::vector<std::string>& given,
                  const std::string& path);

// Throws Error (input) naming `path`.KEY for the first given key that is not in `known`. The
// message lists the known keys.
void refuse_other_keys(const std::string& kind,
                       const std::vector<std::string>& known,
                       const std::vector<std::string>& given,
                       const std::string& path);

}  // namespace polhode
