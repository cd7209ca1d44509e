// SPDX-License-Identifier: MIT
#include "lecture/dropped_words.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "lecture/sandbox.h"
#include "lecture/tree.h"
#include "lecture/word_list.h"

namespace polhode {
namespace {

// The words of pandoc's tree that stand in the text of the deck, each as often as there.
class TreeReader {
 public:
  TreeReader(const std::string& text, const Json& tree) {
    for (const char* name : {"unnumbered", "underline", "ul", "smallcaps"})
      if (text.find(name) != std::string::npos) said_.insert(name);
    for (std::size_t at = text.find('#'); at != std::string::npos; at = text.find('#', at + 1)) {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n})>]\"'#", at + 1), text.size());
      ++places_[text.substr(at + 1, end - at - 1)];
    }
    for_each_node(tree["blocks"], [&](const Json& node) {
      if (node["t"] == "Header") headings_.insert(node["c"][1][0].get<std::string>());
    });
    read(tree["blocks"]);
    // what stands there and has not led to them
    for (const std::string& heading : headings_)
      if (takes_place(heading)) words.add(heading);
    // fields are not in the text, but it may have their footnotes, and say where links lead
    for_each_node(tree["meta"], [&](const Json& node) {
      if (node["t"] == "Note") read(node["c"]);
      if (node["t"] == "Link") read(node["c"][2]);
    });
  }

  WordList words;

 private:
  void read(const Json& tree) {
    if (tree.is_string()) words.add(tree.get_ref<const std::string&>());
    if (tree.is_array()) {
      for (const Json& child : tree)
        read(child);
    }
    if (!tree.is_object() || !tree.contains("c")) return;
    const std::string type = tree["t"];
    const Json& content = tree["c"];
    if (type == "Header") {
      for (const Json& name : content[1][1])
        if (name != "unnumbered" || said_.contains(name)) read(name);  // or "{-}"
      read(content[1][2]);
      read(content[2]);
    } else if (type == "Link") {
      read_link(content);
    } else {
      // classes that have become kinds of nodes
      if (type == "SmallCaps") read_said({"smallcaps"});
      if (type == "Underline") read_said({"underline", "ul"});
      read(content);
    }
  }

  void read_link(const Json& content) {
    read(content[1]);
    // <https://example.org> and <a@example.org> say once where they lead
    const Json& classes = content[0][1];
    const auto has = [&](const char* name) {
      return std::find(classes.begin(), classes.end(), name) != classes.end();
    };
    if (has("uri") || has("email")) return;
    read(content[0]);
    const std::string target = content[2][0];
    const bool is_of_heading =
        target.starts_with('#') && headings_.contains(percent_decoded(target.substr(1)));
    if (!is_of_heading || takes_place(target.substr(1))) words.add(target);
    read(content[2][1]);
  }

  // Of titles that have no name pandoc makes one, and [Title] leads there.
  bool takes_place(const std::string& place) {
    const auto found = places_.find(place);
    return found != places_.end() && found->second-- > 0;
  }

  void read_said(const std::vector<std::string>& names) {
    for (const std::string& name : names)
      if (said_.contains(name)) words.add(name);
  }

  std::map<std::string, int> places_;  // how often "#place" stands in the text
  std::set<std::string> headings_;     // names of titles
  std::set<std::string> said_;         // classes that pandoc knows by other marks, too
};

// A line of Markdown without words that only mark something: numbers of lists, keys of footnotes
// and references, entities; blanks stand in their place.
std::string without_marks(std::string line) {
  constexpr std::size_t kLong = 2000;  // a search takes a microsecond for each byte
  if (line.size() > kLong) return line;
  static const std::regex marks(
      R"(^[\s>]{0,40}([Tt]able:|[-*+]\s{1,4}\[[xX]\]))"
      // lists may begin in lists, definitions, footnotes and cells
      R"(|^[\s>]{0,40}(([-*+:~|]|\[\^[^\]\s]{1,80}\]:|\(?([0-9]{1,9}|[A-Za-z]|[ivxlcdm]{1,9}|[IVXLCDM]{1,9})[.)])\s{1,9}){1,6})"
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
  const TreeReader read(text, tree);
  WordList written;
  std::vector<int> lines;  // of all words that are written
  std::istringstream all(text);
  int number = 0;
  bool in_key = false;  // of a reference that goes on in the next line
  for (std::string line; std::getline(all, line);) {
    if (in_key) line.erase(0, line.find(']') + 1);
    const std::size_t key = line.rfind("][");
    in_key = key != std::string::npos && line.find(']', key + 1) == std::string::npos;
    if (in_key) line.erase(key);
    written.add(without_marks(line));
    lines.resize(written.size(), ++number);
  }
  std::map<std::size_t, std::string> missing;  // by places
  for (const MissingWord& one : written.missing_in(read.words, most)) {
    for (const std::size_t place : one.places)
      missing[place] = one.word;
  }
  std::vector<DroppedWord> dropped;
  dropped.reserve(missing.size());
  for (const auto& [place, word] : missing)
    dropped.push_back({word, lines[place]});
  return dropped;
}

}  // namespace polhode
