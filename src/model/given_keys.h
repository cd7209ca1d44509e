// SPDX-License-Identifier: MIT
// Whether the keys that a scene gives to a kind of solid or load are the ones that the kind takes.
#pragma once

#include <string>
#include <vector>

namespace polhode {

bool contains(const std::vector<std::string>& names, const std::string& name);

// Throws Error (input) at `path`, the dotted key of the table, where one of `needed` is not given.
void require_keys(const std::string& kind,
                  const std::vector<std::string>& needed,
                  const std::vector<std::string>& given,
                  const std::string& path);

// Throws Error (input) at the first given key that is not among `known`, with a list of those.
void refuse_other_keys(const std::string& kind,
                       const std::vector<std::string>& known,
                       const std::vector<std::string>& given,
                       const std::string& path);

}  // namespace polhode
