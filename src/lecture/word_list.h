// SPDX-License-Identifier: MIT
// A text as its words, to see whether another text lacks some of them.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

namespace polhode {

inline constexpr unsigned long kLastCharacter = 0x10ffff;

// A list of words, which are runs of letters, digits and symbols. All else stands between words.
class WordList {
 public:
  // last: the number (code point) of the last character that may belong to a word.
  explicit WordList(unsigned long last = kLastCharacter) : last_(last) {}

  // Adds the words of a text in UTF-8; its end ends a word.
  void add(std::string_view text);
  // Adds those of code. What documents colour comes in parts: "\nabc" is a line's end and a word,
  // "5kg" may be two.
  void add_code(const std::string& code);

  // How often each word stands by itself; valid until words are added.
  std::unordered_map<std::string_view, int> counts() const;
  // How often a word stands there, also inside others.
  int count_inside(std::string_view word) const;

  // Calls `visit` with each word (std::string_view), in their order.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t from = 1; from < all_.size();) {
      const std::size_t blank = all_.find(' ', from);
      visit(std::string_view(all_).substr(from, blank - from));
      from = blank + 1;
    }
  }

 private:
  void end_word() {
    if (all_.back() != ' ') all_ += ' ';
  }

  std::string all_ = " ";  // one blank before and behind each
  unsigned long last_;
};

}  // namespace polhode
