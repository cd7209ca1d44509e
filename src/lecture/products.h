// SPDX-License-Identifier: MIT
// Describes what must be rendered and computed for a deck, as products for the media cache.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "film/overrides.h"
#include "lecture/deck.h"
#include "lecture/media.h"

namespace polhode {

// Settings for all films of a deck.
struct LectureSettings {
  std::optional<std::string> size;  // "1280x720", of every picture that has no setting of its own
  std::optional<std::string> fps;   // "60" or "30000/1001"
  std::string quality = "lecture";
  std::string backend = "auto";
};

// A scene of the deck, checked by trusted_scene() and loaded.
struct DeckScene {
  std::string name;  // as the deck names it
  std::filesystem::path file;
  Scene scene;
  std::string hash;  // scene_hash()
};

// All these throw Error (input), without a place, for a setting that is not valid. Files are names
// in media/.

// A film: also a loop, and each film of a comparison. Facts: "film", "poster", "poster_at" (s),
// "stills" (a list of "file", "at", "caption"), "vtt" (the text, if any), "pauses" (a list of
// [begin, end], s of film), "frames", "fps", "width", "height", "duration" (s of film), "title".
Product film_product(const DeckPicture& picture,
                     const DeckScene& scene,
                     const LectureSettings& settings);
// A single picture. Facts: "poster", "poster_at" (s), "width", "height".
Product still_product(const DeckPicture& picture,
                      const DeckScene& scene,
                      const LectureSettings& settings);
// A chart or stability maps. Facts: "svg", "png", "csv", "summary".
Product chart_product(const DeckPicture& picture, const DeckScene& scene);
Product stability_product(const DeckPicture& picture, const DeckScene& scene);
// The output of inspect. Facts: "inspection".
Product inspect_product(const DeckScene& scene);
// The motion as a CSV table. Facts: "csv".
Product motion_product(const DeckScene& scene);

}  // namespace polhode
