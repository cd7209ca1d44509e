// SPDX-License-Identifier: MIT
// A text as its words, to see whether another text lacks some of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

inline constexpr unsigned long kLastCharacter = 0x10ffff;

// A word, and its places in its list, from 0.
struct MissingWord {
  std::string word;
  std::vector<std::size_t> places;
};

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

  // How many there are.
  std::size_t size() const { return size_; }

  // The words that stand more often here than in the other list, in the order of their first
  // places, with as many places as they are missing there (of several those with other neighbours).
  // At most `most`, and of large lists those among the first few hundred that might be missing.
  // What is one word there may be two here.
  std::vector<MissingWord> missing_in(const WordList& other, std::size_t most) const;

 private:
  std::vector<std::string_view> words() const;
  // how often a word stands there, also inside others
  std::size_t count_inside(std::string_view word) const;
  void end_word();

  std::string all_ = " ";  // one blank before and behind each
  std::size_t size_ = 0;
  unsigned long last_;
};

}  // namespace polhode
