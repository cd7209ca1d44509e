// SPDX-License-Identifier: MIT
// What the reader of a page may change of a scene: the setting `vary` of a picture that is to be
// turned.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/export.h"
#include "lecture/deck/deck.h"

namespace polhode {

// A number of the scene and the range of its slider, in the unit that its key is spelled in.
struct Slider {
  std::string key;  // as --set has it: "motion.spin.body_rpm[2]"
  double from = 0.0, to = 0.0;
  std::string words;  // beside the slider; the key if the deck gives none
};

// The sliders that "KEY FROM TO WORDS; KEY FROM TO; …" describes; none for a blank text. Throws
// Error (input) without a place for anything else, and for more than eight.
std::vector<Slider> parse_sliders(const std::string& text);

// Checks the sliders against a scene: each key is a number in its file within the range, and the
// scene can be read with both ends; its body is no mesh from a file, which pages do not have.
// Throws Error (input) as number_in_scene and load_scene (scene/scene_file.h) do, and without a
// place.
void check_sliders(const std::vector<Slider>& sliders,
                   const std::filesystem::path& scene,
                   const Overrides& overrides);

// What turn.js needs for them: "sliders" (list of "key", "from", "to", "value", "words") and
// "request", what recomputed() (export/recomputed.h) is asked, without its settings; `text` is the
// text of the scene. Empty without sliders. Throws Error likewise.
Json slider_data(const std::vector<Slider>& sliders, const ExportJob& job, const std::string& text);

// The program for pages (src/page/), compressed by gzip: share/polhode/page/core.wasm.gz beside the
// installed program, or the file that POLHODE_PAGE_CORE names. Absent if there is none: it was
// built without Emscripten. Throws Error (input) if it cannot be read.
std::optional<std::string> find_page_core();

// Whether a picture of the deck has sliders.
bool has_sliders(const Deck& deck);

}  // namespace polhode
