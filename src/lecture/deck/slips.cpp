// SPDX-License-Identifier: MIT
#include "lecture/deck/slips.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest.h"
#include "lecture/deck/tree.h"

namespace polhode {
namespace {

bool has(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

// "{insepct:a.toml#mass}" or, behind a blank, "inspect:a.toml#mass"; no address of the web
bool is_misspelt_quote(const std::string& words) {
  const bool may_quote = has(words, "{") || words.starts_with("inspect:");
  return may_quote && has(words, ".toml#") && !has(words, "{inspect:") && !has(words, "://");
}

// "#" with a blank behind it that keeps words together, where a paragraph begins
bool is_no_title(const std::string& words) {
  const std::size_t behind = words.find_first_not_of('#');
  return behind > 0 && behind != std::string::npos && words.find("\u00a0") == behind;
}

// "{.notes}"
bool is_class(const std::string& words) {
  constexpr std::size_t kShortest = 4;
  return words.size() >= kShortest && (words.starts_with("{.") || words.starts_with("{#")) &&
         words.ends_with("}") && std::isalpha(static_cast<unsigned char>(words[2])) != 0;
}

// The commands of LaTeX in a word, each with the character behind its name: "\note{", "\pause".
// C:\Users and ..\run are paths.
std::vector<std::string> latex_in(const std::string& words) {
  static const std::set<std::string> without_arguments = {
      "pause", "newline", "linebreak", "newpage", "clearpage", "pagebreak"};
  const auto is_one_of = [&](std::size_t at, std::string_view characters) {
    return at < words.size() && characters.find(words[at]) != std::string_view::npos;
  };
  std::vector<std::string> commands;
  for (std::size_t at = words.find('\\'); at != std::string::npos; at = words.find('\\', at + 1)) {
    std::size_t end = at + 1;
    while (end < words.size() && std::isalpha(static_cast<unsigned char>(words[end])) != 0)
      ++end;
    const std::string name = words.substr(at + 1, end - at - 1);
    if (name.size() < 2) continue;
    const bool begins_word = at == 0 || is_one_of(at - 1, "([{\"'");
    const bool ends_sentence = at > 1 && is_one_of(at - 1, ".,;!?)") &&
                               std::isalnum(static_cast<unsigned char>(words[at - 2])) != 0;
    if (begins_word || ends_sentence || is_one_of(end, "{[<") || without_arguments.contains(name))
      commands.push_back(words.substr(at, end + 1 - at));
  }
  return commands;
}

// "<aside", "</div>", "<!--", "<br/>"; a letter alone may be a mean value, as in <p>
bool is_html(const std::string& words) {
  static const std::set<std::string> tags = {
      "article", "aside",   "audio",   "big",   "blockquote", "br",     "center", "code",
      "del",     "details", "dfn",     "div",   "em",         "figure", "font",   "footer",
      "h1",      "h2",      "h3",      "h4",    "h5",         "h6",     "header", "hr",
      "iframe",  "img",     "ins",     "kbd",   "li",         "link",   "mark",   "ol",
      "pre",     "script",  "section", "small", "span",       "strong", "style",  "sub",
      "summary", "sup",     "svg",     "table", "tbody",      "td",     "th",     "tr",
      "tt",      "ul",      "video",   "note",  "notes",      "hidden", "comment"};
  for (std::size_t at = words.find('<'); at != std::string::npos; at = words.find('<', at + 1)) {
    if (words.compare(at, 2, "<!") == 0 || words.compare(at, 2, "<?") == 0) return true;
    std::string name;
    std::size_t end = at + (words.compare(at, 2, "</") == 0 ? 2 : 1);
    for (; end < words.size() && std::isalnum(static_cast<unsigned char>(words[end])) != 0; ++end)
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(words[end])));
    const bool is_end = end == words.size() || words[end] == '>' || words[end] == '/';
    if (is_end && tags.contains(name)) return true;
  }
  return false;
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// "{.notes}" and what follows to "notes"
std::string first_letters(const std::string& words) {
  const auto begin = std::find_if(words.begin(), words.end(), is_letter);
  return {begin, std::find_if_not(begin, words.end(), is_letter)};
}

// "{.film}" in "word{.film}", "{inspect:a.toml#mass}{.film},"; "": none
std::string class_behind_words(const std::string& words) {
  const std::size_t begin = std::max(words.rfind("{.") + 1, words.rfind("{#") + 1);
  const std::size_t end = words.find('}', begin);
  if (begin < 2 || end == std::string::npos) return "";
  const std::string found = words.substr(begin - 1, end + 2 - begin);
  return is_class(found) ? found : "";
}

Error would_be_shown(const std::string& words, std::string_view why) {
  return input_error("'{}' would be shown as it stands: {}", words, why);
}

}  // namespace

std::string letters_of(std::string mark) {
  std::erase_if(mark, [](char c) { return !is_letter(c); });
  return mark;
}

SlipFinder::SlipFinder(LineFinder& lines, Tell tell) : lines_(lines), tell_(std::move(tell)) {}

void SlipFinder::look_at(const Json& node, bool in_header) {
  const std::string type = node["t"];
  if (type == "Para" || type == "Plain") look_at_words(node["c"]);
  if (type == "Header") look_at_words(node["c"][2]);
  if (type == "Str") look_at_word(node["c"], in_header);
  if (type == "LineBlock") {
    for (const Json& line : node["c"])
      look_for_notes(line);
  } else if (type == "Emph" || type == "Strong" || type == "Strikeout" || type == "Underline" ||
             type == "SmallCaps") {
    look_for_notes(node["c"]);
  }
  if (type == "Note") look_for_boxes(node["c"]);
  if (type != "Div") look_at_classes(node);
}

// Boxes of notes in a footnote, which LaTeX would show.
void SlipFinder::look_for_boxes(const Json& footnote) {
  for_each_node(footnote, [&](const Json& box) {
    if (!is_div(box, "notes")) return;
    int line = 0;
    for_each_node(box, [&](const Json& node) {
      if (line == 0 && (node["t"] == "Para" || node["t"] == "Plain"))
        line = line_of_mark(node["c"], 0);
    });
    tell_(line, input_error("a footnote has no notes for the speaker; put their box behind it"));
  });
}

// A box of notes that begins where no box can: in a line of verses or of a table that is none, in
// bold, behind a line end that is none for pandoc (U+2028).
void SlipFinder::look_for_notes(const Json& inlines) {
  for (std::size_t i = 0; i < inlines.size(); ++i) {
    if (inlines[i]["t"] != "Str") continue;
    const std::string words = inlines[i]["c"];
    const std::size_t mark = words.find(":::");
    if (mark == std::string::npos) continue;
    std::size_t next = i + 1;
    while (next + 1 < inlines.size() && inlines[next]["t"] == "Space")
      ++next;
    std::string name = first_letters(words.substr(mark));
    if (name.empty() && next < inlines.size() && inlines[next]["t"] == "Str")
      name = first_letters(inlines[next]["c"]);
    if (!is_almost(name, "notes")) continue;
    if (std::exchange(mark_told_, true)) return;
    tell_(line_of_mark(inlines, i),
          would_be_shown(":::", "a box begins behind an empty line, with a line of its own"));
    return;
  }
}

void SlipFinder::look_at_words(const Json& inlines) {
  for (std::size_t i = 0; i < inlines.size(); ++i) {
    if (inlines[i]["t"] != "Str") continue;
    const std::string words = inlines[i]["c"];
    const bool begins_line = i == 0 || inlines[i - 1]["t"] == "SoftBreak";
    const bool is_title = i == 0 && is_no_title(words);
    if (is_misspelt_quote(words)) {
      tell_(lines_.next(words), would_be_shown(words, "a number is quoted by {inspect:…}"));
    } else if (is_title || (begins_line && (words.starts_with(":::") || words == "::"))) {
      // those behind it are shown because it is
      if (std::exchange(mark_told_, true)) return;
      tell_(line_of_mark(inlines, i),
            would_be_shown(words,
                           is_title ? "the space behind # is one that keeps words together"
                                    : "a box begins behind an empty line, as far from the margin "
                                      "as what is around it, and ends with a line of its own"));
    } else if (is_class(words)) {
      // a box may have the same
      const bool has_words_before = i > 1 && inlines[i - 2]["t"] == "Str";
      tell_(
          has_words_before ? lines_.next(inlines[i - 2]["c"].get<std::string>() + " " + words)
                           : line_of_mark(inlines, i),
          would_be_shown(words,
                         "only titles, pictures, code and [words] have classes, and all but titles "
                         "right behind them"));
    } else if (const std::string found = class_behind_words(words); !found.empty()) {
      tell_(lines_.next(words),
            would_be_shown(found, "words that have a class stand in brackets, [words]{.class}"));
    } else if (has(words, "](") && has(words, ".toml")) {
      tell_(lines_.next(words),
            would_be_shown(words, "a picture ends with ')' and its settings with '}'"));
    }
  }
  look_for_notes(inlines);
}

// What the deck has marked as words (\<br\>, \\alpha) stands otherwise there, and is shown.
void SlipFinder::look_at_word(const std::string& words, bool in_header) {
  constexpr int kMost = 1000;  // each is looked for in all of the deck
  const bool has_html = is_html(words);
  const std::vector<std::string> commands = latex_in(words);
  if (!has_html && commands.empty()) return;
  if (++marked_words_ > kMost) {
    if (marked_words_ == kMost + 1) {
      tell_(lines_.next(words),
            input_error("a deck may show {} words of HTML and LaTeX; show '{}' and what follows as "
                        "code",
                        kMost,
                        words));
    }
    return;
  }
  if (has_html) {
    // ends are told once
    const int line = lines_.next("\\" + words) > 0 ? 0 : lines_.next(words);
    if (line == 0 || std::exchange(html_told_, true)) return;
    tell_(line,
          would_be_shown(words,
                         "a deck has no HTML; words for the speaker stand in a box (::: notes)"));
    return;
  }
  for (const std::string& command : commands) {
    // texts of YAML may need two backslashes for one
    if (!in_header && lines_.next("\\" + command) > 0) continue;
    tell_(lines_.next(words),
          would_be_shown(words,
                         command == "\\begin{"
                             ? "LaTeX is for formulas ($…$), in which no line is empty"
                             : "LaTeX is for formulas ($…$); words for the speaker stand in a box "
                               "(::: notes)"));
    return;
  }
}

// A mark stands in many lines: that of this one, by what follows it. 0 if that does not tell.
int SlipFinder::line_of_mark(const Json& inlines, std::size_t from) {
  constexpr std::size_t kEnough = 200;
  std::string words;
  for (std::size_t i = from; i < inlines.size() && words.size() < kEnough; ++i) {
    const std::string type = inlines[i]["t"];
    if (type == "SoftBreak") words += '\n';
    if (type == "Space") words += ' ';
    if (type == "Str") words += inlines[i]["c"].get<std::string>();
    if (type != "Str" && type != "Space" && type != "SoftBreak") break;
  }
  for (std::size_t end = words.size(); end != std::string::npos; end = words.rfind('\n', end)) {
    words.resize(end);
    const int line = lines_.next(words);
    if (line > 0) return lines_.next(words) == 0 ? line : 0;
  }
  return 0;
}

void SlipFinder::look_at_classes(const Json& node) {
  const Json* attributes = attributes_of(node);
  if (attributes == nullptr) return;
  for (const Json& one : (*attributes)[1]) {
    const std::string name = one;
    if (!is_almost(name, "notes")) continue;
    const std::string type = node["t"];
    const Json& content = node["c"];
    const bool has_words = type == "Header" || type == "Span" || type == "Link";
    int line = has_words ? lines_.next(plain_text(content[type == "Header" ? 2 : 1])) : 0;
    for (const char* mark : {"``` {.", "~~~ {.", "`{.", "{."})
      if (line == 0) line = lines_.next(mark + name);
    tell_(line,
          input_error("'.{}' hides nothing here: words for the speaker stand in a box (::: notes)",
                      name));
  }
}

}  // namespace polhode
