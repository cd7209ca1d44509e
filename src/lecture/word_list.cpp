// SPDX-License-Identifier: MIT
#include "lecture/word_list.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <utility>

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

using Words = std::vector<std::string_view>;
using Places = std::vector<std::size_t>;  // in a list, from 0

// The word at a place; "" before the first and behind the last.
std::string_view word_at(const Words& words, std::size_t place) {
  return place < words.size() ? words[place] : std::string_view();
}

using PlacesOfWords = std::unordered_map<std::string_view, Places>;
PlacesOfWords places_of(const Words& words) {
  PlacesOfWords places;
  for (std::size_t i = 0; i < words.size(); ++i)
    places[words[i]].push_back(i);
  return places;
}

// Finds at which of its places a word is missing: where it has other neighbours than in the other
// list, or such as are missing, too; of places that are alike at the last ones.
class Placer {
 public:
  Placer(const Words& here, const Words& there) : here_(here), there_(there) {}

  // A word that is missing at `times` of its places here, and stands at those in the other list.
  void add(std::size_t times, const Places& here, const Places& there) {
    Choice choice{times, {here.rbegin(), here.rend()}, {}, {}, {}};
    for (const std::size_t place : there) {
      choice.before.insert(word_at(there_, place - 1));
      choice.behind.insert(word_at(there_, place + 1));
    }
    choices_.push_back(std::move(choice));
  }

  // The places of all words, in the order in which these were added.
  std::vector<Places> settle() {
    constexpr int kRounds = 4;  // what is settled in one may tell of its neighbours in the next
    for (int round = 0; round < kRounds; ++round) {
      for (Choice& one : choices_)
        settle(one, round == 0);
    }
    std::vector<Places> all;
    for (Choice& one : choices_) {
      std::sort(one.missing.begin(), one.missing.end());
      all.push_back(std::move(one.missing));
    }
    return all;
  }

 private:
  struct Choice {
    std::size_t times;
    Places places;  // from the last to the first
    std::unordered_set<std::string_view> before, behind;
    Places missing;
  };

  void settle(Choice& one, bool only_if_sure) {
    for (const std::size_t place : one.missing)
      missing_.erase(place);
    std::vector<std::pair<int, std::size_t>> ranked;  // how many neighbours are the same, place
    for (const std::size_t place : one.places)
      ranked.emplace_back(is_known(one.before, place - 1) + is_known(one.behind, place + 1), place);
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
      return a.first < b.first;
    });
    ranked.resize(one.times);
    one.missing.clear();
    constexpr int kBoth = 2;
    for (const auto& [known, place] : ranked) {
      if (only_if_sure && known == kBoth) break;
      one.missing.push_back(place);
      missing_.insert(place);
    }
  }

  int is_known(const std::unordered_set<std::string_view>& neighbours, std::size_t place) const {
    return !missing_.contains(place) && neighbours.contains(word_at(here_, place)) ? 1 : 0;
  }

  const Words& here_;
  const Words& there_;
  std::vector<Choice> choices_;
  std::unordered_set<std::size_t> missing_;
};

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
  constexpr std::size_t kMostBytes = 800'000'000;  // a search is in all of both
  std::size_t searches = 200 + kMostBytes / (all_.size() + other.all_.size());
  const Words here = words(), there = other.words();
  const PlacesOfWords wanted = places_of(here);
  PlacesOfWords found = places_of(there);
  Placer placer(here, there);
  std::vector<MissingWord> missing;
  for (std::size_t i = 0; i < here.size() && missing.size() < most; ++i) {
    const Places& places = wanted.at(here[i]);
    if (places.front() != i) continue;  // each is looked for once
    const Places& alone = found[here[i]];
    if (alone.size() >= places.size()) continue;
    if (searches-- == 0) break;
    const std::size_t inside = count_inside(here[i]), inside_there = other.count_inside(here[i]);
    if (inside_there >= inside) continue;
    placer.add(std::min(inside - inside_there, places.size() - alone.size()), places, alone);
    missing.push_back({std::string(here[i]), {}});
  }
  const std::vector<Places> settled = placer.settle();
  for (std::size_t i = 0; i < missing.size(); ++i)
    missing[i].places = settled[i];
  return missing;
}

std::vector<std::string_view> WordList::words() const {
  Words words;
  words.reserve(size_);
  for (std::size_t from = 1; from < all_.size();) {
    const std::size_t blank = all_.find(' ', from);
    words.push_back(std::string_view(all_).substr(from, blank - from));
    from = blank + 1;
  }
  return words;
}

std::size_t WordList::count_inside(std::string_view word) const {
  std::size_t count = 0;
  for (std::size_t at = all_.find(word); at != std::string::npos; at = all_.find(word, at + 1))
    ++count;
  return count;
}

}  // namespace polhode
