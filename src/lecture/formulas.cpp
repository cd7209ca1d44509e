// SPDX-License-Identifier: MIT
#include "lecture/formulas.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace polhode {
namespace {

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

// Brackets that need not grow are told so: browsers give those that may grow the width of large
// ones.
void settle_brackets(std::string& formula) {
  // its TeX is in it
  if (formula.find("\\left") == std::string::npos && formula.find("\\begin") == std::string::npos)
    replace_all(formula, "stretchy=\"true\"", "stretchy=\"false\"");
}

// Letters inside an upright style are told so one by one: browsers have only that.
void settle_letters(std::string& formula) {
  const std::string style = "<mstyle", end = "</mstyle>", letter = "<mi>",
                    upright = "<mi mathvariant=\"normal\">";
  std::vector<bool> styles;  // those that are open, and whether they are upright
  for (std::size_t i = formula.find('<'); i != std::string::npos; i = formula.find('<', i + 1)) {
    if (formula.compare(i, style.size(), style) == 0) {
      const std::size_t close = formula.find('>', i);
      styles.push_back(formula.substr(i, close - i).find("mathvariant=\"normal\"") !=
                       std::string::npos);
    } else if (formula.compare(i, end.size(), end) == 0 && !styles.empty()) {
      styles.pop_back();
    } else if (formula.compare(i, letter.size(), letter) == 0 &&
               std::find(styles.begin(), styles.end(), true) != styles.end()) {
      formula.replace(i, letter.size(), upright);
    }
  }
}

}  // namespace

std::string with_tags_as_words(const std::string& tex) {
  const std::string tag = "\\tag";
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = tex.find(tag); at != std::string::npos; at = tex.find(tag, at + 1)) {
    const std::size_t open = tex.find('{', at);
    const bool plain = open == at + tag.size() + 1 && tex[open - 1] == '*';
    if (open == std::string::npos || (open != at + tag.size() && !plain)) continue;
    std::size_t close = open + 1;
    for (int depth = 1; close < tex.size(); ++close) {
      if (tex[close] == '\\') {
        ++close;
      } else {
        depth += tex[close] == '{' ? 1 : tex[close] == '}' ? -1 : 0;
        if (depth == 0) break;
      }
    }
    if (close >= tex.size()) continue;
    const std::string words = tex.substr(open + 1, close - open - 1);
    out += tex.substr(from, at - from);
    out +=
        fmt::format(fmt::runtime(plain ? "\\qquad\\text{{{}}}" : "\\qquad\\text{{({})}}"), words);
    from = close + 1;
  }
  return out + tex.substr(from);
}

// Text of the deck is escaped, so that what looks like an element is pandoc's own.
std::string formulas_for_browsers(const std::string& html) {
  const std::string last = "</math>";
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = html.find("<math"); at != std::string::npos;
       at = html.find("<math", from)) {
    out += html.substr(from, at - from);
    from = std::min(html.find(last, at), html.size() - last.size()) + last.size();
    std::string formula = html.substr(at, from - at);
    settle_brackets(formula);
    settle_letters(formula);
    out += formula;
  }
  return out + html.substr(from);
}

}  // namespace polhode
