// SPDX-License-Identifier: MIT
#include "lecture/documents/mathml.h"

#include <algorithm>
#include <iterator>
#include <string_view>
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

// where the element begins that is open at a place of a formula; npos: nowhere
std::size_t begin_of(const std::string& formula,
                     const std::string& open,
                     const std::string& close,
                     std::size_t at) {
  for (int depth = 1; depth > 0;) {
    if (at == 0) return std::string::npos;
    const std::size_t opens = formula.rfind(open, at - 1), closes = formula.rfind(close, at - 1);
    if (opens == std::string::npos) return opens;
    const bool is_end = closes != std::string::npos && closes > opens;
    depth += is_end ? 1 : -1;
    at = is_end ? closes : opens;
  }
  return at;
}

// whether an element is one letter or digit, perhaps in another style
bool is_one_letter(std::string_view element) {
  constexpr std::string_view kPlain[] = {"mi", "mn", "mrow", "mstyle"};
  int letters = 0;
  for (std::size_t i = 0; i < element.size(); ++i) {
    if (element[i] != '<') {
      letters += (static_cast<unsigned char>(element[i]) & 0xC0U) != 0x80U ? 1 : 0;
      continue;
    }
    const std::string_view tag = element.substr(i + (element.substr(i).starts_with("</") ? 2 : 1));
    if (std::find(std::begin(kPlain), std::end(kPlain), tag.substr(0, tag.find_first_of(" >"))) ==
        std::end(kPlain))
      return false;
    i = std::min(element.find('>', i), element.size());
  }
  return letters == 1;
}

// Bars and arrows over more than a letter are as long as this: browsers draw those of pandoc over
// one letter. An arrow below is above.
void settle_bars(std::string& formula) {
  // backgrounds would be printed thicker
  constexpr const char* kBar = "<mrow style=\"border-{}:.05em solid\">";
  constexpr const char* kRoom = "<mspace height=\"0.15em\"></mspace>";
  const auto arrow = [](const char* sign) {
    return fmt::format("<mo stretchy=\"true\">{}</mo>", sign);
  };
  struct Mark {
    std::string sign, of, becomes, before, mark, behind;
  };
  static const Mark kMarks[] = {
      {"¯", "mover", "mover", fmt::format(kBar, "top"), kRoom, "</mrow>"},
      {"_", "munder", "munder", fmt::format(kBar, "bottom"), kRoom, "</mrow>"},
      {"\u20d7", "mover", "mover", "", arrow("→"), ""},
      {"\u20d6", "mover", "mover", "", arrow("←"), ""},
      {"\u20e1", "mover", "mover", "", arrow("↔"), ""},
      {"\u20ef", "mover", "munder", "", arrow("→"), ""},
      {"\u20ee", "mover", "munder", "", arrow("←"), ""},
  };
  for (const auto& [sign, of, becomes, before, mark, behind] : kMarks) {
    const std::string open = fmt::format("<{}>", of), close = fmt::format("</{}>", of),
                      old = fmt::format("<mo accent=\"true\">{}</mo>{}", sign, close);
    for (std::size_t at = formula.find(old); at != std::string::npos;
         at = formula.find(old, at + 1)) {
      const std::size_t begin = begin_of(formula, open, close, at);
      if (begin == std::string::npos) continue;
      const std::size_t base = begin + open.size();
      if (sign != "_" && is_one_letter(std::string_view(formula).substr(base, at - base))) continue;
      formula.replace(at, old.size(), fmt::format("{}</{}>{}", mark, becomes, behind));
      formula.replace(begin, open.size(), fmt::format("{}<{}>", before, becomes));
    }
  }
}

}  // namespace

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
    settle_bars(formula);
    out += formula;
  }
  return out + html.substr(from);
}

}  // namespace polhode
