// SPDX-License-Identifier: MIT
#include "lecture/lost_words.h"

#include <cctype>
#include <cstdio>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>
#include <unordered_map>

#include <fmt/format.h>
#include <libxml/HTMLparser.h>
#include <libxml/parser.h>
#include <minizip/unzip.h>

#include "base/utf8.h"
#include "lecture/sandbox.h"

namespace polhode {
namespace {

constexpr unsigned long kLastCharacter = 0x10ffff;
constexpr unsigned long kLastLatin = 0x24f;  // others are commands in LaTeX

// The number of a character of UTF-8 with `length` bytes.
unsigned long number_of(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  unsigned long number = character.size() == 1 ? first : first & (0xffU >> (character.size() + 1));
  for (const char byte : character.substr(1))
    number = number << 6U | (static_cast<unsigned char>(byte) & 0x3fU);
  return number;
}

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

// An address of the web without what a document may write in another way.
std::string bare_address(const std::string& address) {
  std::string bare = percent_decoded(address);
  std::erase_if(bare, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x80 && std::isalnum(byte) == 0;
  });
  return bare;
}

// Words with one blank before and behind each, and what else is looked for.
class Words {
 public:
  explicit Words(unsigned long last) : last_(last) {}

  std::map<std::string, std::string> links;  // by bare_address()
  int formulas = 0;
  bool in_notes = false;  // for the speaker, which have both in letters in PowerPoint

  // the end of a text ends a word
  void add(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
      const std::size_t length = std::max<std::size_t>(1, utf8_length(text, i));
      const std::string_view character = text.substr(i, length);
      const unsigned long number = number_of(character);
      if (is_in_words(number) && number <= last_) {
        all_ += character;
      } else {
        end();
      }
      i += length;
    }
    end();
  }

  // What documents colour comes in parts: "\nabc" is a line's end and a word, "5kg" may be two.
  void add_code(const std::string& code) {
    std::string parts;
    for (std::size_t i = 0; i < code.size(); ++i) {
      const bool is_escaped = i >= 2 && code[i - 2] == '\\';
      const bool is_unit = i >= 1 && is_digit(code[i - 1]) && !is_digit(code[i]);
      if (is_escaped || is_unit) parts += ' ';
      parts += code[i];
    }
    add(parts);
  }

  // how often a word stands by itself
  std::unordered_map<std::string_view, int> counts() const {
    std::unordered_map<std::string_view, int> counts;
    for_each([&](std::string_view word) { ++counts[word]; });
    return counts;
  }

  // how often it stands there, also inside others
  int count_inside(std::string_view word) const {
    int count = 0;
    for (std::size_t at = all_.find(word); at != std::string::npos; at = all_.find(word, at + 1))
      ++count;
    return count;
  }

  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t from = 1; from < all_.size();) {
      const std::size_t blank = all_.find(' ', from);
      visit(std::string_view(all_).substr(from, blank - from));
      from = blank + 1;
    }
  }

 private:
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  void end() {
    if (all_.back() != ' ') all_ += ' ';
  }

  std::string all_ = " ";
  unsigned long last_;  // of the characters that count
};

// What is read in all documents: not the descriptions of pictures, which are pictures among words,
// in tables and in footnotes. Formulas count where no document writes them in letters.
void add_tree(Words& words, const Json& tree, bool is_body) {
  if (tree.is_array()) {
    for (const Json& child : tree)
      add_tree(words, child, is_body);
  }
  if (!tree.is_object() || !tree.contains("t") || !tree.contains("c")) return;
  const std::string type = tree["t"];
  if (type == "Str") {
    words.add(tree["c"].get_ref<const std::string&>());
  } else if (type == "Code" || type == "CodeBlock") {
    words.add_code(tree["c"][1].get_ref<const std::string&>());
  } else if (type == "Math") {
    words.formulas += is_body && !words.in_notes ? 1 : 0;
  } else if (type == "Link") {
    const std::string address = tree["c"][2][0];
    if (!words.in_notes && (address.starts_with("http") || address.starts_with("mailto:")))
      words.links[bare_address(address)] = address;
    add_tree(words, tree["c"][1], is_body);
  } else if (is_image_alone(tree)) {
    if (is_body) add_tree(words, tree["c"][0]["c"][1], false);
  } else if (is_div(tree, "notes")) {
    words.in_notes = true;
    add_tree(words, tree["c"][1], true);
    words.in_notes = false;
  } else if (type != "Image") {
    add_tree(words, tree["c"], is_body && may_hold_figures(tree) && type != "Header");
  }
}

Words words_of_deck(const Deck& deck, unsigned long last) {
  Words words(last);
  for (const char* field : {"title", "subtitle", "author"})
    if (deck.meta.contains(field)) add_tree(words, deck.meta[field], false);
  words.links.clear();  // a title has none in pages
  add_tree(words, deck.blocks, true);
  for (const DeckPicture& picture : deck.pictures)
    add_tree(words, picture.caption, false);
  return words;
}

// Adds the text between the tags of a document; libxml2 calls these with what it has read.
struct TagReader {
  explicit TagReader(Words& all) : words(&all) {
    handler.characters = [](void* self, const xmlChar* piece, int length) {
      auto* reader = static_cast<TagReader*>(self);
      reader->text.append(reinterpret_cast<const char*>(piece), static_cast<std::size_t>(length));
    };
    handler.startElement = [](void* self, const xmlChar* name, const xmlChar** attributes) {
      auto* reader = static_cast<TagReader*>(self);
      reader->end();
      const auto is = [](const xmlChar* name_or_key, const char* what) {
        return xmlStrEqual(name_or_key, reinterpret_cast<const xmlChar*>(what)) != 0;
      };
      if (is(name, "math") || is(name, "m:oMath")) ++reader->words->formulas;
      for (int i = 0; attributes != nullptr && attributes[i] != nullptr; i += 2) {
        if (attributes[i + 1] == nullptr) continue;
        const std::string value = reinterpret_cast<const char*>(attributes[i + 1]);
        if (is(attributes[i], "href") || is(attributes[i], "Target"))
          reader->words->links[bare_address(value)] = value;
      }
    };
    handler.endElement = [](void* self, const xmlChar*) {
      static_cast<TagReader*>(self)->end();
    };
    // scripts and styles
    handler.cdataBlock = [](void*, const xmlChar*, int) {
    };
  }

  void end() {
    words->add(text);
    text.clear();
  }

  xmlSAXHandler handler = {};
  Words* words;
  std::string text;
};

void add_html(Words& words, const std::string& html) {
  TagReader reader(words);
  const std::unique_ptr<htmlParserCtxt, decltype(&htmlFreeParserCtxt)> parser(
      htmlCreatePushParserCtxt(
          &reader.handler, &reader, nullptr, 0, nullptr, XML_CHAR_ENCODING_UTF8),
      &htmlFreeParserCtxt);
  htmlParseChunk(parser.get(), html.data(), static_cast<int>(html.size()), 1);
  reader.end();
}

void add_xml(Words& words, const std::string& xml) {
  TagReader reader(words);
  const std::unique_ptr<xmlParserCtxt, decltype(&xmlFreeParserCtxt)> parser(
      xmlCreatePushParserCtxt(&reader.handler, &reader, nullptr, 0, nullptr), &xmlFreeParserCtxt);
  xmlCtxtUseOptions(parser.get(), XML_PARSE_NOENT | XML_PARSE_NONET);  // & in attributes
  if (xmlParseChunk(parser.get(), xml.data(), static_cast<int>(xml.size()), 1) != 0)
    throw environment_error("pandoc wrote a slide that is no XML");
  reader.end();
}

// the file of an archive at which minizip stands
std::string unpacked(unzFile zip, const unz_file_info64& info) {
  std::string bytes(info.uncompressed_size, '\0');
  const bool is_whole =
      unzOpenCurrentFile(zip) == UNZ_OK &&
      unzReadCurrentFile(zip, bytes.data(), static_cast<unsigned>(bytes.size())) ==
          static_cast<int>(bytes.size()) &&
      unzCloseCurrentFile(zip) == UNZ_OK;
  if (!is_whole) throw environment_error("pandoc wrote slides that cannot be read");
  return bytes;
}

// the slides of a ZIP archive, the notes of these, and where their links lead
void add_office(Words& words, std::string bytes) {
  zlib_filefunc_def memory;
  fill_fopen_filefunc(&memory);
  memory.opaque = &bytes;
  memory.zopen_file = [](void* opaque, const char*, int) -> void* {
    auto* all = static_cast<std::string*>(opaque);
    return fmemopen(all->data(), all->size(), "rb");
  };
  const std::unique_ptr<void, decltype(&unzClose)> zip(unzOpen2("", &memory), &unzClose);
  int status = zip == nullptr ? UNZ_BADZIPFILE : unzGoToFirstFile(zip.get());
  for (; status == UNZ_OK; status = unzGoToNextFile(zip.get())) {
    unz_file_info64 info = {};
    char name[100] = {};
    unzGetCurrentFileInfo64(zip.get(), &info, name, sizeof name - 1, nullptr, 0, nullptr, 0);
    const std::string_view path = name;
    if ((path.ends_with(".xml") || path.ends_with(".rels")) &&
        (path.starts_with("ppt/slides/") || path.starts_with("ppt/notesSlides/")))
      add_xml(words, unpacked(zip.get(), info));
  }
  if (status != UNZ_END_OF_LIST_OF_FILE)
    throw environment_error("pandoc wrote slides that cannot be read");
}

// The names of commands are words, too, and end at their last letter.
void add_latex(Words& words, const std::string& tex) {
  const auto is_letter = [&](std::size_t at) {
    return at < tex.size() && std::isalpha(static_cast<unsigned char>(tex[at])) != 0;
  };
  std::size_t from = 0;
  for (std::size_t at = tex.find('\\'); at != std::string::npos; at = tex.find('\\', from)) {
    words.add(std::string_view(tex).substr(from, at - from));
    std::size_t end = at + 1;
    while (is_letter(end))
      ++end;
    words.add(std::string_view(tex).substr(at, end - at));
    from = end;
  }
  words.add(std::string_view(tex).substr(from));
}

// all that a tree of pandoc says, whatever it is for
void add_all(Words& words, const Json& tree) {
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
      R"(^[\s>]{0,40}(\(?[0-9A-Za-z]{1,9}[.)]\s|[Tt]able:|#.{0,200}$|[-*+]\s{1,4}\[[xX]\]))"
      R"(|\(@[^\s)]{0,40}\)|\[\^[^\]\s]{1,80}\]:?|\]\s?\[[^\]]{0,80}\]|^\s{0,3}\[[^\]]{1,80}\]:|&#?[0-9A-Za-z]{1,10};)");
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
  Words read(kLastCharacter), written(kLastCharacter);
  add_all(read, tree);
  std::vector<DroppedWord> words;  // all, with their lines
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    Words its(kLastCharacter);
    its.add(without_marks(line));
    its.for_each([&](std::string_view word) {
      written.add(word);
      words.push_back({std::string(word), number});
    });
  }
  const std::unordered_map<std::string_view, int> there = read.counts(), needed = written.counts();
  std::set<std::string_view> looked_at;
  std::vector<DroppedWord> dropped;
  constexpr std::size_t kMostSearches = 200;  // each in all of the deck
  for (const DroppedWord& one : words) {
    const auto found = there.find(one.word);
    if (found != there.end() && found->second >= needed.at(one.word)) continue;
    if (dropped.size() == most || looked_at.size() == kMostSearches) break;
    if (looked_at.insert(one.word).second &&
        read.count_inside(one.word) < written.count_inside(one.word))
      dropped.push_back(one);
  }
  return dropped;
}

std::vector<std::string> lost_words(const Deck& deck,
                                    const std::string& document,
                                    DocumentForm form,
                                    std::size_t most) {
  const unsigned long last = form == DocumentForm::latex ? kLastLatin : kLastCharacter;
  const Words wanted = words_of_deck(deck, last);
  Words shown(last);
  if (form == DocumentForm::html) add_html(shown, document);
  if (form == DocumentForm::latex) add_latex(shown, document);
  if (form == DocumentForm::office) add_office(shown, document);

  const std::unordered_map<std::string_view, int> needed = wanted.counts();
  std::unordered_map<std::string_view, int> there = shown.counts();
  std::vector<std::string> lost;
  constexpr int kMostSearches = 200;  // each in all of the document
  int searches = 0;
  wanted.for_each([&](std::string_view word) {
    int& count = there[word];
    if (count >= needed.at(word) || lost.size() == most || searches == kMostSearches) return;
    // what the deck writes as two words may be one there
    count = needed.at(word);
    ++searches;
    if (shown.count_inside(word) < wanted.count_inside(word)) lost.emplace_back(word);
  });
  if (form == DocumentForm::latex) return lost;
  if (shown.formulas < wanted.formulas) {
    lost.push_back(
        fmt::format("{} of {} formulas", wanted.formulas - shown.formulas, wanted.formulas));
  }
  for (const auto& [bare, address] : wanted.links) {
    if (!shown.links.contains(bare) && lost.size() < most) lost.push_back("the link to " + address);
  }
  return lost;
}

}  // namespace polhode
