// SPDX-License-Identifier: MIT
#include "lecture/documents/figures.h"

#include <algorithm>

#include "base/base64.h"
#include "html/escape.h"
#include "lecture/deck/quotes.h"
#include "lecture/documents/qr_code.h"

namespace polhode {
namespace {

std::string media(const Json& facts, const char* key) {
  return "media/" + percent_encoded(facts.at(key).get<std::string>());
}

// what is to be seen, for those who cannot see it
std::string alt_of(const DeckPicture& picture) {
  const auto given = picture.settings.find("alt");
  if (given != picture.settings.end()) return given->second;
  const std::string words = plain_text(picture.caption);
  return words.empty() ? picture.name : words;
}

Json failed_blocks(const Figure& figure) {
  const std::string words =
      fmt::format("[{} could not be made: {}]", figure.picture->scenes[0], figure.failure);
  return Json::array({paragraph(Json::array({{{"t", "Strong"}, {"c", string_inlines(words)}}}))});
}

// html, the caption, html
Json framed(const std::string& before, const DeckPicture& picture) {
  Json blocks = Json::array({raw_html(before)});
  if (!picture.caption.empty()) {
    blocks.push_back(raw_html("<figcaption>"));
    blocks.push_back({{"t", "Plain"}, {"c", picture.caption}});
    blocks.push_back(raw_html("</figcaption>"));
  }
  blocks.push_back(raw_html("</figure>"));
  return blocks;
}

std::string pauses_of(const Json& facts) {
  std::string text;
  for (const Json& pause : facts.at("pauses")) {
    text += fmt::format(
        "{}{:.6f} {:.6f}", text.empty() ? "" : ",", pause[0].get<double>(), pause[1].get<double>());
  }
  return text;
}

std::string video_element(const Json& facts, const DeckPicture& picture, bool slides) {
  const bool repeats = picture.kind == PictureKind::loop;
  std::string text = fmt::format(
      "<video data-film=\"{}\" data-fps=\"{:.6f}\" data-frames=\"{}\" data-pauses=\"{}\" "
      "width=\"{}\" "
      "height=\"{}\" poster=\"{}\" preload=\"{}\" playsinline muted {}{}aria-label=\"{}\">",
      escaped(picture.place),
      facts.at("fps").get<double>(),
      facts.at("frames").get<int>(),
      pauses_of(facts),
      facts.at("width").get<int>(),
      facts.at("height").get<int>(),
      media(facts, "poster"),
      slides ? "metadata" : "none",
      slides ? "" : "controls ",
      repeats ? "loop " : "",
      escaped(alt_of(picture)));
  text += fmt::format("<source src=\"{}\" type=\"video/mp4\">", media(facts, "film"));
  const std::string words = facts.at("vtt");
  if (!words.empty()) {
    text += fmt::format(
        "<track kind=\"captions\" label=\"Captions\" "
        "src=\"data:text/vtt;base64,{}\">",
        base64(words));
  }
  return text + fmt::format("<a href=\"{}\">The film</a></video>", media(facts, "film"));
}

// `look`: where it is shown, "on-dark" or "on-light"; empty: everywhere
std::string img_element(const std::string& file,
                        const std::string& alt,
                        const std::string& look = "") {
  return fmt::format("<img{} src=\"{}\" alt=\"{}\">",
                     look.empty() ? "" : fmt::format(" class=\"{}\"", look),
                     file,
                     escaped(alt));
}

// where links to a picture lead
std::string id_of(const DeckPicture& picture) {
  return fmt::format(" id=\"{}\"", escaped(picture.place));
}

std::string film(const Figure& figure, bool slides) {
  const DeckPicture& picture = *figure.picture;
  std::string turn;
  if (picture.kind == PictureKind::turn) {
    const auto clock = picture.settings.find("clock");
    turn = fmt::format(" data-turn=\"{}\" data-clock=\"{}\"",
                       escaped(picture.place),
                       clock == picture.settings.end() ? "" : escaped(clock->second));
  }
  return fmt::format("<figure class=\"film\"{}{}><div class=\"screen\">{}</div>",
                     id_of(picture),
                     turn,
                     video_element(figure.facts, picture, slides));
}

bool is_plot(const DeckPicture& picture) {
  return picture.kind == PictureKind::chart || picture.kind == PictureKind::stability;
}

Json plot_blocks(const Figure& figure, const char* what) {
  const DeckPicture& picture = *figure.picture;
  const Json& facts = figure.facts;
  std::string text = fmt::format("<figure class=\"plot\"{}>", id_of(picture));
  text += fmt::format("<a href=\"{}\">{}</a>",
                      media(facts, what),
                      img_element(media(facts, what), alt_of(picture)));
  return framed(text, picture);
}

// a paragraph with a picture and, where there is one, its caption below
Json picture_blocks(const DeckPicture& picture,
                    const std::string& file,
                    const std::string& link,
                    const std::string& title) {
  const Json no_attributes = Json::array({"", Json::array(), Json::array()});
  Json described = Json::array();  // beside a caption, or without one
  if (!title.empty() && (picture.caption.empty() || picture.settings.contains("alt")))
    described.push_back(Json::array({"alt", title}));
  Json image = {
      {"t", "Image"},
      {"c",
       {Json::array({picture.place, Json::array(), described}), picture.caption, {file, title}}}};
  if (link.empty()) return Json::array({paragraph(Json::array({image}))});
  const Json linked = {{"t", "Link"}, {"c", {no_attributes, Json::array({image}), {link, ""}}}};
  return Json::array({paragraph(Json::array({linked}))});
}

// The slides of LaTeX are white; those with links to the films show how these begin.
std::string shown_in(const Json& facts, bool links) {
  return media(facts, links ? "poster" : "paper");
}

// a still, as these elements show it
Json still_blocks(const DeckPicture& picture, const std::string& elements) {
  return framed(fmt::format("<figure class=\"still\"{}>{}", id_of(picture), elements), picture);
}

// blocks to which links to the picture lead
Json with_place(const DeckPicture& picture, const Json& blocks) {
  return Json::array({named("Div", picture.place, blocks)});
}

Json document_blocks(const Figure& figure, bool links) {
  const DeckPicture& picture = *figure.picture;
  if (figure.facts.empty()) return failed_blocks(figure);
  if (picture.kind == PictureKind::inspect) {
    Json table = figure.facts.at("table");
    if (!picture.caption.empty())
      table[0]["c"][1][1] = Json::array({{{"t", "Plain"}, {"c", picture.caption}}});
    // in PowerPoint a table stands by itself
    return links ? table : with_place(picture, table);
  }
  // pandoc describes pictures by their titles in PowerPoint
  const std::string title = links ? alt_of(picture) : "";
  if (is_plot(picture)) return picture_blocks(picture, media(figure.facts, "png"), "", title);
  const Json& facts = figure.facts;
  std::string link = links && facts.contains("film") ? media(facts, "film") : "";
  if (links && picture.kind == PictureKind::turn) link = viewer_link(picture);
  return picture_blocks(picture, shown_in(facts, links), link, title);
}

Json cell(const Json& inlines) {
  const Json plain = Json::array({{{"t", "Plain"}, {"c", inlines}}});
  return Json::array(
      {Json::array({"", Json::array(), Json::array()}), {{"t", "AlignDefault"}}, 1, 1, plain});
}

Json table_row(const std::vector<std::string>& words) {
  Json cells = Json::array();
  for (const std::string& one : words)
    cells.push_back(cell(string_inlines(one)));
  return Json::array({Json::array({"", Json::array(), Json::array()}), cells});
}

}  // namespace

std::string viewer_link(const DeckPicture& picture) {
  return "index.html#turn=" + percent_encoded(picture.place);
}

Json number_table(const Json& inspection, const std::string& scene, const std::string& keys) {
  std::vector<std::string> asked;
  for (std::size_t from = 0; from < keys.size();) {
    const std::size_t end = std::min(keys.find(' ', from), keys.size());
    if (end > from) asked.push_back(keys.substr(from, end - from));
    from = end + 1;
  }
  if (asked.empty()) {
    asked = {"kind", "mass_kg", "principal_moments_kg_m2"};
    for (const auto& [key, value] : inspection.at("derived").items()) {
      static_cast<void>(value);
      asked.push_back(key);
    }
  }
  Json rows = Json::array();
  for (const std::string& key : asked) {
    std::string name = split_unit(key).first;
    std::replace(name.begin(), name.end(), '_', ' ');
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    rows.push_back(table_row({name, quoted(inspection, {scene, key, "", ""}).text}));
  }
  const Json none = Json::array({"", Json::array(), Json::array()});
  const Json column = Json::array({{{"t", "AlignLeft"}}, {{"t", "ColWidthDefault"}}});
  const Json caption = Json::array({nullptr, Json::array()});
  const Json head = Json::array({none, Json::array({table_row({"Quantity", "Value"})})});
  const Json body = Json::array({Json::array({none, 0, Json::array(), rows})});
  const Json foot = Json::array({none, Json::array()});
  return {{"t", "Table"}, {"c", {none, caption, Json::array({column, column}), head, body, foot}}};
}

Json page_blocks(const Figure& figure) {
  const DeckPicture& picture = *figure.picture;
  if (figure.facts.empty()) return failed_blocks(figure);
  if (is_plot(picture)) return plot_blocks(figure, "svg");
  if (picture.kind == PictureKind::still) {
    // a page has the look that its reader likes
    const Json& facts = figure.facts;
    if (facts.at("paper") == facts.at("poster"))
      return still_blocks(picture, img_element(media(facts, "poster"), alt_of(picture)));
    return still_blocks(picture,
                        img_element(media(facts, "poster"), alt_of(picture), "on-dark") +
                            img_element(media(facts, "paper"), alt_of(picture), "on-light"));
  }
  if (picture.kind == PictureKind::inspect) {
    Json blocks = Json::array({raw_html(
        fmt::format("<figure class=\"numbers\"{}><div class=\"scroll\">", id_of(picture)))});
    for (const Json& block : figure.facts.at("table"))
      blocks.push_back(block);
    for (Json& block : framed("</div>", picture))
      blocks.push_back(std::move(block));
    return blocks;
  }
  return framed(film(figure, false), picture);
}

Json slide_blocks(const Figure& figure) {
  const PictureKind kind = figure.picture->kind;
  const bool films_here = kind == PictureKind::film || kind == PictureKind::loop ||
                          kind == PictureKind::compare || kind == PictureKind::turn;
  if (kind == PictureKind::still && !figure.facts.empty()) {
    return still_blocks(*figure.picture,
                        img_element(media(figure.facts, "poster"), alt_of(*figure.picture)));
  }
  if (figure.facts.empty() || !films_here) return page_blocks(figure);
  return framed(film(figure, true), *figure.picture);
}

Json handout_blocks(const Figure& figure) {
  const DeckPicture& picture = *figure.picture;
  if (figure.facts.empty()) return failed_blocks(figure);
  if (picture.kind == PictureKind::inspect) return page_blocks(figure);
  if (picture.kind == PictureKind::still)
    return still_blocks(picture, img_element(media(figure.facts, "paper"), alt_of(picture)));
  if (is_plot(picture)) return plot_blocks(figure, "svg");
  Json stills = figure.facts.at("stills");
  if (stills.empty()) {
    stills = Json::array({{{"file", figure.facts.at("paper")},
                           {"at", figure.facts.at("poster_at")},
                           {"caption", ""}}});
  }
  std::string text;
  for (const Json& still : stills) {
    const std::string caption = still.at("caption");
    text += fmt::format("<div class=\"screen\">{}<p class=\"name\">t = {:.4g} s{}{}</p></div>",
                        img_element("media/" + percent_encoded(still.at("file").get<std::string>()),
                                    alt_of(picture)),
                        still.at("at").get<double>(),
                        caption.empty() ? "" : ": ",
                        escaped(caption));
  }
  std::string code;
  if (!figure.address.empty()) {
    code = fmt::format("<div class=\"code\">{}<p>Turn it: {}</p></div>",
                       qr_code_svg(figure.address),
                       escaped(figure.address));
  }
  return framed(fmt::format("<figure class=\"stills\"{}><div class=\"screens n{}\">{}</div>{}",
                            id_of(picture),
                            std::min(stills.size(), std::size_t{4}),
                            text,
                            code),
                picture);
}

Json office_blocks(const Figure& figure) {
  return document_blocks(figure, true);
}

Json beamer_blocks(const Figure& figure) {
  return document_blocks(figure, false);
}

}  // namespace polhode
