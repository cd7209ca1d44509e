// SPDX-License-Identifier: MIT
#include "lecture/deck/dropped_words.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "lecture/deck/deck_fields.h"
#include "lecture/deck/deck_marks.h"
#include "lecture/deck/sandbox.h"
#include "lecture/deck/tree.h"
#include "lecture/deck/word_list.h"

namespace polhode {
namespace {

// The words of pandoc's tree that stand in the text of the deck, each as often as there; `tree`
// may have marks (lecture/deck/deck_marks.h).
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
    if (type == "Note" && is_again(content, Definition::footnote)) return;
    if (type == "Header") {
      for (const Json& name : content[1][1])
        if (name != "unnumbered" || said_.contains(name)) read(name);  // or "{-}"
      read(content[1][2]);
      read(content[2]);
    } else if (type == "Link" || type == "Image") {
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
    if (is_again(content[2][0], Definition::place)) return;
    const std::string target = content[2][0];
    const bool is_of_heading =
        target.starts_with('#') && headings_.contains(percent_decoded(target.substr(1)));
    if (!is_of_heading || takes_place(target.substr(1))) words.add(target);
    read(content[2][1]);
  }

  // Whether a part of the tree is of a definition that has been read.
  bool is_again(const Json& tree, Definition kind) {
    const std::optional<unsigned long> mark = mark_of(tree, kind);
    return mark && !definitions_.insert(*mark).second;
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

  std::map<std::string, int> places_;    // how often "#place" stands in the text
  std::multiset<std::string> headings_;  // names of titles
  std::set<unsigned long> definitions_;  // their marks
  std::set<std::string> said_;           // classes that pandoc knows by other marks, too
};

// Whether an entity is a letter that words have among others: "&ouml;", "&#246;".
bool is_accented(std::string_view entity) {
  constexpr std::string_view kNames[] = {
      "acute;", "grave;", "uml;", "circ;", "tilde;", "ring;", "cedil;", "slash;", "caron;", "lig;"};
  return entity.starts_with("&#") ||
         (entity.starts_with('&') &&
          std::any_of(std::begin(kNames), std::end(kNames), [&](std::string_view name) {
            return entity.ends_with(name);
          }));
}

void blank(std::string& line, std::size_t from, std::size_t to) {
  line.replace(from, to - from, to - from, ' ');
}

// A line of Markdown without words that only mark something: numbers of lists, keys of footnotes
// and references, entities; blanks stand in their place.
std::string without_marks(const std::string& line) {
  if (line.size() > kLongestSearched) return line;
  // lists may begin in lists, definitions, quotations, footnotes and cells, with boxes of tasks
  static const std::regex marks(
      R"(^[Tt]able:)"
      R"(|(^|\|)[\s>]{0,40}(([-*+:~|>]|\[\^[^\]\s]{1,80}\]:|\(@[^\s)]{0,40}\)|\(?([0-9]{1,18}|[A-Za-z]|[ivxlcdm]{1,9}|[IVXLCDM]{1,9})[.)])(\s{1,9}|$)){1,6}(\[[xX]\])?)"
      R"(|\(@[^\s)]{0,40}\)|\[\^[^\]\s]{1,80}\]:?|\]\[[^\]]{0,80}\])"
      R"(|^\[[^\]]{1,80}\]:|&#?[0-9A-Za-z]{1,10};|\bclass=)");
  std::string out = line;
  const auto is_word = [&](std::size_t at) {
    return at < line.size() && (std::isalnum(static_cast<unsigned char>(line[at])) != 0 ||
                                static_cast<unsigned char>(line[at]) >= 0x80);
  };
  const std::size_t begin = std::min(line.find_first_not_of(" \t>"), line.size());
  for (std::sregex_iterator i(line.begin() + static_cast<std::ptrdiff_t>(begin), line.end(), marks),
       end;
       i != end;
       ++i) {
    auto from = begin + static_cast<std::size_t>(i->position());
    std::size_t to = from + static_cast<std::size_t>(i->length());
    // an accented letter is part of a word, which is another one than what stands here
    const bool is_letter = is_accented(std::string_view(line).substr(from, to - from));
    while (is_letter && from > 0 && is_word(from - 1))
      --from;
    while (is_letter && is_word(to))
      ++to;
    blank(out, from, to);
  }
  return out;
}

// How many bytes of a label of an example begin there: letters, digits, "_" and "-".
std::size_t label_length(std::string_view text) {
  const auto end = std::find_if(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isalnum(byte) == 0 && byte < 0x80 && c != '_' && c != '-';
  });
  return static_cast<std::size_t>(end - text.begin());
}

// The labels of numbered examples: "(@mass) It is kept."
std::set<std::string_view> example_labels(std::string_view text) {
  std::set<std::string_view> labels;
  for (std::size_t at = text.find("(@"); at != std::string_view::npos; at = text.find("(@", at + 1))
    labels.insert(text.substr(at + 2, label_length(text.substr(at + 2))));
  return labels;
}

// Blanks in a line what refers to them: "@mass", for which a number stands.
void blank_references(std::string& line, const std::set<std::string_view>& labels) {
  for (std::size_t at = line.find('@'); at != std::string::npos; at = line.find('@', at + 1)) {
    const bool is_in_word = at > 0 && label_length(std::string_view(line).substr(at - 1, 1)) > 0;
    const std::size_t length = label_length(std::string_view(line).substr(at + 1));
    if (!is_in_word && labels.contains(std::string_view(line).substr(at + 1, length)))
      blank(line, at, at + 1 + length);
  }
}

// The same of a whole deck; bytes keep their places.
std::string without_marks_in_all(const std::string& text) {
  const std::set<std::string_view> labels = example_labels(text);
  std::string all;
  std::istringstream in(text);
  bool in_key = false;  // of a reference that goes on in the next line
  for (std::string line; std::getline(in, line);) {
    if (in_key) blank(line, 0, line.find(']') + 1);
    const std::size_t key = line.rfind("][");
    in_key = key != std::string::npos && line.find(']', key + 1) == std::string::npos;
    if (in_key) blank(line, key, line.size());
    blank_references(line, labels);
    all += without_marks(line) + "\n";
  }
  return all;
}

}  // namespace

std::vector<DroppedWord> dropped_words(const std::string& text,
                                       const Json& tree,
                                       std::size_t most) {
  const std::string bare = without_marks_in_all(without_headers(text));
  WordList written;
  written.add(bare);
  std::map<std::string, std::size_t, std::less<>> missing;  // how often
  const std::optional<Json> with_marks = tree_with_marks(text, tree);
  const TreeReader read(text, with_marks ? *with_marks : tree);
  for (const MissingWord& one : written.missing_in(read.words, most))
    missing[one.word] = one.times;
  if (missing.empty()) return {};

  std::vector<Spot> spots;
  for (const std::string_view word : split_words(bare)) {
    if (missing.contains(word))
      spots.push_back({static_cast<std::size_t>(word.data() - bare.data()), word});
  }
  const std::vector<bool> is_read = are_read(text, spots);
  // if in doubt the last ones, as footnotes and references come last
  std::vector<Spot> dropped;
  for (const bool count_read : {false, true}) {
    for (std::size_t i = spots.size(); i-- > 0;) {
      std::size_t& times = missing.find(spots[i].word)->second;
      if (is_read[i] != count_read || times == 0) continue;
      --times;
      dropped.push_back(spots[i]);
    }
  }
  std::sort(
      dropped.begin(), dropped.end(), [](const Spot& a, const Spot& b) { return a.at < b.at; });

  std::vector<DroppedWord> words;
  words.reserve(dropped.size());
  std::size_t counted = 0;  // bytes
  int line = 1;
  for (const Spot& one : dropped) {
    line += static_cast<int>(std::count(bare.data() + counted, bare.data() + one.at, '\n'));
    counted = one.at;
    words.push_back({std::string(one.word), line});
  }
  return words;
}

}  // namespace polhode
