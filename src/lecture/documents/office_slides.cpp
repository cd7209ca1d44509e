// SPDX-License-Identifier: MIT
#include "lecture/documents/office_slides.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

namespace polhode {
namespace {

// Takes pictures, tables and notes out of what stands around them, where pandoc would drop them.
Json take_figures(Json& tree) {
  if (tree.is_object()) return tree.contains("c") ? take_figures(tree["c"]) : Json::array();
  Json taken = Json::array();
  if (!tree.is_array()) return taken;
  Json left = Json::array();
  for (Json& child : tree) {
    const std::string type = child.is_object() ? child.value("t", "") : "";
    if (type == "Div" && is_div(child, "notes")) {
      taken.push_back(std::move(child));
      continue;
    }
    Json inside = take_figures(child);
    if (type == "Image") {
      taken.push_back(paragraph(Json::array({child})));
    } else if (type == "Table" || type == kPictureNode) {
      taken.push_back(std::move(child));
    } else {
      left.push_back(std::move(child));
    }
    for (Json& one : inside)
      taken.push_back(std::move(one));
  }
  tree = std::move(left);
  return taken;
}

// whether there is anything to read
bool has_words(const Json& tree) {
  return has_node(tree, [](const Json& node) {
    const std::string type = node["t"];
    return type == "Str" || type == "Math" || type == "Code" || type == "CodeBlock";
  });
}

constexpr int kTitles = 2;  // deeper ones are words on a slide

bool has_columns(const Json& tree) {
  return has_node(tree, [](const Json& node) { return is_div(node, "columns"); });
}

// whether a rule or a title among the blocks would begin another slide
bool begins_slides(const Json& blocks) {
  return std::any_of(blocks.begin(), blocks.end(), [](const Json& block) {
    return block["t"] == "HorizontalRule" || (block["t"] == "Header" && block["c"][0] <= kTitles);
  });
}

bool is_figure(const Json& block) {
  return block["t"] == kPictureNode || block["t"] == "Table" || is_image_alone(block);
}

// a column of words alone, or of one picture or table alone
bool is_simple(const Json& column) {
  if (!is_div(column, "column")) return false;
  Json blocks = column["c"][1];
  if (blocks.size() == 1 && is_figure(blocks[0]))
    return blocks[0]["t"] != "Table" || take_figures(blocks[0]).empty();
  const Json figures = take_figures(blocks);
  return !has_columns(blocks) && !begins_slides(blocks) &&
         std::all_of(
             figures.begin(), figures.end(), [](const Json& one) { return is_div(one, "notes"); });
}

Json rule() {
  return {{"t", "HorizontalRule"}};
}

class Layout {
 public:
  explicit Layout(const Deck& deck) : deck_(deck) {}

  void add(const Json& block) {
    const std::string type = block["t"];
    const bool is_header = type == "Header";
    if (type == "HorizontalRule" || (is_header && block["c"][0] <= kTitles)) {
      begin_slide(block);
    } else if (is_div(block, "notes")) {
      notes_.push_back(block);
    } else if (is_div(block, "columns")) {
      add_columns(block);
    } else if (is_figure(block)) {
      add_figure(block);
    } else {
      // what stood above it is not what it is about
      if (is_header && !figure_.is_null()) next_slide();
      Json words = block;
      const Json figures = take_figures(words);
      if (figures.empty() || has_words(words)) {
        add_words(words);
      } else {
        around_.push_back(words);
      }
      for (const Json& figure : figures)
        add(figure);
    }
  }

  OfficeSlides finished() {
    lead_here(Json::array());
    end_slide();
    return std::move(slides_);
  }

 private:
  void begin_slide(const Json& title) {
    lead_here(Json::array());
    end_slide();
    title_ = title;
    const Json figures = title["t"] == "Header" ? take_figures(title_["c"][2]) : Json::array();
    // pandoc ends at links to an empty one
    if (!has_words(title_)) title_ = rule();
    emit_title();
    // the title of a part has its slide alone
    is_full_ = title_["t"] == "Header" && title_["c"][0] < kTitles;
    for (const Json& figure : figures)
      add(figure);
  }

  void add_words(const Json& words) {
    if (is_full_) next_slide();
    // boxes do not stand in columns
    if (words["t"] == "Div" && !figure_.is_null()) next_slide();
    boxed_ = boxed_ || words["t"] == "Div";
    words_.push_back(words);
    lead_here(words_.back());
  }

  void add_figure(const Json& figure) {
    if (is_full_ || !figure_.is_null() || boxed_) next_slide();
    figure_ = figure;
    lead_here(figure_);
    if (figure["t"] != "Table") return;
    for (const Json& one : take_figures(figure_["c"]))
      add(one);
  }

  // links to what is in it, and to what stood around it, lead to this slide
  void lead_here(const Json& tree) {
    name_places_of(tree);
    name_places_of(std::exchange(around_, Json::array()));
  }

  // a box, but not what is in it
  void leave_out(const Json& box) {
    around_.push_back(named("Div", box["c"][0][0], Json::array()));
  }

  void name_places_of(const Json& tree) {
    if (title_id_.empty()) return;
    for_each_node(tree, [&](const Json& node) {
      const Json* attributes = attributes_of(node);
      const std::string place = node["t"] == kPictureNode
                                    ? deck_.pictures[node["c"].get<std::size_t>()].place
                                : attributes != nullptr ? (*attributes)[0].get<std::string>()
                                                        : "";
      if (!place.empty()) slides_.titles[place] = title_id_;
    });
  }

  // Two on a slide, without anything else. Where one has more than words or one figure, or stands
  // by itself, what is in them follows one another.
  void add_columns(const Json& columns) {
    const Json& all = columns["c"][1];
    const bool are_simple = std::all_of(all.begin(), all.end(), is_simple);
    const std::size_t in_pairs = are_simple ? all.size() / 2 * 2 : 0;
    for (std::size_t i = 0; i < in_pairs; i += 2) {
      if (is_full_ || !figure_.is_null() || !words_.empty()) next_slide();
      Json pair = columns;
      pair["c"][1] = Json::array({all[i], all[i + 1]});
      lead_here(pair);
      words_.push_back(pair);
      is_full_ = true;
    }
    if (in_pairs == 0) leave_out(columns);
    for (std::size_t i = in_pairs; i < all.size(); ++i)
      add_blocks_of(all[i]);
  }

  void add_blocks_of(const Json& column) {
    const bool is_column = is_div(column, "column");
    if (is_column) leave_out(column);
    for (const Json& block : is_column ? column["c"][1] : Json::array({column}))
      add(block);
  }

  void emit_title() {
    slides_.blocks.push_back(title_);
    title_id_ = title_["t"] == "Header" ? title_["c"][1][0].get<std::string>() : "";
  }

  void end_slide() {
    if (!figure_.is_null() && !words_.empty()) {
      slides_.blocks.push_back(div("columns",
                                   Json::array({div("column", words_, "40%"),
                                                div("column", Json::array({figure_}), "60%")})));
    } else {
      for (const Json& block : words_)
        slides_.blocks.push_back(block);
      if (!figure_.is_null()) slides_.blocks.push_back(figure_);
    }
    for (const Json& block : notes_)
      slides_.blocks.push_back(block);
    words_ = notes_ = Json::array();
    figure_ = nullptr;
    is_full_ = boxed_ = false;
  }

  // with the same title, which does not begin a part of the deck again
  void next_slide() {
    end_slide();
    if (title_["t"] == "Header") {
      title_["c"][0] = kTitles;
      title_["c"][1][0] = fmt::format("slide-again-{}", ++again_);
      std::erase_if(title_["c"][2].get_ref<Json::array_t&>(),
                    [](const Json& inline_) { return inline_["t"] == "Note"; });
      emit_title();
    } else {
      slides_.blocks.push_back(rule());
      title_id_.clear();
    }
  }

  const Deck& deck_;
  OfficeSlides slides_;
  Json title_ = rule();   // of the slide: a header or a rule
  std::string title_id_;  // what links to it call it; empty: nothing
  int again_ = 0;         // titles that were repeated

  // what the slide has so far
  Json words_ = Json::array(), notes_ = Json::array();
  Json figure_ = nullptr;  // a picture or a table
  // What stands around the next of these and is left out.
  Json around_ = Json::array();
  bool boxed_ = false;    // are there words in a box
  bool is_full_ = false;  // of columns, or the title of a part
};

}  // namespace

OfficeSlides office_slides(const Deck& deck) {
  Layout layout(deck);
  for (const Json& block : deck.blocks)
    layout.add(block);
  return layout.finished();
}

}  // namespace polhode
