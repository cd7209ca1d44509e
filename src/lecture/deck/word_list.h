// SPDX-License-Identifier: MIT
// A text as its words, to see whether another text lacks some of them.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace polhode {

// Which characters words are made of: letters, digits and symbols of all kinds, or Latin letters
// and digits alone.
enum class Letters { all, latin };

// The words of a text in UTF-8, as parts of it.
std::vector<std::string_view> split_words(std::string_view text, Letters letters = Letters::all);

// A word, and how many times it is missing.
struct MissingWord {
  std::string word;
  std::size_t times = 0;
};

// How many missing words a warning names, and how many are counted.
inline constexpr std::size_t kNamedWords = 10, kCountedWords = 1000;
// How many of so many words, more than kNamedWords, it does not name: "7", or "many".
std::string how_many_more(std::size_t words);
// The words as it names them: "a, b", or of many the first ones, "…, j and 7 more".
std::string named_words(std::vector<std::string> words);

// A list of words, which are runs of letters, digits and symbols. All else stands between words.
class WordList {
 public:
  explicit WordList(Letters letters = Letters::all) : letters_(letters) {}

  // Adds the words of a text in UTF-8; its end ends a word.
  void add(std::string_view text);
  // Adds those of code. What documents colour comes in parts: "\nabc" is a line's end and a word,
  // "5kg" may be two.
  void add_code(const std::string& code);

  // The words that stand more often here than in the other list, in their order and each once: at
  // most `most`, and of large lists those among the first few hundred that might be missing. What
  // is one word there may be two here.
  std::vector<MissingWord> missing_in(const WordList& other, std::size_t most) const;

 private:
  // how often each word stands by itself
  std::unordered_map<std::string_view, std::size_t> counts() const;
  // how often a word stands there, also inside others
  std::size_t count_inside(std::string_view word) const;

  // Calls `visit` with each word (std::string_view), in their order.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t from = 1; from < all_.size();) {
      const std::size_t blank = all_.find(' ', from);
      visit(std::string_view(all_).substr(from, blank - from));
      from = blank + 1;
    }
  }

  std::string all_ = " ";  // one blank before and behind each
  Letters letters_;
};

}  // namespace polhode
