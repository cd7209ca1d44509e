// SPDX-License-Identifier: MIT
// Lines of a deck for messages about what pandoc's tree holds.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/json.h"

namespace polhode {

// Finds the line numbers of texts, which pandoc's tree does not contain.
class LineFinder {
 public:
  // blocks: of pandoc's tree of the text; what stands in their code is not found.
  explicit LineFinder(std::string text, const Json& blocks = Json::array());
  // The line (from 1) of the first occurrence of `words` after the one that the previous call with
  // the same words found; 0 if there is none and for empty `words`.
  int next(const std::string& words);

 private:
  std::string text_;
  std::vector<std::size_t> line_ends_;       // offsets in bytes
  std::map<std::string, std::size_t> seen_;  // words -> offset in bytes behind the last place
};

}  // namespace polhode
