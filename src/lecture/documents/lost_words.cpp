// SPDX-License-Identifier: MIT
#include "lecture/documents/lost_words.h"

#include <cctype>
#include <cstdio>
#include <map>
#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <libxml/HTMLparser.h>
#include <libxml/parser.h>
#include <minizip/unzip.h>

#include "lecture/deck/sandbox.h"
#include "lecture/deck/word_list.h"

namespace polhode {
namespace {

// An address of the web without what a document may write in another way.
std::string bare_address(const std::string& address) {
  std::string bare = percent_decoded(address);
  std::erase_if(bare, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x80 && std::isalnum(byte) == 0;
  });
  return bare;
}

// Words, and what else is looked for.
struct Shown {
  explicit Shown(Letters letters) : words(letters) {}

  WordList words;
  std::map<std::string, std::string> links;  // by bare_address()
  int formulas = 0;
};

// What is read in all documents: not the descriptions of pictures, which are pictures among words,
// in tables and in footnotes. Formulas count where no document writes them in letters.
class DeckReader {
 public:
  explicit DeckReader(Letters letters) : all(letters) {}

  void read(const Deck& deck) {
    for (const char* field : {"title", "subtitle", "author", "date"})
      if (deck.meta.contains(field)) read(deck.meta[field], false);
    read(deck.blocks, true);
    for (const DeckPicture& picture : deck.pictures)
      read(picture.caption, false);
  }

  Shown all;

 private:
  void read(const Json& tree, bool is_body) {
    if (tree.is_array()) {
      for (const Json& child : tree)
        read(child, is_body);
    }
    if (!tree.is_object() || !tree.contains("t") || !tree.contains("c")) return;
    const std::string type = tree["t"];
    const Json& content = tree["c"];
    if (type == "Str") {
      all.words.add(content.get_ref<const std::string&>());
    } else if (type == "Code" || type == "CodeBlock") {
      all.words.add_code(content[1].get_ref<const std::string&>());
    } else if (type == "Math") {
      all.formulas += is_body && !in_notes_ ? 1 : 0;
    } else if (type == "Link") {
      const std::string address = content[2][0];
      if (!in_notes_ && (address.starts_with("http") || address.starts_with("mailto:")))
        all.links[bare_address(address)] = address;
      read(content[1], is_body);
    } else if (is_image_alone(tree)) {
      if (is_body) read(content[0]["c"][1], false);
    } else if (is_div(tree, "notes")) {
      in_notes_ = true;
      read(content[1], true);
      in_notes_ = false;
    } else if (type != "Image") {
      read(content, is_body && may_hold_figures(tree) && type != "Header");
    }
  }

  bool in_notes_ = false;  // for the speaker: formulas and links are letters there in PowerPoint
};

// Adds the text between the tags of a document; libxml2 calls these with what it has read.
struct TagReader {
  explicit TagReader(Shown& all) : shown(&all) {
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
      if (is(name, "math") || is(name, "m:oMath")) ++reader->shown->formulas;
      for (int i = 0; attributes != nullptr && attributes[i] != nullptr; i += 2) {
        if (attributes[i + 1] == nullptr) continue;
        const std::string value = reinterpret_cast<const char*>(attributes[i + 1]);
        if (is(attributes[i], "href") || is(attributes[i], "Target"))
          reader->shown->links[bare_address(value)] = value;
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
    shown->words.add(text);
    text.clear();
  }

  xmlSAXHandler handler = {};
  Shown* shown;
  std::string text;
};

void add_html(Shown& shown, const std::string& html) {
  TagReader reader(shown);
  const std::unique_ptr<htmlParserCtxt, decltype(&htmlFreeParserCtxt)> parser(
      htmlCreatePushParserCtxt(
          &reader.handler, &reader, nullptr, 0, nullptr, XML_CHAR_ENCODING_UTF8),
      &htmlFreeParserCtxt);
  htmlParseChunk(parser.get(), html.data(), static_cast<int>(html.size()), 1);
  reader.end();
}

void add_xml(Shown& shown, const std::string& xml) {
  TagReader reader(shown);
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
void add_office(Shown& shown, std::string bytes) {
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
      add_xml(shown, unpacked(zip.get(), info));
  }
  if (status != UNZ_END_OF_LIST_OF_FILE)
    throw environment_error("pandoc wrote slides that cannot be read");
}

// The names of commands are words, too; they end at their last letter or digit, for pandoc writes
// digits right behind a name only in code that stands as it is ("\na1").
void add_latex(WordList& words, const std::string& tex) {
  const auto is_of_word = [&](std::size_t at) {
    return at < tex.size() && std::isalnum(static_cast<unsigned char>(tex[at])) != 0;
  };
  std::size_t from = 0;
  for (std::size_t at = tex.find('\\'); at != std::string::npos; at = tex.find('\\', from)) {
    words.add(std::string_view(tex).substr(from, at - from));
    std::size_t end = at + 1;
    while (is_of_word(end))
      ++end;
    words.add(std::string_view(tex).substr(at, end - at));
    from = end;
  }
  words.add(std::string_view(tex).substr(from));
}

}  // namespace

std::vector<std::string> lost_words(const Deck& deck,
                                    const std::string& document,
                                    DocumentForm form,
                                    std::size_t most) {
  // others are commands in LaTeX
  const Letters letters = form == DocumentForm::latex ? Letters::latin : Letters::all;
  DeckReader reader(letters);
  reader.read(deck);
  const Shown& wanted = reader.all;
  Shown shown(letters);
  if (form == DocumentForm::html) add_html(shown, document);
  if (form == DocumentForm::latex) add_latex(shown.words, document);
  if (form == DocumentForm::office) add_office(shown, document);

  std::vector<std::string> lost;
  for (const MissingWord& one : wanted.words.missing_in(shown.words, most))
    lost.push_back(one.word);
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
