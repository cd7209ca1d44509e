// SPDX-License-Identifier: MIT
#include "lecture/documents/sliders.h"

#include <algorithm>
#include <cstdlib>

#include "base/name_list.h"
#include "base/numbers.h"
#include "base/shipped_files.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostSliders = 8;
constexpr const char* kForm =
    "vary takes KEY FROM TO WORDS for each slider, such as \"motion.spin.body_rpm[2] 100 800 "
    "Spin, rpm\", separated by semicolons";

// takes the next word off a text
std::string next_word(std::string& text) {
  text.erase(0, std::min(text.find_first_not_of(" \t\n"), text.size()));
  const std::size_t end = std::min(text.find_first_of(" \t\n"), text.size());
  std::string word = text.substr(0, end);
  text.erase(0, end);
  return word;
}

Slider parse_slider(std::string text) {
  Slider slider;
  slider.key = next_word(text);
  const std::optional<double> from = parse_number(next_word(text));
  const std::optional<double> to = parse_number(next_word(text));
  if (!from || !to) throw input_error("{}; found '{}'", kForm, slider.key.substr(0, 40));
  if (!(*from < *to))
    throw input_error("vary: the range of {} must rise, got {} {}", slider.key, *from, *to);
  slider.from = *from;
  slider.to = *to;
  slider.words = trimmed(text);
  if (slider.words.empty()) slider.words = slider.key;
  return slider;
}

double value_in(const Slider& slider, const fs::path& scene, const Overrides& overrides) {
  const std::optional<double> value = number_in_scene(scene, overrides.settings, slider.key);
  if (!value) {
    throw input_error(
        "vary: {} has no number '{}' in its file", scene.filename().string(), slider.key);
  }
  return *value;
}

}  // namespace

std::vector<Slider> parse_sliders(const std::string& text) {
  std::vector<Slider> sliders;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find(';', from), text.size());
    const std::string_view one = trimmed(std::string_view(text).substr(from, end - from));
    if (!one.empty()) sliders.push_back(parse_slider(std::string(one)));
    from = end + 1;
  }
  if (sliders.size() > kMostSliders)
    throw input_error("vary: at most {} sliders, got {}", kMostSliders, sliders.size());
  return sliders;
}

void check_sliders(const std::vector<Slider>& sliders,
                   const fs::path& scene,
                   const Overrides& overrides) {
  if (!sliders.empty() && !mesh_names(load_scene(scene)).empty()) {
    throw input_error("vary: {} has a mesh from a file, which pages cannot read",
                      scene.filename().string());
  }
  for (const Slider& slider : sliders) {
    const double value = value_in(slider, scene, overrides);
    if (!(slider.from <= value && value <= slider.to)) {
      throw input_error("vary: {} is {} in the scene, outside of {} to {}",
                        slider.key,
                        value,
                        slider.from,
                        slider.to);
    }
    for (const double end : {slider.from, slider.to})
      load_scene(scene, overrides.settings, {{slider.key, end}});
  }
}

Json slider_data(const std::vector<Slider>& sliders,
                 const ExportJob& job,
                 const std::string& text) {
  Json data = Json::object();
  if (sliders.empty()) return data;
  data["sliders"] = Json::array();
  for (const Slider& slider : sliders) {
    data["sliders"].push_back({{"key", slider.key},
                               {"from", slider.from},
                               {"to", slider.to},
                               {"value", value_in(slider, job.scene, job.overrides)},
                               {"words", slider.words}});
  }
  Json request = {{"scene", text}, {"name", job.scene.filename().string()}};
  const auto add = [&](const char* key, const auto& value) {
    if (value) request[key] = *value;
  };
  add("method", job.overrides.method);
  add("size", job.overrides.size);
  add("fps", job.overrides.fps);
  add("theme", job.overrides.theme);
  add("step", job.overrides.step);
  add("from", job.from);
  add("to", job.to);
  request["author"] = job.author;
  request["licence"] = job.licence;
  data["request"] = request;
  return data;
}

std::optional<std::string> find_page_core() {
  const char* given = std::getenv("POLHODE_PAGE_CORE");
  const fs::path file = given != nullptr && *given != '\0'
                            ? fs::path(given)
                            : shipped_files() / "page" / "core.wasm.gz";
  if (!is_there(file)) return {};
  return read_file(file);
}

bool has_sliders(const Deck& deck) {
  return std::any_of(deck.pictures.begin(), deck.pictures.end(), [](const DeckPicture& picture) {
    return picture.kind == PictureKind::turn && picture.settings.count("vary") > 0;
  });
}

}  // namespace polhode
