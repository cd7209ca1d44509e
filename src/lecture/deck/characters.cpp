// SPDX-License-Identifier: MIT
#include "lecture/deck/characters.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "base/utf8.h"

namespace polhode {

void for_each_character(const std::string& text,
                        const std::function<void(const std::string&)>& visit) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = std::max<std::size_t>(1, utf8_length(text, i));
    visit(text.substr(i, length));
    i += length;
  }
}

void for_each_set_text(const Json& tree, const std::function<void(const std::string&)>& visit) {
  for_each_node(tree, [&](const Json& node) {
    const std::string type = node["t"];
    if (type == "Str") visit(node["c"].get<std::string>());
    if (type == "Code" || type == "CodeBlock" || type == "Math")
      visit(node["c"][1].get<std::string>());
  });
}

std::vector<std::string> characters_of(const Deck& deck) {
  std::vector<std::string> list;
  std::set<std::string> seen;
  const auto look = [&](const std::string& text) {
    for_each_character(text, [&](const std::string& one) {
      if (seen.insert(one).second) list.push_back(one);
    });
  };
  for_each_set_text(deck.meta, look);
  for_each_set_text(deck.blocks, look);
  for (const DeckPicture& picture : deck.pictures)
    for_each_set_text(picture.caption, look);
  return list;
}

std::string with_code_point(const std::string& character) {
  return fmt::format("{} ({})", character, code_point(character, 0));
}

}  // namespace polhode
