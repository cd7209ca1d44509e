// SPDX-License-Identifier: MIT
#include "lecture/lecture_plan.h"

#include <algorithm>
#include <set>

#include <spdlog/spdlog.h>

#include "app/commands/render.h"
#include "base/name_list.h"
#include "base/one_line.h"
#include "base/system/atomic_file.h"
#include "base/system/output_folder.h"
#include "base/system/overwriting.h"
#include "base/system/scratch_folder.h"
#include "film/overrides.h"
#include "film/render_plan.h"
#include "lecture/deck/pandoc.h"
#include "lecture/deck/quotes.h"
#include "lecture/documents/notices.h"
#include "lecture/documents/sliders.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

// What products cost beside films, s on one processor; a film is told by its pixels. They are only
// needed to deal the dear ones out first.
constexpr double kChartSeconds = 30.0, kStabilitySeconds = 30.0, kStillSeconds = 1.0,
                 kNumbersSeconds = 0.1, kPixelSeconds = 8e-9;

std::string add_task(LectureWork& work, Product product, double cost_s, bool alone = false) {
  std::string stem = Media::stem_of(product);
  work.tasks.try_emplace(stem, LectureTask{std::move(product), alone, cost_s, {}, {}});
  return stem;
}

double cost_of_film(const DeckPicture& picture,
                    const std::vector<DeckScene>& scenes,
                    const LectureSettings& settings) {
  double seconds = 0.0;
  for (const DeckScene& scene : scenes)
    seconds = std::max(seconds, shown_duration(scene.scene) / scene.scene.video.time_scale);
  const RenderJob job = film_job(picture, scenes.front(), settings, {});
  const VideoSpec video = load_with_overrides(job.scene, job.overrides).video;
  return seconds * video.fps.value() * video.size.width * video.size.height * kPixelSeconds;
}

// Returns the stem of what must be made for it.
std::string plan_picture(LectureWork& work, const DeckPicture& picture) {
  std::vector<DeckScene> scenes;
  for (const std::string& name : picture.scenes)
    scenes.push_back(scene_of(work, name));
  const DeckScene& scene = scenes.front();
  const LectureSettings& settings = work.job->settings;
  switch (picture.kind) {
    case PictureKind::loop:
      refuse_panels(scene.scene);
      [[fallthrough]];
    case PictureKind::film:
      return add_task(
          work, film_product(picture, scene, settings), cost_of_film(picture, scenes, settings));
    case PictureKind::turn: {
      refuse_panels(scene.scene);
      const DeckWords words = words_of(work.deck);
      return add_task(work,
                      turn_product(picture, scene, settings, {words.author, words.licence}),
                      cost_of_film(picture, scenes, settings));
    }
    case PictureKind::compare:
      return add_task(work,
                      compare_product(picture, scenes, settings),
                      cost_of_film(picture, scenes, settings));
    case PictureKind::still:
      return add_task(work, still_product(picture, scene, settings), kStillSeconds);
    case PictureKind::chart:
      return add_task(work, chart_product(picture, scene), kChartSeconds, true);
    case PictureKind::stability:
      return add_task(work, stability_product(picture, scene), kStabilitySeconds, true);
    case PictureKind::inspect:
      refuse_panels(scene.scene);
      return add_task(work, inspect_product(scene), kNumbersSeconds);
  }
  return "";
}

// what must be made; what cannot even be begun is a problem of the deck
void plan(LectureWork& work, bool data) {
  for (const DeckPicture& picture : work.deck.pictures) {
    work.failures.emplace_back();
    work.stems.emplace_back();
    try {
      work.stems.back() = plan_picture(work, picture);
    } catch (const Error& error) {
      work.failures.back() = error.what();
      work.deck.problems.push_back(in_deck(work, picture.line, error));
    }
  }
  for (const std::string& name : quoted_scenes(work.deck)) {
    try {
      scene_of(work, name);
    } catch (const Error&) {
      continue;  // the quote tells, with its line
    }
  }
  for (const auto& [name, scene] : work.scenes) {
    // a film of several scenes has no one motion to inspect
    if (scene == nullptr || !scene->scene.panels.empty()) continue;
    work.inspections[name] = add_task(work, inspect_product(*scene), kNumbersSeconds);
    if (data) work.motions[name] = add_task(work, motion_product(*scene), kNumbersSeconds);
  }
}

constexpr const char* kNoThree =
    "three.js is missing; install it (docs/install.md), or run tools/install-dependencies --for "
    "lecture";

constexpr const char* kNoCore = "this program was built without Emscripten; see docs/lecture.md";

std::string why_not(const std::string& output,
                    const std::optional<Reveal>& reveal,
                    const Printer& printer) {
  if (output == "slides" && !reveal) {
    return "reveal.js is missing; install it (docs/install.md), or run tools/install-dependencies "
           "--for lecture";
  }
  if (output == "handout" && printer.program.empty()) {
    return printer.found.why_not +
           (printer.found.installed
                ? ""
                : "; install it, or run tools/install-dependencies --for lecture");
  }
  return "";
}

std::set<std::string> parse_outputs(const std::string& to) {
  std::vector<std::string> known;
  for (const LectureOutput& output : lecture_outputs())
    known.push_back(output.name);
  return known_names(to, known, "output", "--to");
}

// Outputs that this machine can make; what was asked for by name must be possible.
std::vector<std::string> settle_outputs(const std::string& to,
                                        const std::optional<Reveal>& reveal,
                                        const Printer& printer,
                                        std::string& summary) {
  const std::set<std::string> wanted = parse_outputs(to);
  const bool all = wanted.empty();
  std::vector<std::string> possible;
  for (const LectureOutput& output : lecture_outputs()) {
    if (!all && wanted.count(output.name) == 0) continue;
    const std::string reason = why_not(output.name, reveal, printer);
    if (reason.empty()) {
      possible.push_back(output.name);
    } else if (all) {
      summary += fmt::format("left out: {} ({})\n", output.file, reason);
    } else {
      throw environment_error("no {}: {}", output.file, reason).at({{}, 0, "--to"});
    }
  }
  return possible;
}

// what no picture could be made with
void check_settings(const LectureSettings& settings) {
  Overrides overrides;
  overrides.size = settings.size;
  overrides.fps = settings.fps;
  overrides.theme = settings.theme;
  check_overrides(overrides);
  find_quality(settings.quality);
}

void refuse_scene(const fs::path& deck) {
  if (deck.extension() != ".toml") return;
  throw input_error(
      "is a scene, not a deck; name a Markdown file whose pictures name scenes, or use "
      "`polhode render`")
      .at({deck, 0, {}});
}

}  // namespace

const DeckScene& scene_of(LectureWork& work, const std::string& name) {
  if (const auto bad = work.bad_scenes.find(name); bad != work.bad_scenes.end()) throw bad->second;
  std::shared_ptr<DeckScene>& scene = work.scenes[name];
  if (scene == nullptr) {
    try {
      auto read = std::make_shared<DeckScene>();
      read->name = name;
      read->file = trusted_scene(work.deck.root, name);
      read->scene = load_scene(read->file);
      read->hash = scene_hash(read->scene);
      scene = std::move(read);
    } catch (const Error& error) {
      work.scenes.erase(name);
      work.bad_scenes.emplace(name, error);
      throw;
    }
  }
  return *scene;
}

Error in_deck(const LectureWork& work, int line, const Error& error) {
  return Error(error.fault(), error.what(), {work.deck.file, line, {}});
}

std::vector<LectureTask*> tasks_of(LectureWork& work, const std::optional<Shard>& shard) {
  std::vector<LectureTask*> all, mine;
  for (auto& [stem, task] : work.tasks)
    all.push_back(&task);
  std::stable_sort(all.begin(), all.end(), [](const LectureTask* a, const LectureTask* b) {
    return a->cost_s > b->cost_s;
  });
  for (const long i : pieces_of(shard, static_cast<long>(all.size()), "pictures"))
    mine.push_back(all[static_cast<std::size_t>(i)]);
  return mine;
}

PlannedLecture::PlannedLecture(const LectureJob& job)
    : folder(folder_or_default(job.output, job.deck, "lecture")) {
  refuse_scene(job.deck);
  check_settings(job.settings);
  require_pandoc();
  const auto may_want = [&](const char* name) {
    return job.to.empty() || job.to.find(name) != std::string::npos;
  };
  // a part makes no documents
  if (!job.part.shard) {
    if (may_want("slides")) scripts.reveal = find_reveal();
    if (may_want("handout")) printer = find_printer();
    outputs = settle_outputs(job.to, scripts.reveal, printer, left_out);
  } else {
    parse_outputs(job.to);
  }
  work.job = &job;
  work.deck_text = read_file(job.deck);
  work.deck = read_deck(job.deck, job.allow_outside);
  for (const Error& remark : work.deck.remarks)
    spdlog::warn("{}", remark.what());
  const bool data = job.part.shard ? job.to.empty() || may_want("data") : wants("data");
  work.address = words_of(work.deck).address;
  if (has_viewers(work.deck) && has_pages(outputs)) {
    scripts.three = find_three();
    if (!scripts.three)
      left_out += fmt::format("left out: turning by hand ({}); its films are shown\n", kNoThree);
    if (scripts.three && has_sliders(work.deck)) {
      scripts.core = find_page_core();
      if (!scripts.core) left_out += fmt::format("left out: sliders ({})\n", kNoCore);
    }
  }
  plan(work, data);
}

bool PlannedLecture::wants(const std::string& name) const {
  return std::find(outputs.begin(), outputs.end(), name) != outputs.end();
}
std::vector<std::string> PlannedLecture::files() const {
  std::vector<std::string> names;
  for (const LectureOutput& output : lecture_outputs()) {
    if (wants(output.name) && output.name != "data") names.push_back(output.file);
  }
  if (has_pages(outputs)) names.emplace_back(kNoticesFile);
  return names;
}
void PlannedLecture::refuse_overwriting() const {
  refuse_same_files(folder, files(), {work.job->deck});
  std::vector<fs::path> needed = {work.job->deck};
  for (const DeckPicture& picture : work.deck.pictures) {
    for (const std::string& scene : picture.scenes)
      needed.push_back(work.deck.root.folder / scene);
  }
  for (const std::string& image : work.deck.images)
    needed.push_back(work.deck.root.folder / image);
  // and what those that could be read name, or quotes
  for (const auto& [name, scene] : work.scenes) {
    const std::vector<fs::path> files = input_files(scene->scene);
    needed.insert(needed.end(), files.begin(), files.end());
  }
  const auto canonical = [](const fs::path& path) {
    std::error_code ignored;  // what cannot be looked at is told when it is read
    return fs::weakly_canonical(path, ignored);
  };
  for (const char* const cleared : {"data", "media"}) {
    const fs::path place = canonical(folder / cleared);
    for (const fs::path& file : needed) {
      const fs::path inside = canonical(file).lexically_relative(place);
      if (inside.empty() || *inside.begin() == "..") continue;
      throw input_error(
          "'{}' lies in the folder '{}' of the output, from which files of earlier runs are "
          "removed; choose another output",
          file.string(),
          cleared)
          .at({{}, 0, "--output"});
    }
  }
}
std::string PlannedLecture::words() const {
  std::string all = program_identity();
  for (const auto& [stem, task] : work.tasks)
    all += "\n" + task.product.key;
  return all + "\n" + work.deck_text;
}

DividedWork divided_lecture(const LectureJob& job) {
  DividedWork divided;
  divided.start_s = seconds_of([&] { PlannedLecture{job}; });
  PlannedLecture planned(job);
  LectureWork& work = planned.work;
  if (!work.deck.problems.empty()) throw work.deck.problems.front();
  if (work.tasks.empty()) throw input_error("has no picture to be made").at({job.deck, 0, {}});
  const std::vector<std::string> files = planned.files();
  planned.refuse_overwriting();
  divided.words = planned.words();
  divided.output = planned.folder;
  divided.proof = files;
  if (planned.wants("data")) divided.proof.emplace_back("data/manifest.json");
  divided.things = "pictures";
  divided.pieces = static_cast<long>(work.tasks.size());
  double films = 0.0, rest = 0.0, longest = 0.0;
  const DeckPicture* picture = nullptr;
  for (std::size_t i = 0; i < work.deck.pictures.size(); ++i) {
    const PictureKind kind = work.deck.pictures[i].kind;
    if (kind != PictureKind::film && kind != PictureKind::turn) continue;
    const double cost = work.tasks.at(work.stems[i]).cost_s;
    if (cost > longest) picture = &work.deck.pictures[i];
    longest = std::max(longest, cost);
  }
  for (const auto& [stem, task] : work.tasks) {
    const std::string& name = task.product.name;
    (name.ends_with("-film") || name.ends_with("-turn") ? films : rest) += task.cost_s;
  }
  // what films really cost here is measured on the longest
  if (picture != nullptr) {
    const ScratchFolder scratch;
    const DividedWork film = divided_film(film_job(
        *picture, scene_of(work, picture->scenes.front()), job.settings, scratch / "film.mp4"));
    films *= film.piece_s * static_cast<double>(film.pieces) / longest;
    divided.start_s += film.start_s;
  }
  divided.piece_s = (films + rest) / static_cast<double>(divided.pieces);
  return divided;
}

}  // namespace polhode
