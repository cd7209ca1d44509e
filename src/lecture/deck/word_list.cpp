// SPDX-License-Identifier: MIT
#include "lecture/deck/word_list.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/utf8.h"

namespace polhode {
namespace {

struct Range {
  unsigned long first, last;
};

// Latin letters and digits; LaTeX has commands for others.
constexpr Range kLatin[] = {
    {'0', '9'}, {'A', 'Z'}, {'a', 'z'}, {0xc0, 0xd6}, {0xd8, 0xf6}, {0xf8, 0x24f}};

// All others, and symbols; not spaces, dashes, quotes and what else stands between words, nor signs
// by which Markdown marks something.
constexpr Range kOtherCharacters[] = {
    {0xa2, 0xaa},
    {0xac, 0xac},
    {0xae, 0xb6},
    {0xb8, 0xba},
    {0xbc, 0xbe},
    {0xd7, 0xd7},
    {0xf7, 0xf7},
    {0x250, 0x1fff},
    {0x2030, 0x2034},  // thousandths, minutes
    {0x2070, 0x260f},  // not boxes of lists, which are controls in pages
    {0x2613, 0x2dff},
    {0x3005, 0x3007},
    {0x3041, 0xfdff},
    {0xfe70, 0xfefc},
    {0xff10, 0xff19},
    {0xff21, 0xff3a},
    {0xff41, 0xff5a},
    {0xff66, 0xffdc},
    {0x10000, 0x10ffff}};

// U+FE0E, which pandoc writes behind arrows in pages: they are no pictures
constexpr std::string_view kAsText = "\xef\xb8\x8e";

template <class List>
bool is_in(const List& ranges, unsigned long character) {
  return std::any_of(std::begin(ranges), std::end(ranges), [&](const Range& range) {
    return character >= range.first && character <= range.last;
  });
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

std::vector<std::string_view> split_words(std::string_view text, Letters letters) {
  std::vector<std::string_view> words;
  std::size_t from = 0, at = 0;
  const auto end_word = [&] {
    if (from < at) words.push_back(text.substr(from, at - from));
  };
  while (at < text.size()) {
    const std::size_t length = std::max<std::size_t>(1, utf8_length(text, at));
    const unsigned long character = character_at(text, at);
    const bool goes_on =
        is_in(kLatin, character) || (letters == Letters::all && is_in(kOtherCharacters, character));
    if (!goes_on) {
      end_word();
      from = at + length;
    }
    at += length;
  }
  end_word();
  return words;
}

std::string how_many_more(std::size_t words) {
  return words < kCountedWords ? std::to_string(words - kNamedWords) : "many";
}

std::string named_words(std::vector<std::string> words) {
  if (words.size() > kNamedWords) {
    const std::string more = how_many_more(words.size());
    words.resize(kNamedWords);
    words.back() += fmt::format(" and {} more", more);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

void WordList::add(std::string_view text) {
  if (text.find(kAsText) != std::string_view::npos) {
    std::string plain;
    for (std::size_t from = 0; from < text.size();) {
      const std::size_t at = std::min(text.find(kAsText, from), text.size());
      plain += text.substr(from, at - from);
      from = at + kAsText.size();
    }
    add(plain);
    return;
  }
  for (const std::string_view word : split_words(text, letters_)) {
    all_ += word;
    all_ += ' ';
  }
}

void WordList::add_code(const std::string& code) {
  std::string parts;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const bool is_escaped = i >= 2 && code[i - 2] == '\\';
    const bool is_unit = i >= 1 && is_digit(code[i - 1]) && !is_digit(code[i]);
    if (is_escaped || is_unit) parts += ' ';
    parts += code[i];
  }
  add(parts);
}

std::vector<MissingWord> WordList::missing_in(const WordList& other, std::size_t most) const {
  constexpr std::size_t kMostBytes = 800'000'000;  // a search is in all of both
  std::size_t searches = 200 + kMostBytes / (all_.size() + other.all_.size());
  const std::unordered_map<std::string_view, std::size_t> needed = counts();
  std::unordered_map<std::string_view, std::size_t> there = other.counts();
  std::vector<MissingWord> missing;
  for_each([&](std::string_view word) {
    std::size_t& count = there[word];
    if (count >= needed.at(word) || missing.size() == most || searches == 0) return;
    const std::size_t apart = needed.at(word) - count;
    count = needed.at(word);  // each is looked for once
    --searches;
    const std::size_t here = count_inside(word), inside = other.count_inside(word);
    if (inside < here) missing.push_back({std::string(word), std::min(apart, here - inside)});
  });
  return missing;
}

std::unordered_map<std::string_view, std::size_t> WordList::counts() const {
  std::unordered_map<std::string_view, std::size_t> counts;
  for_each([&](std::string_view word) { ++counts[word]; });
  return counts;
}

std::size_t WordList::count_inside(std::string_view word) const {
  std::size_t count = 0;
  for (std::size_t at = all_.find(word); at != std::string::npos; at = all_.find(word, at + 1))
    ++count;
  return count;
}

}  // namespace polhode
