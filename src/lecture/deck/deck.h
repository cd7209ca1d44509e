// SPDX-License-Identifier: MIT
// Reads a deck, the Markdown source of a lecture: its text becomes pandoc's syntax tree (nodes with
// a type "t" and contents "c"), with pictures that name scenes taken out.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "lecture/deck/picture_classes.h"
#include "lecture/deck/sandbox.h"
#include "lecture/deck/tree.h"

namespace polhode {

// A picture that names a scene.
struct DeckPicture {
  PictureKind kind = PictureKind::film;
  std::string name;                 // unique in the deck, for files; letters, digits, - and _
  std::string place;                // what links call it, as the deck has it; unique in the deck
  std::vector<std::string> scenes;  // as the deck names them; 2 to 4 for a comparison, else 1
  std::map<std::string, std::string> settings;  // those that the deck gives, not yet parsed
  Json caption = Json::array();                 // inlines of pandoc's tree
  int line = 0;                                 // of the deck, from 1; 0: unknown
};

// The type of the node that stands for a picture in the tree; its "c" is the index
// in Deck::pictures.
inline constexpr const char* kPictureNode = "PolhodePicture";

// A deck that has been read.
struct Deck {
  std::string file;  // as the user named it
  DeckRoot root;
  Json api_version = {1, 22};   // pandoc's version of the tree format
  Json meta = Json::object();   // see lecture/deck/deck_fields.h
  Json blocks = Json::array();  // blocks of pandoc's tree, with a kPictureNode for each picture
  std::vector<DeckPicture> pictures;
  std::vector<std::string> images;  // files of ordinary pictures, relative to the deck's folder
  std::vector<Error> problems;      // what was left out; place: the deck and the line, if known
  std::vector<Error> remarks;       // what is in it for nothing; as above
  // formulas with quotes: as they are with numbers -> as the deck has them
  std::map<std::string, std::string> with_numbers;

  // A complete document for pandoc: these blocks with the deck's metadata.
  Json tree(const Json& with_blocks) const;
};

// Reads a deck of at most 4 MiB. Faulty parts are left out and reported in Deck::problems.
// allow_outside: see DeckRoot (lecture/deck/sandbox.h). Throws Error (input), with the file as
// place, if it cannot be read as a deck; (environment) without pandoc; (interrupted).
Deck read_deck(const std::filesystem::path& file, bool allow_outside);
// Does the same for a text in memory of any size; `name` is the file name for messages. Errors that
// it throws have no place.
Deck parse_deck(const std::string& text, const std::string& name, const DeckRoot& root);
// The same from pandoc's tree of that text, as parse_tree() in lecture/deck/pandoc.h returns it.
Deck deck_of_tree(Json tree,
                  const std::string& text,
                  const std::string& name,
                  const DeckRoot& root);

// A copy of the blocks of `deck` (or of some of them) in which each picture is replaced by the
// array of blocks that `make` returns.
Json with_pictures(const Json& blocks,
                   const std::function<Json(const DeckPicture&)>& make,
                   const Deck& deck);

}  // namespace polhode
