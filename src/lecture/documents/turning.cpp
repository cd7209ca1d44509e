// SPDX-License-Identifier: MIT
#include "lecture/documents/turning.h"

#include <algorithm>

#include "base/base64.h"
#include "base/system/atomic_file.h"
#include "html/escape.h"
#include "lecture/documents/script_folder.h"
#include "lecture/documents/sliders.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

// What is between the tags of a script: nothing in it may end it.
std::string for_script(const Json& data) {
  std::string text = data.dump(-1, ' ', true, Json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace

std::optional<Three> find_three() {
  const std::optional<fs::path> place =
      find_script_folder("POLHODE_THREE", "three", {"build/three.cjs"});
  if (!place) return {};
  return Three{version_of_scripts(*place),
               safe_in_script(read_file(*place / "build/three.cjs")),
               licence_of_scripts(*place)};
}

bool has_viewers(const Deck& deck) {
  return std::any_of(deck.pictures.begin(), deck.pictures.end(), [](const DeckPicture& picture) {
    return picture.kind == PictureKind::turn;
  });
}

std::string viewer_blocks(const Deck& deck,
                          const FigureOf& figure_of,
                          const fs::path& folder,
                          const Three& three,
                          const std::optional<std::string>& core) {
  std::string blocks;
  for (const DeckPicture& picture : deck.pictures) {
    if (picture.kind != PictureKind::turn) continue;
    const Figure figure = figure_of(picture);
    if (figure.facts.empty()) continue;
    Json data = parse_foreign_json(
        read_file(folder / "media" / figure.facts.at("viewer").get<std::string>()));
    data["glb"] = base64(read_file(folder / "media" / figure.facts.at("glb").get<std::string>()));
    blocks += fmt::format("<script type=\"application/json\" data-viewer=\"{}\">{}</script>\n",
                          escaped(picture.place),
                          for_script(data));
  }
  if (blocks.empty()) return "";
  if (core && has_sliders(deck)) {
    blocks += "<script type=\"text/plain\" data-core>" + base64(*core) + "</script>\n";
  }
  return blocks + "<script type=\"text/plain\" data-three>" + three.js + "</script>\n";
}

}  // namespace polhode
