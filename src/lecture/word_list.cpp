// SPDX-License-Identifier: MIT
#include "lecture/word_list.h"

#include <algorithm>
#include <iterator>

#include "base/utf8.h"

namespace polhode {
namespace {

// Letters, digits and symbols; not what stands between words, spaces and dashes of all kinds.
bool is_in_words(unsigned long character) {
  struct Range {
    unsigned long first, last;
  };
  constexpr Range kRanges[] = {{'0', '9'},
                               {'A', 'Z'},
                               {'a', 'z'},
                               {0xc0, 0xd6},
                               {0xd8, 0xf6},
                               {0xf8, 0x1fff},
                               {0x2190, 0x260f},  // boxes of lists are controls in pages
                               {0x2613, 0x2dff},
                               {0x3041, 0xfdff},
                               {0x1f000, kLastCharacter}};
  return std::any_of(std::begin(kRanges), std::end(kRanges), [&](const Range& range) {
    return character >= range.first && character <= range.last;
  });
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

void WordList::add(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = std::max<std::size_t>(1, utf8_length(text, i));
    const unsigned long character = character_at(text, i);
    if (is_in_words(character) && character <= last_) {
      all_ += text.substr(i, length);
    } else {
      end_word();
    }
    i += length;
  }
  end_word();
}

void WordList::end_word() {
  if (all_.back() == ' ') return;
  all_ += ' ';
  ++size_;
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
  constexpr int kMostSearches = 200;  // each in all of both
  const std::unordered_map<std::string_view, int> needed = counts();
  std::unordered_map<std::string_view, int> there = other.counts();
  std::vector<MissingWord> missing;
  int searches = 0;
  std::size_t place = 0;
  for_each([&](std::string_view word) {
    const std::size_t its_place = place++;
    int& count = there[word];
    if (count >= needed.at(word) || missing.size() == most || searches == kMostSearches) return;
    count = needed.at(word);  // each is looked for once
    ++searches;
    if (other.count_inside(word) < count_inside(word))
      missing.push_back({std::string(word), its_place});
  });
  return missing;
}

std::unordered_map<std::string_view, int> WordList::counts() const {
  std::unordered_map<std::string_view, int> counts;
  for_each([&](std::string_view word) { ++counts[word]; });
  return counts;
}

int WordList::count_inside(std::string_view word) const {
  int count = 0;
  for (std::size_t at = all_.find(word); at != std::string::npos; at = all_.find(word, at + 1))
    ++count;
  return count;
}

}  // namespace polhode
