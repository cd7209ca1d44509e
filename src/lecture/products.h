// SPDX-License-Identifier: MIT
// What must be rendered and computed for a deck, as products with their keys.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "film/overrides.h"
#include "lecture/deck.h"
#include "lecture/media.h"

namespace polhode {

// What holds for all films of a deck.
struct LectureSettings {
  std::optional<std::string> size;  // of every picture; a picture's own setting goes first
  std::optional<std::string> fps;
  std::string quality = "lecture";
  std::string backend = "auto";
};

// A scene of the deck, read and trusted.
struct DeckScene {
  std::string name;  // as the deck names it
  std::filesystem::path file;
  Scene scene;
  std::string hash;
};

// A film (also a loop, and one of several that are compared). Facts: "film", "poster", "poster_at",
// "stills" (a list of "file", "at", "caption"), "vtt" (the text, if any), "pauses" (a list of
// [begins, ends], s of film), "frames", "fps", "width", "height", "duration", "title".
Product film_product(const DeckPicture& picture,
                     const DeckScene& scene,
                     const LectureSettings& settings);
// One picture. Facts: "poster", "poster_at", "width", "height".
Product still_product(const DeckPicture& picture,
                      const DeckScene& scene,
                      const LectureSettings& settings);
// Facts: "svg", "png", "csv", "summary".
Product chart_product(const DeckPicture& picture, const DeckScene& scene);
Product stability_product(const DeckPicture& picture, const DeckScene& scene);
// Facts: "inspection".
Product inspect_product(const DeckScene& scene);
// The motion as a table. Facts: "csv".
Product motion_product(const DeckScene& scene);

}  // namespace polhode
