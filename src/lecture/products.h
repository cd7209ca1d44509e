// SPDX-License-Identifier: MIT
// Describes what must be rendered and computed for a deck, as products for the media cache.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "film/overrides.h"
#include "film/render_plan.h"
#include "lecture/deck/deck.h"
#include "lecture/media.h"

namespace polhode {

// Settings for all films of a deck.
struct LectureSettings {
  std::optional<std::string> size;  // "1280x720", of every picture that has no setting of its own
  std::optional<std::string> fps;   // "60" or "30000/1001", in the same way
  // one of theme_names() (frame/view_spec.h), in the same way
  std::optional<std::string> theme;
  std::string quality = "lecture";  // a name of qualities() (film/render_plan.h)
  std::string backend = "auto";     // for open_context() (render/context.h)
};

// A scene of the deck, checked by trusted_scene() (lecture/deck/sandbox.h) and loaded.
struct DeckScene {
  std::string name;            // as the deck names it
  std::filesystem::path file;  // its path
  Scene scene;
  std::string hash;  // scene_hash() (scene/scene.h)
};
// Throws Error (input), without a place, if the file says something else now than when it was read.
void check_unchanged(const DeckScene& scene);

// All these return a product (lecture/media.h) with copies of their arguments. They throw Error
// (input), without a place, for a setting that is not a number and for turns (of stability maps)
// that are not positive. Product::make throws as render_film, chart, stability, inspection or
// write_csv (app/commands/) or solve (film/solved_scene.h) does, and Error (input) if the scene has
// changed since it was loaded. Facts that name files contain their names in media/ (their keys are
// those of names_only() in lecture/media.cpp); all facts have "kind": "film" (also of a loop),
// "still", "chart", "stability", "inspect" or "motion".

// What renders the film of a picture, also of a loop, into `output`.
RenderJob film_job(const DeckPicture& picture,
                   const DeckScene& scene,
                   const LectureSettings& settings,
                   const std::filesystem::path& output);

// A film, also a loop. Facts: "film", "poster", "paper" (the poster
// in the colours of paper: the theme print, unless the picture or the settings ask for one),
// "poster_at" (s of motion), "stills" (in those colours, too; a list of objects with "file", "at"
// in s of motion, and "caption"), "vtt" (the text of the captions; "" if there are none), "pauses"
// (a list of [begin, end], s of film), "frames", "fps", "width" and "height" (pixels), "from_s" and
// "to_s" (s of motion), "duration" (s of film), "title".
Product film_product(const DeckPicture& picture,
                     const DeckScene& scene,
                     const LectureSettings& settings);
// A film, and what it shows as a model to turn by hand, over the same part of the motion. Facts:
// those of a film, "glb" (glTF, app/commands/export.h), "viewer" (viewer_data() in
// lecture/documents/turning.h, as JSON). `rights`: author and licence of the deck, for the notices
// of the model.
struct Rights {
  std::string author, licence;  // empty: none
};
Product turn_product(const DeckPicture& picture,
                     const DeckScene& scene,
                     const LectureSettings& settings,
                     const Rights& rights);
// One film of the picture's scenes, a panel each, with the same facts. There are at least two.
Product compare_product(const DeckPicture& picture,
                        const std::vector<DeckScene>& scenes,
                        const LectureSettings& settings);
// A single picture. Facts: "poster", "paper", "poster_at" (s of motion).
Product still_product(const DeckPicture& picture,
                      const DeckScene& scene,
                      const LectureSettings& settings);
// A chart or stability maps. Facts: "svg", "png", "csv" (files), "summary" (what the
// command prints).
Product chart_product(const DeckPicture& picture, const DeckScene& scene);
Product stability_product(const DeckPicture& picture, const DeckScene& scene);
// The output of inspect. Facts: "inspection", as inspection() (app/commands/inspect.h) returns it.
Product inspect_product(const DeckScene& scene);
// The motion as a CSV table. Facts: "csv".
Product motion_product(const DeckScene& scene);

}  // namespace polhode
