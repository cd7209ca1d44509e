// SPDX-License-Identifier: MIT
#include "scene/toml_text.h"

#include <algorithm>

#include "base/error.h"
#include "base/one_line.h"
#include "base/utf8.h"

namespace polhode {
namespace {

// the offset behind the string that starts at i; the end of the text when it is never closed
std::size_t skip_string(std::string_view text, std::size_t i) {
  const char quote = text[i];
  const std::string three(3, quote);
  const bool multi_line = text.substr(i, 3) == three;
  i += multi_line ? 3 : 1;
  for (; i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (multi_line && text.substr(i, 3) == three) {
      // up to two quotes before the closing three belong to the string
      const std::size_t quotes = std::min(text.find_first_not_of(quote, i), text.size()) - i;
      return i + std::min<std::size_t>(quotes, 5);
    } else if (!multi_line && (text[i] == quote || text[i] == '\n')) {
      return i + 1;
    }
  }
  return text.size();
}

// a tree that is too deep would be parsed, but overflow the stack when it is destroyed
void refuse_deep_nesting(std::string_view text, const std::string& name) {
  int brackets = 0;
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = skip_string(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    // dots count within one key; every other punctuation ends it
    if (c == '[' || c == '{') ++brackets;
    if (c == ']' || c == '}') brackets = std::max(0, brackets - 1);
    if (c == '.') ++dots;
    if (std::string_view("[]{}=,\n").find(c) != std::string_view::npos) dots = 0;
    if (brackets > kDeepestNesting || dots > kDeepestNesting) {
      throw input_error("nested deeper than {} levels, which no scene needs", kDeepestNesting)
          .at({name, line_of(text, i), {}});
    }
    ++i;
  }
}

// toml++ says "Error while parsing string: encountered end-of-file"
std::string short_message(std::string_view description) {
  constexpr std::string_view kPrefix = "Error while parsing ";
  if (description.substr(0, kPrefix.size()) == kPrefix) description.remove_prefix(kPrefix.size());
  return cut(description, 200);
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& name, const std::string& least) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw input_error("is empty; {}", least).at({name, 0, {}});
  }
  if (text.size() > kLargestScene) {
    throw input_error("is larger than {} bytes; is this a scene?", kLargestScene).at({name, 0, {}});
  }
  refuse_other_encodings(text, name, "scene");
  refuse_deep_nesting(text, name);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& fault) {
    throw input_error("not valid TOML: {}", short_message(fault.description()))
        .at({name, static_cast<int>(fault.source().begin.line), {}});
  }
}

}  // namespace polhode
