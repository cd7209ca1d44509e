// SPDX-License-Identifier: MIT
#include "lecture/dropped_words.h"

#include <cctype>
#include <regex>
#include <sstream>

#include "lecture/word_list.h"

namespace polhode {
namespace {

// all that a tree of pandoc says, whatever it is for
void add_all(WordList& words, const Json& tree) {
  if (tree.is_string()) words.add(tree.get_ref<const std::string&>());
  if (tree.is_object()) {
    for (const auto& [key, value] : tree.items())
      words.add(key);
    // classes of words have become kinds of nodes: Underline, SmallCaps
    std::string type = tree.value("t", "");
    for (char& c : type)
      c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    words.add(type);
  }
  if (!tree.is_structured()) return;
  for (const Json& child : tree)
    add_all(words, child);
}

// A line of Markdown without words that only mark something: numbers of lists, keys of footnotes
// and references, entities; blanks stand in their place.
std::string without_marks(std::string line) {
  constexpr std::size_t kLong = 2000;  // a search takes a microsecond for each byte
  if (line.size() > kLong) return line;
  static const std::regex marks(
      R"(^[\s>]{0,40}([Tt]able:|#.{0,200}$|[-*+]\s{1,4}\[[xX]\]))"
      // lists may begin in lists, definitions, footnotes and cells
      R"(|^[\s>]{0,40}(([-*+:~|]|\[\^[^\]\s]{1,80}\]:|\(?[0-9A-Za-z]{1,9}[.)])\s{1,9}){1,6})"
      R"(|\(@[^\s)]{0,40}\)|\[\^[^\]\s]{1,80}\]:?|\]\s?\[[^\]]{0,80}\])"
      R"(|^[\s>]{0,40}\[[^\]]{1,80}\]:|&#?[0-9A-Za-z]{1,10};|\bclass=)");
  std::string out;
  auto from = line.cbegin();
  for (std::sregex_iterator i(line.begin(), line.end(), marks), end; i != end; ++i) {
    out.append(from, line.cbegin() + i->position());
    out.append(static_cast<std::size_t>(i->length()), ' ');
    from = line.cbegin() + i->position() + i->length();
  }
  return out.append(from, line.cend());
}

}  // namespace

std::vector<DroppedWord> dropped_words(const std::string& text,
                                       const Json& tree,
                                       std::size_t most) {
  WordList read, written;
  add_all(read, tree);
  std::vector<int> lines;  // of all words that are written
  std::istringstream all(text);
  int number = 0;
  for (std::string line; std::getline(all, line);) {
    written.add(without_marks(line));
    lines.resize(written.size(), ++number);
  }
  std::vector<DroppedWord> dropped;
  for (const MissingWord& one : written.missing_in(read, most))
    dropped.push_back({one.word, lines[one.place]});
  return dropped;
}

}  // namespace polhode
