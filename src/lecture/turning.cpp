// SPDX-License-Identifier: MIT
#include "lecture/turning.h"

#include <algorithm>

#include "base/base64.h"
#include "base/system/atomic_file.h"
#include "frame/elements.h"
#include "frame/timeline.h"
#include "html/escape.h"
#include "lecture/script_folder.h"
#include "motion/recorded.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

constexpr int kFewestReadings = 240, kMostReadings = 2000;  // of the numbers that are read out
constexpr int kPlotSteps = 600;

// What is between the tags of a script: nothing in it may end it.
std::string for_script(const Json& data) {
  std::string text = data.dump(-1, ' ', true, Json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

Json plots_of(const Solved& solved, double to) {
  Json plots = Json::array();
  const Motion& motion = solved.simulation.motion;
  for (const std::string& name : solved.scene.show.plots) {
    for (const Recorded& quantity : recorded_quantities()) {
      if (quantity.name != name) continue;
      const int steps = steps_to_show(motion, to, kPlotSteps);
      Json curves = Json::array();
      const auto all = values_over_time(quantity, motion, to, steps);
      for (std::size_t k = 0; k < all.size(); ++k) {
        curves.push_back(
            {{"name", quantity.curves[k]}, {"values", extremes_of(all[k], kPlotSteps)}});
      }
      plots.push_back({{"title", quantity.title}, {"unit", quantity.unit}, {"curves", curves}});
    }
  }
  return plots;
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

Json viewer_data(const Solved& solved, double from, double to) {
  const Motion& motion = solved.simulation.motion;
  const Scene& scene = solved.scene;
  Json data = {{"from", from},
               {"to", to},
               {"scale", scene.video.time_scale},
               {"fps", scene.video.fps.value()},
               {"title", scene.title},
               {"pauses", Json::array()},
               {"captions", Json::array()},
               {"plots", plots_of(solved, to)}};
  const Timeline timeline(scene.story, motion.duration(), scene.video.time_scale);
  for (const Pause& pause : timeline.pauses()) {
    if (pause.at >= from && pause.at <= to)
      data["pauses"].push_back({{"at", pause.at}, {"caption", pause.caption}});
  }
  for (const StoryStep& step : timeline.steps()) {
    if (step.caption) data["captions"].push_back({{"at", step.at}, {"caption", *step.caption}});
  }
  const int steps =
      std::clamp(steps_to_show(motion, to, kFewestReadings), kFewestReadings, kMostReadings);
  Json omega = Json::array(), momentum = Json::array(), energy = Json::array();
  for (int i = 0; i <= steps; ++i) {
    const Sample now = motion.at(std::min(from + (to - from) * i / steps, motion.duration()));
    omega.push_back(now.w_S.norm());
    momentum.push_back(now.L_S.norm());
    energy.push_back(now.energy);
  }
  data["series"] = {{"omega", omega}, {"momentum", momentum}, {"energy", energy}};
  for (const ShowName& element : show_names())
    data["elements"][element.name] = element.doc;
  return data;
}

std::string viewer_blocks(const Deck& deck,
                          const FigureOf& figure_of,
                          const fs::path& folder,
                          const Three& three) {
  std::string blocks;
  for (const DeckPicture& picture : deck.pictures) {
    if (picture.kind != PictureKind::turn) continue;
    const Figure figure = figure_of(picture);
    if (figure.facts.empty()) continue;
    Json data =
        Json::parse(read_file(folder / "media" / figure.facts.at("viewer").get<std::string>()));
    data["glb"] = base64(read_file(folder / "media" / figure.facts.at("glb").get<std::string>()));
    blocks += fmt::format("<script type=\"application/json\" data-viewer=\"{}\">{}</script>\n",
                          escaped(picture.name),
                          for_script(data));
  }
  if (blocks.empty()) return "";
  return blocks + "<script type=\"text/plain\" id=\"three\">" + three.js + "</script>\n";
}

}  // namespace polhode
