// SPDX-License-Identifier: MIT
#include "lecture/deck/formulas.h"

#include <algorithm>
#include <regex>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "lecture/deck/quantities.h"

namespace polhode {
namespace {

// where the brace is that closes the one at `open`; npos: nowhere
std::size_t end_of_group(const std::string& tex, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < tex.size(); ++i) {
    if (tex[i] == '\\') {
      ++i;
    } else {
      depth += tex[i] == '{' ? 1 : tex[i] == '}' ? -1 : 0;
      if (depth == 0) return i;
    }
  }
  return std::string::npos;
}

std::string without_group(std::string tex, const std::string& head) {
  for (std::size_t at = tex.find(head); at != std::string::npos; at = tex.find(head, at)) {
    const std::size_t close = end_of_group(tex, at + head.size() - 1);
    if (close == std::string::npos) break;
    tex.erase(at, close + 1 - at);
  }
  return tex;
}

// in words a % is a character
std::string without_comments(const std::string& tex) {
  const std::vector<bool> words = words_in(tex);
  std::string out;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    if (tex[i] == '\\' && i + 1 < tex.size()) {
      out += tex.substr(i++, 2);
    } else if (tex[i] != '%') {
      out += tex[i];
    } else if (words[i]) {
      out += "\\%";
    } else {
      i = std::min(tex.find('\n', i), tex.size()) - 1;
    }
  }
  return out;
}

// where the row of a formula ends in which `at` is
std::size_t end_of_row(const std::string& tex, std::size_t at) {
  int braces = 0, environments = 0;
  for (std::size_t i = at; i < tex.size(); ++i) {
    if (tex[i] == '{') ++braces;
    if (tex[i] == '}' && --braces < 0) return i;
    if (tex[i] != '\\') continue;
    const bool ends = tex.compare(i, 5, "\\end{") == 0;
    if (braces == 0 && environments == 0 && (ends || tex.compare(i, 2, "\\\\") == 0)) return i;
    environments += ends ? -1 : tex.compare(i, 7, "\\begin{") == 0 ? 1 : 0;
    ++i;
  }
  return tex.size();
}

// what takes room in a formula and means nothing
constexpr const char* kRoom =
    R"((\s|~|\{\s*\}|\\[,;:!> ]|\\(q?quad|displaystyle|textstyle|limits|nolimits)(?![A-Za-z])|\\hspace\{[^{}]*\}|\\text\{\s*\}|\\([bB]igg?[lr]?|left|right)\.))";
constexpr std::size_t kFar = 200;  // bytes in which it is looked for

std::string_view without_room_at_begin(std::string_view text) {
  static const std::regex room(fmt::format("^{}*", kRoom));
  std::cmatch found;
  const char* end = text.data() + std::min(text.size(), kFar);
  if (std::regex_search(text.data(), end, found, room))
    text.remove_prefix(static_cast<std::size_t>(found.length(0)));
  return text;
}

std::string_view without_room_at_end(std::string_view text) {
  static const std::regex room(fmt::format("{}*$", kRoom));
  std::cmatch found;
  const char* begin = text.data() + (text.size() > kFar ? text.size() - kFar : 0);
  if (std::regex_search(begin, text.data() + text.size(), found, room))
    text.remove_suffix(static_cast<std::size_t>(found.length(0)));
  return text;
}

// whether this is an exponent or a prime, perhaps with an index before it
bool is_exponent(std::string_view text) {
  static const std::regex exponent(R"(^(_\s*(\{[^{}]*\}|\\[A-Za-z]+|[^\s{}\\])\s*)?['^])");
  if (text.starts_with("²") || text.starts_with("³")) return true;
  return std::regex_search(text.data(), text.data() + std::min(text.size(), kFar), exponent);
}

// whether what comes next is an index or an exponent of this
bool ends_with_mark(std::string_view text) {
  return text.ends_with('_') || text.ends_with('^');
}

// Whether a part of a formula is raised, also with braces and fonts around it and nothing else.
bool is_raised(std::string_view before, std::string_view behind) {
  while (true) {
    before = without_room_at_end(before);
    behind = without_room_at_begin(behind);
    if (ends_with_mark(before)) return false;
    if (is_exponent(behind)) return true;
    if (!before.ends_with('{') || !behind.starts_with('}')) return false;
    before.remove_suffix(1);
    behind.remove_prefix(1);
    const std::size_t name =
        before.find_last_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz");
    if (name != std::string_view::npos && before[name] == '\\')
      before.remove_suffix(before.size() - name);
  }
}

// Whether a number that follows this would be taken from it if it were negative: the end of this is
// no relation, bracket or command of which the number is an argument.
bool has_operand_at_end(std::string_view before) {
  static const std::regex others(
      R"(\\(approx|sim|simeq|cong|equiv|propto|leq?|geq?|neq?|ll|gg|to|in|left|[bB]igg?l?)"
      R"(|sqrt|[dtc]?frac|binom|hat|vec|bar|d?dot|tilde|overline|underline|boxed|boldsymbol)"
      R"(|math[a-z]+|text[a-z]*|mbox|text\{[^{}]*\}|begin\{[^{}]*\})\s*[\[(|.]?$)");
  static const std::regex row(R"(\\\\\s*(\[[^\]]*\])?\s*$)");
  static const std::regex numerator(R"(\\[dtc]?frac\s*\{[^{}]*\}\s*$)");
  const auto end_is = [](std::string_view text, const std::regex& pattern) {
    const std::string end(text.substr(text.size() > kFar ? text.size() - kFar : 0));
    return std::regex_search(end, pattern);
  };
  if (end_is(before, row) || end_is(before, numerator)) return false;
  before = without_room_at_end(before);
  if (before.empty() || ends_with_mark(before)) return false;
  if (std::string_view("=<>([{|,;:&$").find(before.back()) != std::string_view::npos) return false;
  return !end_is(before, others);
}

// Throws Error (input), without a place, for matrices that LaTeX has only with a further package.
void refuse_foreign_matrices(const std::string& tex) {
  static const std::regex matrix(R"(\\begin\{([bBpvV]?(small)?matrix)\*\})");
  std::smatch found;
  if (std::regex_search(tex, found, matrix))
    throw input_error("{}* is not known; write {}", found.str(1), found.str(1));
}

// Throws Error (input), without a place, for what pandoc would leave out or show as other letters.
void refuse_misread_parts(const std::string& tex) {
  static const std::regex operators(R"(\\mathop(?![A-Za-z]))");
  static const std::regex good(
      R"(\\mathop\s*\{\s*([A-Za-z ]+|\\[A-Za-z]+|\\(mathrm|mathbf|mathsf|text)\s*\{[A-Za-z .]*\})\s*\})");
  for (std::sregex_iterator found(tex.begin(), tex.end(), operators), end; found != end; ++found) {
    if (!std::regex_search(tex.begin() + found->position(0),
                           tex.end(),
                           good,
                           std::regex_constants::match_continuous))
      throw input_error("of \\mathop only words are read; write the formula without it");
  }
  static const std::regex letters(R"(\\[ij](?![A-Za-z])|\\[~^]\{\s*\})");
  const std::vector<bool> words = words_in(tex);
  for (std::sregex_iterator found(tex.begin(), tex.end(), letters), end; found != end; ++found) {
    if (words[static_cast<std::size_t>(found->position(0))])
      throw input_error("'{}' in words is not read; write the letter itself", found->str());
  }
}

// Delimiters that have a size, as pandoc reads those of \left: \bigl. is none, \bigl< is an angle,
// and \Bigl[ and \bigm| it does not know.
std::string with_plain_delimiters(const std::string& tex) {
  static const std::pair<std::regex, const char*> kPlain[] = {
      {std::regex(R"((\\[bB]igg?[lmr]?)\s*<)"), "$1\\langle "},
      {std::regex(R"((\\[bB]igg?[lmr]?)\s*>)"), "$1\\rangle "},
      {std::regex(R"(\\[bB]igg?[lmr]?\s*\.)"), "{}"},
      {std::regex(R"(\\Big[lmr](?![A-Za-z]))"), "\\Big"},
      {std::regex(R"(\\(big|bigg|Bigg)m(?![A-Za-z]))"), "\\$1"}};
  std::string out = tex;
  for (const auto& [delimiter, plain] : kPlain)
    out = std::regex_replace(out, delimiter, plain);
  return out;
}

// Rows as pandoc reads them: it shows the star of \\*, which allows no new page, and the position
// of an environment, [t], as parts of the formula, and takes brackets behind the end of a row for
// its distance, though TeX does so only where a length is in them. TeX may look for a position
// behind blanks.
std::string with_plain_rows(const std::string& tex) {
  static const std::regex position(R"((\\begin\{(aligned|gathered|alignedat|array)\})\[[tbc]\])");
  static const std::regex bracket(R"((\\begin\{(aligned|gathered)\})\s+\[)");
  static const std::regex length(
      R"(\s*\[\s*(-?\s*[0-9.]+\s*(pt|mm|cm|in|ex|em|mu|bp|pc|sp|dd|cc)|\\jot|\\[a-z]{1,20}skip(amount)?)\s*\])");
  const std::string shown =
      std::regex_replace(std::regex_replace(tex, position, "$1"), bracket, "$1 {}[");
  const std::vector<bool> words = words_in(shown);
  std::string out;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    out += shown[i];
    if (shown[i] != '\\' || i + 1 == shown.size()) continue;
    out += shown[++i];
    if (shown[i] != '\\' || words[i]) continue;
    if (shown.compare(i + 1, 1, "*") == 0) ++i;
    const std::size_t next = shown.find_first_not_of(" \t\n", i + 1);
    if (next == std::string::npos) continue;
    const std::string rest = shown.substr(i + 1, kFar);
    if (std::regex_search(rest, length, std::regex_constants::match_continuous)) {
      i = next - 1;
    } else if (shown[next] == '[' || shown[next] == '*') {
      out += " {}";
      i = next - 1;
    }
  }
  return out;
}

// A blank behind a character such as \% in words is one, which pandoc forgets.
std::string with_blanks(const std::string& tex) {
  const std::vector<bool> words = words_in(tex);
  std::string out;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    out += tex[i];
    if (tex[i] != '\\' || i + 1 == tex.size()) continue;
    out += tex[++i];
    const bool is_character = std::string_view("%&#_{}$").find(tex[i]) != std::string_view::npos;
    if (is_character && words[i] && tex.compare(i + 1, 1, " ") == 0) out += "{}";
  }
  return out;
}

// A comma in braces belongs to its number, which pandoc forgets: 1{,}5.
std::string with_decimal_commas(const std::string& tex) {
  const std::string comma = "{,}";
  const std::vector<bool> words = words_in(tex);
  const auto is_digit = [&](std::size_t at) {
    return at < tex.size() && tex[at] >= '0' && tex[at] <= '9';
  };
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = tex.find(comma); at != std::string::npos; at = tex.find(comma, at + 1)) {
    if (at == 0 || words[at] || !is_digit(at - 1) || !is_digit(at + comma.size())) continue;
    out += tex.substr(from, at - from) + "\\text{,}";
    from = at + comma.size();
  }
  return out + tex.substr(from);
}

}  // namespace

std::vector<bool> words_in(const std::string& tex) {
  constexpr std::string_view kWords[] = {"\\text{",
                                         "\\mbox{",
                                         "\\textrm{",
                                         "\\textbf{",
                                         "\\textit{",
                                         "\\textsf{",
                                         "\\texttt{",
                                         "\\textnormal{"};
  std::vector<bool> list(tex.size(), false);
  int depth = 0, words_from = 0;  // braces that are open; those around words, 0: none
  bool inner_formula = false;     // $…$ in words
  for (std::size_t i = 0; i < tex.size(); ++i) {
    const char c = tex[i];
    const bool in_words = words_from > 0 && !inner_formula;
    list[i] = in_words;
    if (c == '%' && !in_words) {
      i = std::min(tex.find('\n', i), tex.size()) - 1;
    } else if (c == '\\' && i + 1 < tex.size()) {
      const auto opened = std::find_if(std::begin(kWords), std::end(kWords), [&](auto word) {
        return tex.compare(i, word.size(), word) == 0;
      });
      list[i + 1] = in_words;
      i += opened == std::end(kWords) ? 1 : opened->size() - 1;
      if (opened == std::end(kWords)) continue;
      ++depth;
      if (words_from == 0) words_from = depth;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}') {
      if (depth-- == words_from) words_from = 0;
    } else if (c == '$') {
      inner_formula = !inner_formula;
    }
  }
  return list;
}

std::string whole_formula(const std::string& tex) {
  std::string out = without_group(without_comments(tex), "\\label{");
  for (std::size_t at = out.find("\\tag"); at != std::string::npos; at = out.find("\\tag", at)) {
    const std::size_t open = out.find('{', at), behind = at + 4;
    const bool is_plain = open == behind + 1 && out[behind] == '*';
    const std::size_t close = open == behind || is_plain ? end_of_group(out, open) : open;
    if (open == std::string::npos || close == std::string::npos || close == open) {
      at = behind;
      continue;
    }
    std::string words = out.substr(open + 1, close - open - 1);
    // what is words already
    if (words.starts_with("\\text{") && end_of_group(words, 5) == words.size() - 1)
      words = words.substr(6, words.size() - 7);
    const bool is_text =
        words.find('\\') == std::string::npos || words.find('$') != std::string::npos;
    std::string number = is_text ? "\\qquad\\text{" : "\\qquad ";
    number += is_plain ? words : fmt::format("({})", words);
    number += is_text ? "}" : " ";
    out.erase(at, close + 1 - at);
    out.insert(end_of_row(out, at), number);
  }
  if (std::regex_search(out, std::regex(R"(\\(tag|label)(?![a-zA-Z]))")))
    throw input_error("\\tag and \\label need what belongs to them in braces");
  const std::vector<bool> words = words_in(out);
  for (std::size_t i = 0; i + 1 < out.size(); ++i) {
    if (out[i] != '\\') continue;
    if (!words[i] && std::string_view("[]()").find(out[i + 1]) != std::string_view::npos)
      throw input_error("'{}' is no part of a formula", out.substr(i, 2));
    ++i;
  }
  refuse_foreign_matrices(out);
  refuse_misread_parts(out);
  out = with_decimal_commas(plain_quantities(out));
  return with_blanks(with_plain_rows(with_plain_delimiters(out)));
}

std::string part_of_formula(const std::string& tex,
                            std::string_view before,
                            std::string_view behind,
                            bool among_words) {
  const bool is_simple = tex.find_first_not_of("0123456789.") == std::string::npos ||
                         (tex.front() == '(' && tex.back() == ')');
  const bool is_subtracted = tex.front() == '-' && !among_words && has_operand_at_end(before);
  return is_subtracted || (!is_simple && is_raised(before, behind)) ? "{\\left(" + tex + "\\right)}"
                                                                    : "{" + tex + "}";
}

}  // namespace polhode
