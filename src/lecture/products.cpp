// SPDX-License-Identifier: MIT
#include "lecture/products.h"

#include <algorithm>
#include <cmath>

#include "app/commands/chart.h"
#include "app/commands/export.h"
#include "app/commands/inspect.h"
#include "app/commands/render.h"
#include "app/commands/simulate.h"
#include "app/commands/stability.h"
#include "base/numbers.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "export/viewer_data.h"
#include "film/frame_times.h"
#include "film/solved_scene.h"
#include "frame/timeline.h"
#include "lecture/documents/sliders.h"
#include "lecture/documents/turning.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

double number_of(const std::string& text, const std::string& key) {
  const std::optional<double> value = parse_number(text);
  if (!value)
    throw input_error("{} must be a number, such as 2.5; found '{}'", key, text.substr(0, 40));
  return *value;
}

// a setting of the picture; none if it is not there
std::optional<std::string> text_of(const DeckPicture& picture, const std::string& key) {
  const auto found = picture.settings.find(key);
  if (found == picture.settings.end()) return {};
  return found->second;
}

std::optional<double> number_in(const DeckPicture& picture, const std::string& key) {
  const std::optional<std::string> text = text_of(picture, key);
  if (!text) return {};
  return number_of(*text, key);
}

std::vector<double> numbers_in(const DeckPicture& picture, const std::string& key) {
  std::vector<double> numbers;
  std::string text = text_of(picture, key).value_or("");
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) numbers.push_back(number_of(text.substr(0, end), key));
    text.erase(0, end + 1);
  }
  return numbers;
}

// times of these settings that the motion does not have, told before any work
void check_times(const DeckPicture& picture,
                 double duration,
                 std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    for (const double t : numbers_in(picture, key)) {
      if (t >= 0.0 && up_to(duration, t) <= duration) continue;
      throw input_error("must be a time within the motion, 0 to {} s, got {}", duration, t)
          .at({{}, 0, key});
    }
  }
  const double from = number_in(picture, "from").value_or(0.0);
  const std::optional<double> to = number_in(picture, "to");
  if (to && *to <= from)
    throw input_error("must be later than from ({} s), got {}", from, *to).at({{}, 0, "to"});
  // a poster shows what its film does
  const double last = to.value_or(duration);
  for (const char* key : {"at", "stills"}) {
    for (const double t : numbers_in(picture, key)) {
      if (t >= from && t <= last) continue;
      throw input_error("must be a time of the film, {} to {} s, got {}", from, last, t)
          .at({{}, 0, key});
    }
  }
}

// what the picture and the command line say in place of the scene
Overrides overrides_of(const DeckPicture& picture, const LectureSettings& settings) {
  Overrides overrides;
  overrides.size = text_of(picture, "size");
  if (!overrides.size) overrides.size = settings.size;
  overrides.fps = text_of(picture, "fps");
  if (!overrides.fps) overrides.fps = settings.fps;
  overrides.theme = text_of(picture, "theme");
  if (!overrides.theme) overrides.theme = settings.theme;
  overrides.method = text_of(picture, "method");
  overrides.step = number_in(picture, "step");
  overrides.loop = picture.kind == PictureKind::loop;
  return overrides;
}

std::string key_of_product(const std::string& kind,
                           const DeckScene& scene,
                           const std::vector<std::string>& words) {
  std::string key = fmt::format("{}\n{}\n{}", kind, program_identity(), scene.hash);
  for (const std::string& word : words)
    key += "\n" + word;
  return key;
}

// everything that a picture of a scene depends on besides the scene
std::vector<std::string> words_of(const DeckPicture& picture, const LectureSettings& settings) {
  std::vector<std::string> words = {settings.size.value_or(""),
                                    settings.fps.value_or(""),
                                    settings.theme.value_or(""),
                                    settings.quality,
                                    settings.backend};
  for (const auto& [key, value] : picture.settings) {
    // words that change no pixel
    if (key != "alt" && key != "with" && key != "clock")
      words.push_back(fmt::format("{}={}", key, value));
  }
  return words;
}

std::string name_of_product(const DeckScene& scene, const std::string& kind) {
  std::string name = scene.file.stem().string();
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || (std::isalnum(byte) == 0 && c != '_')) c = '-';
  }
  return fmt::format("{}-{}", name.substr(0, 60), kind);
}

RenderJob render_job(const DeckScene& scene,
                     const Overrides& overrides,
                     const LectureSettings& settings,
                     const fs::path& output) {
  RenderJob job;
  job.scene = scene.file;
  job.output = output.string();
  job.overrides = overrides;
  job.quality = settings.quality;
  job.backend = settings.backend;
  job.progress = ProgressKind::none;
  return job;
}

void render_still(const DeckScene& scene,
                  const Overrides& overrides,
                  const LectureSettings& settings,
                  double at,
                  const fs::path& output) {
  RenderJob job = render_job(scene, overrides, settings, output);
  job.still = at;
  render_film(job);
}

// the colours of paper, ink on white, unless somebody has asked for others
Overrides on_paper(Overrides overrides) {
  if (!overrides.theme) overrides.theme = "print";
  return overrides;
}

// A picture for screens, and one for paper where that is another. Returns the name of the second.
std::string render_for_both(const DeckScene& scene,
                            const Overrides& overrides,
                            const LectureSettings& settings,
                            double at,
                            const fs::path& folder,
                            const std::string& shown,
                            const std::string& paper) {
  render_still(scene, overrides, settings, at, folder / shown);
  if (overrides.theme) return shown;
  render_still(scene, on_paper(overrides), settings, at, folder / paper);
  return paper;
}

// Where a film stops by itself, in its own seconds, and what is shown there.
struct Stops {
  std::vector<Pause> pauses;
  double first = 0.0;  // of the film of the whole motion, s
};

Stops stops_of(const Scene& scene, const Json& report, double length, bool loop) {
  const double from = report["from_s"],
               duration = loop ? double(report["to_s"]) : shown_duration(scene);
  const Timeline timeline(story_of_film(scene, scene.story), duration, scene.video.time_scale);
  Stops stops;
  stops.first = timeline.first_film_time(from);
  for (Pause pause : timeline.pauses()) {
    pause.begins -= stops.first;
    pause.ends -= stops.first;
    if (reached(pause.begins, 0.0) && pause.begins < length)
      stops.pauses.push_back(std::move(pause));
  }
  return stops;
}

Json make_film_files(const DeckPicture& picture,
                     const DeckScene& scene,
                     const LectureSettings& settings,
                     const fs::path& folder,
                     const std::string& stem) {
  const Overrides overrides = overrides_of(picture, settings);
  const fs::path film = folder / (stem + ".mp4"), report_file = folder / (stem + ".report");
  RenderJob job = film_job(picture, scene, settings, film);
  job.report = report_file.string();
  render_film(job);
  const Json report = Json::parse(read_file(report_file));
  remove_file(report_file);

  const double fps = load_with_overrides(scene.file, overrides).video.fps.value();
  const double length = double(report["frames"]) / fps;
  const Stops stops = stops_of(scene.scene, report, length, overrides.loop);
  Json facts = {{"kind", "film"}, {"film", film.filename().string()}, {"title", scene.scene.title}};
  for (const char* key : {"frames", "width", "height", "from_s", "to_s"})
    facts[key] = report[key];
  facts["fps"] = fps;
  facts["duration"] = length;
  facts["pauses"] = Json::array();
  for (const Pause& pause : stops.pauses)
    facts["pauses"].push_back({pause.begins, pause.ends});
  const fs::path captions = folder / (stem + ".vtt");
  facts["vtt"] = is_there(captions) ? read_file(captions) : "";

  // the poster, and what is shown on paper
  const double from = report["from_s"], to = report["to_s"];
  std::vector<double> times = numbers_in(picture, "stills");
  const bool asked = !times.empty();
  if (!asked) {
    for (const Pause& pause : stops.pauses)
      times.push_back(pause.at);
  }
  const double unasked = stops.pauses.empty() ? from + (to - from) / 3.0 : stops.pauses.back().at;
  const double at = number_in(picture, "at").value_or(unasked);
  const std::string poster = stem + "-poster.png";
  const std::string paper =
      render_for_both(scene, overrides, settings, at, folder, poster, stem + "-paper.png");
  facts["poster"] = poster;
  facts["paper"] = paper;
  facts["poster_at"] = at;
  facts["stills"] = Json::array();
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::string file = paper;
    if (times[i] != at) {
      file = fmt::format("{}-still-{}.png", stem, i + 1);
      render_still(scene, on_paper(overrides), settings, times[i], folder / file);
    }
    facts["stills"].push_back(
        {{"file", file},
         {"at", times[i]},
         {"caption", asked || i >= stops.pauses.size() ? "" : stops.pauses[i].caption}});
  }
  return facts;
}

// moves what chart and stability write to the names of the product
Json take_pictures(const fs::path& made,
                   const fs::path& folder,
                   const std::string& stem,
                   const std::string& name) {
  Json facts;
  for (const char* ending : {"svg", "png"}) {
    move_file(made / fmt::format("{}.{}", name, ending),
              folder / fmt::format("{}.{}", stem, ending));
    facts[ending] = fmt::format("{}.{}", stem, ending);
  }
  const std::string csv = name.substr(0, name.find('_')) + ".csv";
  move_file(made / csv, folder / (stem + ".csv"));
  facts["csv"] = stem + ".csv";
  remove_file(made);
  return facts;
}

}  // namespace

// the key of a product was made from what the file said then
void check_unchanged(const DeckScene& scene) {
  if (scene_hash(load_scene(scene.file)) != scene.hash)
    throw input_error("{} changed during the run; run again", scene.name);
}

RenderJob film_job(const DeckPicture& picture,
                   const DeckScene& scene,
                   const LectureSettings& settings,
                   const fs::path& output) {
  RenderJob job = render_job(scene, overrides_of(picture, settings), settings, output);
  job.from = number_in(picture, "from");
  job.to = number_in(picture, "to");
  return job;
}

Product film_product(const DeckPicture& picture,
                     const DeckScene& scene,
                     const LectureSettings& settings) {
  overrides_of(picture, settings);  // wrong numbers are told before any work
  const char* kind = picture.kind == PictureKind::loop ? "loop" : "film";
  for (const char* key : {"from", "to", "at"})
    number_in(picture, key);
  check_times(picture, shown_duration(scene.scene), {"from", "to", "at", "stills"});
  return {name_of_product(scene, kind),
          key_of_product(kind, scene, words_of(picture, settings)),
          [=](const fs::path& folder, const std::string& stem) {
            Json facts = make_film_files(picture, scene, settings, folder, stem);
            check_unchanged(scene);
            return facts;
          }};
}

Product turn_product(const DeckPicture& picture,
                     const DeckScene& scene,
                     const LectureSettings& settings,
                     const Rights& rights) {
  const Product film = film_product(picture, scene, settings);
  const std::vector<Slider> sliders = parse_sliders(text_of(picture, "vary").value_or(""));
  check_sliders(sliders, scene.file, overrides_of(picture, settings));
  std::vector<std::string> words = words_of(picture, settings);
  words.insert(words.end(), {rights.author, rights.licence});
  return {name_of_product(scene, "turn"),
          key_of_product("turn", scene, words),
          [=](const fs::path& folder, const std::string& stem) {
            Json facts = film.make(folder, stem);
            ExportJob job;
            job.scene = scene.file;
            job.overrides = overrides_of(picture, settings);
            job.from = facts.at("from_s").get<double>();
            job.to = facts.at("to_s").get<double>();
            job.author = rights.author;
            job.licence = rights.licence;
            const Scene shown = load_single(scene.file, job.overrides);
            write_file(folder / (stem + ".glb"), glb_of_scene(shown, job).bytes);
            Json data = viewer_data(solve_alone(shown), *job.from, *job.to);
            data.update(slider_data(sliders, job, read_file(scene.file)));
            write_file(folder / (stem + "-viewer.json"), data.dump());
            check_unchanged(scene);
            facts["glb"] = stem + ".glb";
            facts["viewer"] = stem + "-viewer.json";
            return facts;
          }};
}

Product compare_product(const DeckPicture& picture,
                        const std::vector<DeckScene>& scenes,
                        const LectureSettings& settings) {
  overrides_of(picture, settings);
  std::string film;
  std::vector<std::string> words = words_of(picture, settings);
  double longest = 0.0;
  for (const DeckScene& scene : scenes) {
    film += fmt::format("[[panel]]\nscene = {}\n", Json(absolute_path(scene.file).string()).dump());
    words.push_back(scene.hash);
    longest = std::max(longest, scene.scene.motion.duration);
  }
  check_times(picture, longest, {"from", "to", "at", "stills"});
  return {name_of_product(scenes.front(), "compare"),
          key_of_product("compare", scenes.front(), words),
          [=](const fs::path& folder, const std::string& stem) {
            // beside what is made, for as long as that takes
            const fs::path file = folder / (stem + ".toml");
            write_file(file, film);
            const Scene scene = load_scene(file);
            const DeckScene together{file.filename().string(), file, scene, scene_hash(scene)};
            Json facts = make_film_files(picture, together, settings, folder, stem);
            remove_file(file);
            for (const DeckScene& one : scenes)
              check_unchanged(one);
            return facts;
          }};
}

Product still_product(const DeckPicture& picture,
                      const DeckScene& scene,
                      const LectureSettings& settings) {
  const Overrides overrides = overrides_of(picture, settings);
  const double at = number_in(picture, "at").value_or(0.0);
  check_times(picture, shown_duration(scene.scene), {"at"});
  return {name_of_product(scene, "still"),
          key_of_product("still", scene, words_of(picture, settings)),
          [=](const fs::path& folder, const std::string& stem) {
            const std::string shown = stem + ".png";
            const std::string paper =
                render_for_both(scene, overrides, settings, at, folder, shown, stem + "-paper.png");
            check_unchanged(scene);
            return Json{{"kind", "still"}, {"poster", shown}, {"paper", paper}, {"poster_at", at}};
          }};
}

Product chart_product(const DeckPicture& picture, const DeckScene& scene) {
  ChartJob job;
  job.scenes = {scene.file};
  job.methods = text_of(picture, "methods").value_or("");
  job.overrides.accuracy = text_of(picture, "accuracy");
  job.progress = ProgressKind::none;
  return {name_of_product(scene, "chart"),
          key_of_product("chart", scene, words_of(picture, {})),
          [job, scene](const fs::path& folder, const std::string& stem) {
            ChartJob here = job;
            here.output = (folder / "made").string();
            const std::string summary = chart(here);
            Json facts = take_pictures(here.output, folder, stem, "chart");
            check_unchanged(scene);
            facts["kind"] = "chart";
            facts["summary"] = summary;
            return facts;
          }};
}

Product stability_product(const DeckPicture& picture, const DeckScene& scene) {
  StabilityJob job;
  job.scenes = {scene.file};
  job.methods = text_of(picture, "methods").value_or("");
  job.x = text_of(picture, "x").value_or(job.x);
  job.y = text_of(picture, "y").value_or(job.y);
  job.x_range = text_of(picture, "x-range");
  job.y_range = text_of(picture, "y-range");
  job.cells = text_of(picture, "cells").value_or(job.cells);
  job.turns = number_in(picture, "turns").value_or(job.turns);
  if (!(job.turns > 0.0)) throw input_error("turns must be greater than 0");
  job.progress = ProgressKind::none;
  const std::string name = "stability_" + scene.file.stem().string();
  return {name_of_product(scene, "stability"),
          key_of_product("stability", scene, words_of(picture, {})),
          [job, name, scene](const fs::path& folder, const std::string& stem) {
            StabilityJob here = job;
            here.output = (folder / "made").string();
            const std::string summary = stability(here);
            Json facts = take_pictures(here.output, folder, stem, name);
            check_unchanged(scene);
            facts["kind"] = "stability";
            facts["summary"] = summary;
            return facts;
          }};
}

Product inspect_product(const DeckScene& scene) {
  return {name_of_product(scene, "inspect"),
          key_of_product("inspect", scene, {}),
          [scene](const fs::path&, const std::string&) {
            Json facts = {
                {"kind", "inspect"},
                {"inspection", inspection(solve_alone(load_with_overrides(scene.file, {})))}};
            check_unchanged(scene);
            return facts;
          }};
}

Product motion_product(const DeckScene& scene) {
  return {name_of_product(scene, "motion"),
          key_of_product("motion", scene, {}),
          [scene](const fs::path& folder, const std::string& stem) {
            SimulateJob job;
            job.scene = scene.file;
            job.output = (folder / (stem + ".csv")).string();
            write_csv(job);
            check_unchanged(scene);
            return Json{{"kind", "motion"}, {"csv", stem + ".csv"}};
          }};
}

}  // namespace polhode
