// SPDX-License-Identifier: MIT
// Longer than most: one walk over the tree of pandoc, each kind of block in a short function.
#include "lecture/deck/deck.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

#include "base/nearest.h"
#include "base/numbers.h"
#include "base/system/atomic_file.h"
#include "base/utf8.h"
#include "lecture/deck/deck_fields.h"
#include "lecture/deck/dropped_words.h"
#include "lecture/deck/line_finder.h"
#include "lecture/deck/own_pictures.h"
#include "lecture/deck/pandoc.h"
#include "lecture/deck/slips.h"
#include "lecture/deck/word_list.h"

namespace polhode {
namespace {

constexpr std::size_t kLargestDeck = 4U << 20U;  // bytes

// names of what has them, for suggestions
template <class List>
std::vector<std::string> names_of(const List& list) {
  std::vector<std::string> names;
  names.reserve(list.size());
  for (const auto& one : list)
    names.push_back(one.name);
  return names;
}

const PictureClass* find_class(const std::string& name) {
  for (const PictureClass& row : picture_classes()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

// "../Free top.toml" to "Free-top"
std::string name_from(const std::string& file) {
  std::string name = std::filesystem::path(file).stem().string();
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || (std::isalnum(byte) == 0 && c != '_')) c = '-';
  }
  return name.empty() ? "picture" : name;
}

class Reader {
 public:
  Reader(Deck& deck, const std::string& text, const Json& blocks)
      : deck_(deck),
        lines_(text, blocks),
        slips_(lines_, [this](int line, const Error& error) { tell(line, error); }) {}

  void read(Json& node) {
    if (node.is_array()) {
      for (Json& child : node)
        read(child);
      return;
    }
    if (!node.is_object() || !node.contains("t")) return;
    if (node["t"] == "Header" && in_box_) settle_title(node);
    const std::string type = node["t"];
    if (is_image_alone(node) && names_scene(node["c"][0])) {
      take_out(node);
      return;
    }
    if (is_image_alone(node) && !among_words_) {
      read_image(node["c"][0]);
      return;
    }
    if (type == "Image") {
      read_image(node);
      if (node["t"] == "Image") make_words(node);
      return;
    }
    const bool was_among_words =
        std::exchange(among_words_, among_words_ || !may_hold_figures(node));
    if (type == "RawBlock" || type == "RawInline") {
      tell(0, input_error("raw {} is not allowed in a deck", node["c"][0].get<std::string>()));
      node = type == "RawBlock" ? paragraph(Json::array()) : string_inlines("")[0];
      return;
    }
    slips_.look_at(node, in_header_);
    if (type == "Link") read_link(node);
    if (type == "Math") read_formula(node);
    if (Json* attributes = attributes_of(node)) {
      clean(*attributes, type);
      take_place(*attributes);
    }
    const bool was_in_box = std::exchange(in_box_, in_box_ || type == "Div");
    const bool was_in_notes = std::exchange(in_notes_, in_notes_ || is_div(node, "notes"));
    if (node.contains("c")) read(node["c"]);
    in_box_ = was_in_box;
    in_notes_ = was_in_notes;
    among_words_ = was_among_words;
  }

  // a field of the header
  void read_field(Json& value) {
    in_header_ = true;
    for_each_node(value, [&](const Json& node) {
      if (node["t"] == "MetaInlines") slips_.look_at(paragraph(node["c"]), in_header_);
    });
    read(value);
    in_header_ = false;
  }

  // After all has been read: pictures have places, by the names that the deck gives them or else
  // by those of their files, where these are free.
  void place_pictures() {
    const std::set<std::string> of_words = places_;
    for (DeckPicture& picture : deck_.pictures) {
      if (picture.place.empty()) continue;
      if (of_words.contains(picture.place)) {
        tell(picture.line,
             input_error("'#{}' is a heading or other words; give the picture another name",
                         picture.place));
      }
      picture.place = free_name(places_, picture.place);
    }
    for (DeckPicture& picture : deck_.pictures)
      if (picture.place.empty()) picture.place = free_name(places_, picture.name);
  }

  // and then: links within the deck lead somewhere
  void check_links_within() {
    const std::vector<std::string> known(places_.begin(), places_.end());
    for (const auto& [place, line] : links_) {
      if (!places_.contains(place))
        tell(line, input_error("no place is called '#{}'{}", place, suggestion(place, known)));
    }
  }

 private:
  void tell(int line, const Error& error) {
    deck_.problems.push_back(error.at({deck_.file, line, {}}));
  }

  // Titles in boxes begin no slides, where pandoc would end the box; in notes they are words.
  void settle_title(Json& header) const {
    constexpr int kWithoutSlide = 3;
    Json& level = header["c"][0];
    if (in_notes_) {
      header = title_as_words(header);
    } else if (level < kWithoutSlide) {
      level = kWithoutSlide;
    }
  }

  static bool names_scene(const Json& image) {
    const Json& classes = image["c"][0][1];
    const std::string target = image["c"][2][0];
    return target.ends_with(".toml") ||
           std::any_of(classes.begin(), classes.end(), [](const Json& one) {
             return find_class(one.get<std::string>()) != nullptr;
           });
  }

  // a line of the deck with this target
  int line_of(const std::string& target) {
    const std::string words = percent_decoded(target);
    const int line = lines_.next("(" + words);
    return line > 0 ? line : lines_.next(words);
  }

  // ![…](picture.png "title"): browsers show titles when somebody points there, if at all
  void tell_title(const Json& image, int line) {
    const std::string title = image["c"][2][1];
    if (title.empty()) return;
    deck_.remarks.push_back(
        input_error("a picture has no title, and no document shows '{}'; write it into the caption",
                    title)
            .at({deck_.file, line, {}}));
  }

  // a picture of a scene leaves its number
  void take_out(Json& block) {
    const Json& image = block["c"][0];
    const std::string target = image["c"][2][0];
    DeckPicture picture;
    picture.line = line_of(target);
    tell_title(image, picture.line);
    picture.caption = image["c"][1];
    picture.scenes = {percent_decoded(target)};
    try {
      settle(picture, image["c"][0]);
      read(picture.caption);
      block = {{"t", kPictureNode}, {"c", deck_.pictures.size()}};
      deck_.pictures.push_back(std::move(picture));
    } catch (const Error& error) {
      tell(picture.line, error);
      block = paragraph(string_inlines(fmt::format("[{} could not be made]", picture.scenes[0])));
    }
  }

  void settle(DeckPicture& picture, const Json& attributes) {
    const PictureClass* row = nullptr;
    for (const Json& one : attributes[1]) {
      const std::string name = one;
      const PictureClass* found = find_class(name);
      if (found == nullptr) {
        throw input_error(
            "unknown kind of picture '.{}'{}", name, suggestion(name, names_of(picture_classes())));
      }
      if (row != nullptr && row != found)
        throw input_error("a picture is either a .{} or a .{}", row->name, found->name);
      row = found;
    }
    if (row == nullptr) {
      throw input_error(
          "say what to make of '{}': .film, .loop, .turn, .still, .compare, .chart, "
          ".stability or .inspect, as in ![…]({}){{.film}}",
          picture.scenes[0],
          picture.scenes[0]);
    }
    picture.kind = row->kind;
    for (const Json& pair : attributes[2]) {
      const std::string key = pair[0], value = pair[1];
      const std::vector<std::string> known = names_of(row->settings);
      if (std::find(known.begin(), known.end(), key) == known.end())
        throw input_error("a .{} has no '{}'{}", row->name, key, suggestion(key, known));
      if (picture.settings.contains(key))
        throw input_error("a .{} has '{}' twice here; leave one out", row->name, key);
      picture.settings[key] = value;
    }
    const std::string asked = attributes[0];
    picture.name = free_name(names_, name_from(asked.empty() ? picture.scenes[0] : asked));
    picture.place = asked;
    if (picture.kind != PictureKind::compare) return;
    std::string with = picture.settings["with"];
    while (!with.empty()) {
      const std::size_t end = std::min(with.find(' '), with.size());
      if (end > 0) picture.scenes.push_back(with.substr(0, end));
      with.erase(0, end + 1);
    }
    if (picture.scenes.size() < 2)
      throw input_error("a .compare needs a second scene: with=other.toml");
    if (picture.scenes.size() > 4) throw input_error("a .compare takes at most four scenes");
  }

  // the name, or one with a number behind it that is not taken; it is taken then
  static std::string free_name(std::set<std::string>& taken, const std::string& name) {
    std::string free = name;
    for (int i = 2; !taken.insert(free).second; ++i)
      free = fmt::format("{}-{}", name, i);
    return free;
  }

  // a picture of the deck's own, from a file
  void read_image(Json& image) {
    const std::string target = image["c"][2][0];
    const int line = line_of(target);
    try {
      if (in_header_) throw input_error("a field of the header has no picture");
      if (names_scene(image)) {
        throw input_error(
            "a picture of a scene needs a paragraph of its own, with nothing behind "
            "its settings, as in ![…]({}){{.film}}",
            target);
      }
      const std::string file = percent_decoded(target);
      const std::string ending = picture_ending(file);
      if (!is_picture_ending(ending))
        throw input_error("'{}' is neither a picture (.png, .jpg, .svg, .webp) nor a scene", file);
      require_picture(trusted_file(deck_.root, deck_.root.folder, file), ending);
      read(image["c"][1]);
      clean_image(image["c"][0], line);
      tell_title(image, line);
      take_place(image["c"][0]);
      image["c"][2] = Json::array({file, ""});
      deck_.images.push_back(file);
    } catch (const Error& error) {
      tell(line, error);
      image = string_inlines(fmt::format("[{}]", target))[0];
    }
  }

  // among words nothing shows a caption, and only what stands around a picture has a name
  static void make_words(Json& image) {
    describe(image);
    const std::string place = image["c"][0][0];
    if (place.empty()) return;
    image["c"][0][0] = "";
    image = named("Span", place, Json::array({image}));
  }

  void read_link(Json& link) {
    const std::string target = link["c"][2][0], title = link["c"][2][1];
    try {
      check_link(target);
      for (const auto& [what, text] :
           {std::pair{"address", percent_decoded(target)}, {"title", title}}) {
        if (text.find("{inspect:") != std::string::npos)
          throw input_error("the {} of a link quotes no numbers; write them there", what);
      }
      // scripts of the page find "#film=a&t=2", a time of a film, and "#/3", a slide
      if (target.starts_with("#") && !target.starts_with("#/") &&
          target.find('=') == std::string::npos) {
        const int line = lines_.next("(" + percent_decoded(target));
        links_.emplace_back(percent_decoded(target.substr(1)), line);
      }
    } catch (const Error& error) {
      const int line = lines_.next("(" + percent_decoded(target));
      tell(line > 0 ? line : lines_.next(target), error);
      link["c"][2][0] = "#";
    }
  }

  void read_formula(Json& math) {
    const std::string tex = math["c"][1];
    try {
      check_formula(tex);
    } catch (const Error& error) {
      tell(lines_.next(tex), error);
      math["c"][1] = "?";
    }
  }

  // "N%" of more than nothing and at most the whole
  static bool is_width(const std::string& key, const std::string& value) {
    if (key != "width" || !value.ends_with('%')) return false;
    const std::string number = value.substr(0, value.size() - 1);
    if (number.find_first_not_of("0123456789.") != std::string::npos) return false;
    const std::optional<double> percent = parse_number(number);
    return percent && *percent > 0.0 && *percent <= 100.0;
  }

  // A slip is refused: words for the speaker would be shown to all.
  void tell_unknown_class(const std::string& name, const std::set<std::string>& meant) {
    int line = lines_.next("::: " + name + "\n");
    if (line == 0) line = lines_.next("." + name + "}");
    for (const std::string& one : meant) {
      if (!is_almost(letters_of(name), one)) continue;
      tell(line, input_error("'{}' means nothing to a deck (did you mean '{}'?)", name, one));
      return;
    }
    if (unknown_.insert(name).second) {
      deck_.remarks.push_back(
          input_error("'{}' means nothing to a deck; what is in it is shown as other words", name)
              .at({deck_.file, line, {}}));
    }
  }

  // widths of columns are all that a deck may set on what is no picture; classes that mean nothing
  // to a document could be those of its own parts, which styles hide or move
  void clean(Json& attributes, const std::string& type) {
    static const std::map<std::string, std::set<std::string>> known = {
        {"Div", {"notes", "columns", "column", "incremental", "nonincremental", "fragment"}},
        {"Span", {"mark", "fragment"}},
        {"Header", {"unnumbered", "unlisted"}}};
    if (type != "Code" && type != "CodeBlock") {
      const auto its = known.find(type);
      const std::set<std::string> none;
      const std::set<std::string>& meant = its == known.end() ? none : its->second;
      std::erase_if(attributes[1].get_ref<Json::array_t&>(), [&](const Json& name) {
        if (meant.contains(name.get<std::string>())) return false;
        if (type == "Div") tell_unknown_class(name, meant);
        return true;
      });
      if (type == "Div" && attributes[0] == "notes") tell_unknown_class("#notes", {"notes"});
      // for what is beside it pandoc would show these words
      if (std::find(attributes[1].begin(), attributes[1].end(), "notes") != attributes[1].end())
        attributes[1] = Json::array({"notes"});
    }
    Json kept = Json::array();
    for (const Json& pair : attributes[2]) {
      const std::string key = pair[0];
      if (is_width(key, pair[1])) {
        kept.push_back(pair);
      } else {
        tell(lines_.next(key + "="),
             input_error("'{}' cannot be set here; only width=N% of columns can", key));
      }
    }
    attributes[2] = kept;
  }

  // and a description of what is a picture
  void clean_image(Json& attributes, int line) {
    for (const Json& name : attributes[1]) {
      tell(line,
           input_error("a picture of the deck's own has no class '.{}'", name.get<std::string>()));
    }
    Json kept = Json::array();
    for (const Json& pair : attributes[2]) {
      const std::string key = pair[0];
      if (key == "alt" || is_width(key, pair[1])) {
        kept.push_back(pair);
      } else {
        tell(line,
             input_error("a picture of the deck's own may have alt=\"…\" and width=N%, not "
                         "'{}={}'",
                         key,
                         pair[1].get<std::string>()));
      }
    }
    attributes[1] = Json::array();
    attributes[2] = kept;
  }

  // what links can lead to; only one may have the name
  void take_place(const Json& attributes) {
    const std::string place = attributes[0];
    const int line = lines_.next("{#" + place);
    if (place.empty() || places_.insert(place).second) return;
    tell(line, input_error("a second '#{}'; links lead to the first", place));
  }

  Deck& deck_;
  LineFinder lines_;
  SlipFinder slips_;
  std::set<std::string> names_;                     // of the files of pictures
  std::set<std::string> places_;                    // identifiers
  std::vector<std::pair<std::string, int>> links_;  // place, line
  bool in_header_ = false;                          // of the deck
  bool among_words_ = false;                        // where pictures have no captions
  std::set<std::string> unknown_;                   // classes of boxes
  bool in_box_ = false, in_notes_ = false;          // what is read now
};

// the line of the first character, or reference to one, that no document can show; 0 if unknown
int line_of_unwritable(const std::string& text) {
  std::size_t at = find_unwritable(text);
  for (std::size_t i = text.find("&#"); i < at; i = text.find("&#", i + 2)) {
    const bool is_hex = text.find_first_of("xX", i + 2) == i + 2;
    const char* digits = text.c_str() + i + (is_hex ? 3 : 2);
    if (is_unwritable(std::strtoul(digits, nullptr, is_hex ? 16 : 10))) at = i;
  }
  return at == std::string::npos ? 0 : line_of(text, at);
}

// Documents of XML, such as slides, would not open.
void refuse_unwritable(const Json& tree, const std::string& text, const std::string& name) {
  if (tree.is_string()) {
    const std::string& words = tree.get_ref<const std::string&>();
    const std::size_t i = find_unwritable(words);
    if (i == std::string::npos) return;
    throw input_error("holds {}, which no document can show; leave it out", code_point(words, i))
        .at({name, line_of_unwritable(text), {}});
  }
  if (!tree.is_structured()) return;
  for (const Json& child : tree)
    refuse_unwritable(child, text, name);
}

// They end lines on no system of today, and pandoc does not know them.
void refuse_lone_returns(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find('\r'); at != std::string::npos; at = text.find('\r', at + 1)) {
    if (at + 1 == text.size() || text[at + 1] == '\n') continue;
    throw input_error("a carriage return ends no line; save the deck with other ends of lines")
        .at({name, line_of(text, at), {}});
  }
}

// remarks on words that pandoc has not read: one for each of the first lines, one for the rest
std::vector<Error> what_was_dropped(const std::string& text,
                                    const Json& tree,
                                    const std::string& name) {
  const std::vector<DroppedWord> all = dropped_words(text, tree, kCountedWords);
  const std::size_t shown = std::min(all.size(), kNamedWords);
  std::map<int, std::string> dropped;  // by lines
  for (std::size_t i = 0; i < shown; ++i) {
    std::string& words = dropped[all[i].line];
    words += (words.empty() ? "" : ", ") + all[i].word;
  }
  std::vector<Error> remarks;
  remarks.reserve(dropped.size() + 1);
  for (const auto& [line, words] : dropped) {
    remarks.push_back(
        input_error("pandoc leaves out what is in no column and what nothing refers to: {}", words)
            .at({name, line, {}}));
  }
  if (shown < all.size()) {
    remarks.push_back(
        input_error("and from here on pandoc leaves out {} more words", how_many_more(all.size()))
            .at({name, all[shown].line, {}}));
  }
  return remarks;
}

}  // namespace

Json Deck::tree(const Json& with_blocks) const {
  return {{"pandoc-api-version", api_version}, {"meta", meta}, {"blocks", with_blocks}};
}

Deck parse_deck(const std::string& text, const std::string& name, const DeckRoot& root) {
  refuse_other_encodings(text, name, "deck");
  refuse_lone_returns(text, name);
  Json tree = read_markdown(text);
  const std::vector<Error> dropped = what_was_dropped(text, tree, name);
  Deck deck = deck_of_tree(std::move(tree), text, name, root);
  deck.remarks.insert(deck.remarks.end(), dropped.begin(), dropped.end());
  return deck;
}

Deck deck_of_tree(Json tree,
                  const std::string& text,
                  const std::string& name,
                  const DeckRoot& root) {
  refuse_unwritable(tree["meta"], text, name);
  refuse_unwritable(tree["blocks"], text, name);
  Deck deck;
  deck.file = name;
  deck.root = root;
  deck.api_version = tree["pandoc-api-version"];
  deck.meta = read_fields(tree["meta"], text, name, deck.problems);
  Reader reader(deck, text, tree["blocks"]);
  for (auto& [key, value] : deck.meta.items()) {
    static_cast<void>(key);
    reader.read_field(value);
  }
  reader.read(tree["blocks"]);
  reader.place_pictures();
  reader.check_links_within();
  deck.blocks = std::move(tree["blocks"]);
  return deck;
}

Deck read_deck(const std::filesystem::path& file, bool allow_outside) {
  const std::string text = read_input(file, kLargestDeck);
  try {
    return parse_deck(text, file.string(), {file.parent_path(), allow_outside});
  } catch (const Error& error) {
    if (error.fault() != Fault::input) throw;
    throw error.at({file.string(), 0, {}});
  }
}

Json with_pictures(const Json& blocks,
                   const std::function<Json(const DeckPicture&)>& make,
                   const Deck& deck) {
  if (blocks.is_object()) {
    Json copy = blocks;
    if (copy.contains("c")) copy["c"] = with_pictures(copy["c"], make, deck);
    return copy;
  }
  if (!blocks.is_array()) return blocks;
  Json copy = Json::array();
  for (const Json& child : blocks) {
    if (child.is_object() && child.contains("t") && child["t"] == kPictureNode) {
      for (Json& block : make(deck.pictures[child["c"].get<std::size_t>()]))
        copy.push_back(std::move(block));
    } else {
      copy.push_back(with_pictures(child, make, deck));
    }
  }
  return copy;
}

}  // namespace polhode
