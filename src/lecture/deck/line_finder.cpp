// SPDX-License-Identifier: MIT
#include "lecture/deck/line_finder.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace polhode {
namespace {

// Puts blanks in the place of code, which names nothing. Code is found in the order of the text.
class CodeBlanker {
 public:
  explicit CodeBlanker(std::string& text) : text_(text), line_(text) {
    std::replace(line_.begin(), line_.end(), '\n', ' ');
  }

  // All code in blocks of pandoc's tree, whose footnotes stand where they are named and not where
  // they are written.
  void blank_all(const Json& blocks) {
    blank_code(blocks, false, false);
    from_ = 0;
    blank_code(blocks, true, false);
  }

 private:
  static constexpr int kMostMisses = 100;  // each is a search in all that follows

  void blank_code(const Json& tree, bool of_notes, bool in_note) {
    if (tree.is_object() && tree.contains("t")) {
      const std::string type = tree["t"];
      in_note = in_note || type == "Note";
      if (in_note == of_notes && type == "Code") blank_words(tree["c"][1]);
      if (in_note == of_notes && type == "CodeBlock") blank_lines(tree["c"][1]);
    }
    if (!tree.is_structured()) return;
    for (const Json& child : tree)
      blank_code(child, of_notes, in_note);
  }

  // code among words, which may go on in the next line
  void blank_words(const std::string& code) {
    if (code.empty() || misses_ > kMostMisses) return;
    const auto is_mark = [&](std::size_t at) {
      return at < line_.size() && line_[at] == '`';
    };
    const auto is_blank = [&](std::size_t at) {
      return at < line_.size() && line_[at] == ' ';
    };
    for (std::size_t at = line_.find(code, from_); at != std::string::npos;
         at = line_.find(code, at + 1)) {
      const std::size_t end = at + code.size();
      const bool begins = is_mark(at - 1) || (is_blank(at - 1) && is_mark(at - 2));
      const bool ends = is_mark(end) || (is_blank(end) && is_mark(end + 1));
      if (!begins || !ends) continue;
      blank(at, code.size());
      return;
    }
    ++misses_;
  }

  // a block of code, which may be indented or quoted
  void blank_lines(const std::string& code) {
    std::istringstream lines(code);
    bool is_first = true;
    for (std::string line; std::getline(lines, line) && misses_ <= kMostMisses;) {
      line.erase(0, line.find_first_not_of(" \t>"));
      if (line.empty()) continue;
      blank_line(line, is_first);
      is_first = false;
    }
  }

  // is_first: behind a fence or indented, for other words may say the same
  void blank_line(const std::string& code, bool is_first) {
    std::size_t start = from_ == 0 ? 0 : text_.find('\n', from_ - 1);
    bool is_fenced = false;
    while (start < text_.size()) {
      const std::size_t at = text_.find_first_not_of(" \t>\n\r", start);
      if (at == std::string::npos) break;
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      const bool may_begin = is_fenced || is_indented(at);
      if ((may_begin || !is_first) && text_.compare(at, code.size(), code) == 0 &&
          text_.find_first_not_of(" \t\r", at + code.size()) >= end) {
        blank(at, code.size());
        return;
      }
      is_fenced = text_.compare(at, 3, "```") == 0 || text_.compare(at, 3, "~~~") == 0;
      start = end;
    }
    ++misses_;
  }

  bool is_indented(std::size_t at) const {
    constexpr std::size_t kDeep = 4;
    const std::size_t before = at == 0 ? 0 : text_.find_last_not_of(' ', at - 1) + 1;
    return at - before >= kDeep || (before > 0 && text_[before - 1] == '\t');
  }

  void blank(std::size_t at, std::size_t length) {
    from_ = at + length;
    for (std::size_t i = at; i < from_; ++i)
      text_[i] = text_[i] == '\n' ? '\n' : ' ';
  }

  std::string& text_;
  std::string line_;  // all of it in one
  std::size_t from_ = 0;
  int misses_ = 0;
};

}  // namespace

LineFinder::LineFinder(std::string text, const Json& blocks) : text_(std::move(text)) {
  for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1))
    line_ends_.push_back(at);
  CodeBlanker(text_).blank_all(blocks);
}

int LineFinder::next(const std::string& words) {
  if (words.empty()) return 0;
  std::size_t& from = seen_[words];
  std::size_t at = text_.find(words, from);
  // in tables this sign has one before it
  if (const std::size_t bar = words.find('|'); bar != std::string::npos)
    at = std::min(at, text_.find(std::string(words).insert(bar, "\\"), from));
  from = at == std::string::npos ? text_.size() : at + words.size();
  if (at == std::string::npos) return 0;
  const auto end = std::lower_bound(line_ends_.begin(), line_ends_.end(), at);
  return static_cast<int>(end - line_ends_.begin()) + 1;
}

}  // namespace polhode
