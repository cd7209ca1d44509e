// SPDX-License-Identifier: MIT
// A deck, read: its text as pandoc's syntax tree, with the pictures that name scenes taken out.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "lecture/sandbox.h"

namespace polhode {

using Json = nlohmann::ordered_json;

enum class PictureKind { film, loop, still, compare, chart, stability, inspect };

struct PictureSetting {
  std::string name;
  std::string doc;
};

// What a picture's class makes of a scene; the table of docs/lecture.md.
struct PictureClass {
  PictureKind kind;
  std::string name;
  std::string doc;
  std::vector<PictureSetting> settings;
};
const std::vector<PictureClass>& picture_classes();

// A picture that names a scene.
struct DeckPicture {
  PictureKind kind = PictureKind::film;
  std::string name;  // unique in the deck, for links: letters, digits, - and _
  std::vector<std::string>
      scenes;  // as the deck names them; more than one where films are compared
  std::map<std::string, std::string> settings;
  Json caption = Json::array();  // inlines
  int line = 0;                  // of the deck, from 1; 0: unknown
};

// The type of the tree's own node that stands for picture number "c" of the deck.
inline constexpr const char* kPictureNode = "PolhodePicture";

struct Deck {
  std::string file;  // as the user named it
  DeckRoot root;
  Json api_version = {1, 22};  // of the tree, pandoc's own
  Json meta = Json::object();  // title, subtitle, author, date, lang, description, licence alone
  Json blocks = Json::array();
  std::vector<DeckPicture> pictures;
  std::vector<std::string> images;  // ordinary pictures, files in the deck's folder
  std::vector<Error> problems;      // what was left out, with the deck's lines

  Json tree(const Json& with_blocks) const;  // a whole document for pandoc
};

// Finds the line of what the tree says, in order: the tree itself has no lines.
class LineFinder {
 public:
  explicit LineFinder(std::string text) : text_(std::move(text)) {}
  // Of the next place at which `words` stand, counted for each words by itself; 0 if there is none.
  int next(const std::string& words);

 private:
  std::string text_;
  std::map<std::string, std::size_t> seen_;  // words -> behind the last place
};

// Throws Error (input) when the file cannot be read as a deck at all; what is wrong in single
// places is left out and told in `problems`.
Deck read_deck(const std::filesystem::path& file, bool allow_outside);
// The same for text in memory.
Deck parse_deck(const std::string& text, const std::string& name, const DeckRoot& root);

// Calls `visit` for every node of the tree that has a type, the outer before the inner.
void for_each_node(Json& tree, const std::function<void(Json&)>& visit);

// The blocks with other blocks in place of each picture.
Json with_pictures(const Json& blocks,
                   const std::function<Json(const DeckPicture&)>& make,
                   const Deck& deck);

// The words of inlines, without marks.
std::string plain_text(const Json& inlines);

// Parts of trees.
Json string_inlines(const std::string& text);
Json raw_html(const std::string& html);
Json paragraph(const Json& inlines);
Json div(const std::string& name, const Json& blocks, const std::string& width = "");

}  // namespace polhode
