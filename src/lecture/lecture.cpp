// SPDX-License-Identifier: MIT
// Longer than most: the steps of one command from a deck to a finished folder, in their order.
#include "lecture/lecture.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <set>

#include "app/commands/render.h"
#include "base/hash.h"
#include "base/name_list.h"
#include "base/one_line.h"
#include "base/system/atomic_file.h"
#include "base/system/interrupt.h"
#include "base/system/output_folder.h"
#include "base/system/overwriting.h"
#include "base/system/parallel.h"
#include "base/system/scratch_folder.h"
#include "chart/gnuplot.h"
#include "lecture/data.h"
#include "lecture/documents.h"
#include "lecture/media.h"
#include "lecture/notices.h"
#include "lecture/pandoc.h"
#include "lecture/quotes.h"
#include "lecture/turning.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

// One product with what came of it.
struct Task {
  Product product;
  bool alone = false;   // it measures time, and has the machine to itself
  double cost_s = 0.0;  // about what it takes on one processor, s
  Json facts;
  std::optional<Error> failure;
};

// Everything that is being made.
struct LectureWork {
  const LectureJob* job = nullptr;
  Deck deck;
  std::string deck_text;
  std::map<std::string, std::shared_ptr<DeckScene>> scenes;  // by the deck's name for them
  std::map<std::string, Error> bad_scenes;
  std::map<std::string, Task> tasks;                        // by stem
  std::map<std::string, std::string> inspections, motions;  // scene -> stem
  std::vector<std::string> stems;                           // of each picture; empty: it failed
  std::vector<std::string> failures;                        // of each picture; empty: none
  std::string address;  // of the documents on the web; empty: unknown
};

// Throws what is wrong with the scene, each time the same.
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

// What products cost beside films, s on one processor; a film is told by its pixels. They are only
// needed to deal the dear ones out first.
constexpr double kChartSeconds = 30.0, kStabilitySeconds = 30.0, kStillSeconds = 1.0,
                 kNumbersSeconds = 0.1, kPixelSeconds = 8e-9;

std::string add_task(LectureWork& work, Product product, double cost_s, bool alone = false) {
  std::string stem = Media::stem_of(product);
  work.tasks.try_emplace(stem, Task{std::move(product), alone, cost_s, {}, {}});
  return stem;
}

double cost_of_film(const DeckPicture& picture,
                    const std::vector<DeckScene>& scenes,
                    const LectureSettings& settings) {
  double seconds = 0.0;
  for (const DeckScene& scene : scenes)
    seconds = std::max(seconds, scene.scene.motion.duration / scene.scene.video.time_scale);
  const RenderJob job = film_job(picture, scenes.front(), settings, {});
  const VideoSpec video = load_with_overrides(job.scene, job.overrides).video;
  return seconds * video.fps.value() * video.size.width * video.size.height * kPixelSeconds;
}

// an error of a scene behind the place in the deck that asked for it
Error in_deck(const LectureWork& work, int line, const Error& error) {
  return Error(error.fault(), error.what(), {work.deck.file, line, {}});
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

void run_task(Task& task, Media& media) {
  try {
    task.facts = media.obtain(task.product);
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    task.failure = error;
  }
}

// The tasks of the shard, or all; those that take longest come first and are dealt out first.
std::vector<Task*> tasks_of(LectureWork& work, const std::optional<Shard>& shard) {
  std::vector<Task*> all, mine;
  for (auto& [stem, task] : work.tasks)
    all.push_back(&task);
  std::stable_sort(
      all.begin(), all.end(), [](const Task* a, const Task* b) { return a->cost_s > b->cost_s; });
  for (const long i : pieces_of(shard, static_cast<long>(all.size()), "pictures"))
    mine.push_back(all[static_cast<std::size_t>(i)]);
  return mine;
}

void run_tasks(LectureWork& work, Media& media, const std::vector<Task*>& tasks) {
  std::vector<Task*> together, alone;
  for (Task* task : tasks)
    (task->alone ? alone : together).push_back(task);
  Progress progress(work.job->progress, static_cast<int>(tasks.size()), "pictures");
  progress.show(0);
  std::mutex lock;
  int done = 0;
  const auto run = [&](Task* task) {
    stop_if_interrupted();
    run_task(*task, media);
    const std::lock_guard guard(lock);
    progress.show(++done);
  };
  parallel_for(static_cast<long>(together.size()), work.job->jobs, [&](long i) {
    run(together[static_cast<std::size_t>(i)]);
  });
  for (Task* task : alone)
    run(task);
}

// the table of a picture that inspects a scene
Json table_of(const DeckPicture& picture, const Json& facts) {
  const auto keys = picture.settings.find("keys");
  return number_table(facts.at("inspection"),
                      picture.scenes.front(),
                      keys == picture.settings.end() ? "" : keys->second);
}

// the failures of products become those of the pictures that need them
void tell_failures(LectureWork& work) {
  for (std::size_t i = 0; i < work.deck.pictures.size(); ++i) {
    const DeckPicture& picture = work.deck.pictures[i];
    if (work.stems[i].empty()) continue;
    Task& task = work.tasks.at(work.stems[i]);
    try {
      if (task.failure) throw *task.failure;
      if (picture.kind != PictureKind::inspect) continue;
      table_of(picture, task.facts);
    } catch (const Error& error) {
      work.failures[i] = error.what();
      work.deck.problems.push_back(in_deck(work, picture.line, error));
    }
  }
}

Figure figure_of(const LectureWork& work, const DeckPicture& picture) {
  const std::vector<DeckPicture>& all = work.deck.pictures;
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const DeckPicture& one) { return one.name == picture.name; });
  const auto i = static_cast<std::size_t>(found - all.begin());
  Figure figure{&picture, {}, work.failures[i]};
  if (!figure.failure.empty()) return figure;
  figure.facts = work.tasks.at(work.stems[i]).facts;
  if (picture.kind == PictureKind::turn && !work.address.empty())
    figure.address = work.address + viewer_link(picture);
  if (picture.kind == PictureKind::inspect) {
    figure.facts["table"] = Json::array({table_of(picture, figure.facts)});
  }
  return figure;
}

const Json& inspection_of(LectureWork& work, const std::string& name) {
  refuse_panels(scene_of(work, name).scene);  // throws what is wrong with it
  const Task& task = work.tasks.at(work.inspections.at(name));
  if (task.failure) throw *task.failure;
  return task.facts.at("inspection");
}

// ordinary pictures go beside the rest, by their content
void copy_images(LectureWork& work, const fs::path& folder) {
  std::map<std::string, std::string> copies;
  for (const std::string& image : work.deck.images) {
    const std::string bytes = read_file(trusted_file(work.deck.root, work.deck.root.folder, image));
    const std::string name = fmt::format("media/picture-{}{}",
                                         content_hash(bytes).substr(0, 16),
                                         fs::path(image).extension().string());
    write_file(folder / name, bytes);
    copies[image] = name;
  }
  const auto rename = [&](Json& node) {
    if (node["t"] == "Image" && copies.contains(node["c"][2][0]))
      node["c"][2][0] = copies.at(node["c"][2][0]);
  };
  for_each_node(work.deck.blocks, rename);
  for (DeckPicture& picture : work.deck.pictures)
    for_each_node(picture.caption, rename);
}

constexpr const char* kNoThree =
    "three.js is missing; install it (docs/install.md), or run tools/install-dependencies --for "
    "lecture";

// Scripts of others that documents contain.
struct Scripts {
  std::optional<Reveal> reveal;
  std::optional<Three> three;  // only if something is to be turned
};

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

std::string make_document(const std::string& output,
                          const LectureWork& work,
                          const fs::path& folder,
                          const Scripts& scripts,
                          const Printer& printer) {
  const FigureOf figures = [&](const DeckPicture& picture) {
    return figure_of(work, picture);
  };
  if (output == "html" || output == "slides") {
    const std::string viewers =
        scripts.three ? viewer_blocks(work.deck, figures, folder, *scripts.three) : "";
    if (output == "html") return make_page(work.deck, figures, viewers);
    return make_slides(work.deck, figures, *scripts.reveal, viewers);
  }
  if (output == "pptx") return make_pptx(work.deck, figures, folder);
  if (output == "beamer") return make_beamer(work.deck, figures);
  // the page that is printed stands beside the media for as long as that takes
  const fs::path page = folder / ".handout.html";
  write_file(page, make_handout_html(work.deck, figures));
  const auto remove = [&] {
    std::error_code ignored;
    fs::remove(page, ignored);
  };
  try {
    std::string pdf = print_page(printer.program, page);
    remove();
    return pdf;
  } catch (...) {
    remove();
    throw;
  }
}

LectureData data_of(const LectureWork& work,
                    const std::vector<std::string>& outputs,
                    const Scripts& scripts,
                    bool formula_font) {
  LectureData data;
  data.deck = &work.deck;
  data.deck_text = work.deck_text;
  data.licence = words_of(work.deck).licence;
  data.outputs = outputs;
  data.settings = work.job->settings;
  data.reveal_version = scripts.reveal ? scripts.reveal->version : "";
  data.three_version = scripts.three ? scripts.three->version : "";
  data.formula_font = formula_font;
  for (const auto& [stem, task] : work.tasks) {
    if (!task.failure) data.products.emplace_back(stem, task.facts);
  }
  for (const auto& [name, scene] : work.scenes) {
    if (scene == nullptr) continue;
    std::string csv;
    if (const auto stem = work.motions.find(name); stem != work.motions.end()) {
      const Task& motion = work.tasks.at(stem->second);
      if (!motion.failure) csv = motion.facts.at("csv");
    }
    data.scenes.push_back({scene, csv});
  }
  return data;
}

}  // namespace

const std::vector<LectureOutput>& lecture_outputs() {
  static const std::vector<LectureOutput> table = {
      {"html", "index.html", "one page with films, formulas, charts"},
      {"slides", "slides.html", "slides by reveal.js; films stop where the story pauses"},
      {"pptx", "slides.pptx", "PowerPoint, with posters that link to the films"},
      {"beamer", "slides.tex", "LaTeX Beamer source, with stills"},
      {"handout", "handout.pdf", "stills, formulas and numbers on paper"},
      {"data", "data/manifest.json", "motions as tables, scenes, a manifest"},
  };
  return table;
}

namespace {

void refuse_scene(const fs::path& deck) {
  if (deck.extension() != ".toml") return;
  throw input_error(
      "is a scene, not a deck; name a Markdown file whose pictures name scenes, or use "
      "`polhode render`")
      .at({deck, 0, {}});
}

// What is to be made, and with what; nothing is written yet.
struct PlannedLecture {
  explicit PlannedLecture(const LectureJob& job)
      : folder(folder_or_default(job.output, job.deck, "lecture")) {
    refuse_scene(job.deck);
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
    const bool data = job.part.shard ? job.to.empty() || may_want("data") : wants("data");
    work.address = words_of(work.deck).address;
    if (has_viewers(work.deck) && has_pages(outputs)) {
      scripts.three = find_three();
      if (!scripts.three)
        left_out += fmt::format("left out: turning by hand ({}); its films are shown\n", kNoThree);
    }
    plan(work, data);
  }

  bool wants(const std::string& name) const {
    return std::find(outputs.begin(), outputs.end(), name) != outputs.end();
  }
  // the documents, and what goes with them
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const LectureOutput& output : lecture_outputs()) {
      if (wants(output.name) && output.name != "data") names.push_back(output.file);
    }
    if (has_pages(outputs)) names.emplace_back(kNoticesFile);
    return names;
  }
  // all that the products depend on, and which they are
  std::string words() const {
    std::string all = program_identity();
    for (const auto& [stem, task] : work.tasks)
      all += "\n" + task.product.key;
    return all + "\n" + work.deck_text;
  }

  fs::path folder;
  Scripts scripts;
  Printer printer;
  std::string left_out;  // documents that this machine cannot make
  std::vector<std::string> outputs;
  LectureWork work;
};

// the products of one shard
LectureResult make_products(PlannedLecture& lecture, const Shard& shard) {
  LectureWork& work = lecture.work;
  const std::vector<Task*> mine = tasks_of(work, shard);
  Media media(lecture.folder / "media");
  run_tasks(work, media, mine);
  LectureResult result;
  for (const Task* task : mine) {
    if (!task->failure) continue;
    result.problems.emplace_back(task->failure->fault(),
                                 fmt::format("{}: {}", task->product.name, task->failure->what()),
                                 Place{work.deck.file, 0, {}});
  }
  result.summary = fmt::format(
      "part {}: {} of {} pictures, {} made now; kept in {} until the same command without --shard "
      "uses them\n",
      name_of(shard),
      mine.size(),
      work.tasks.size(),
      media.made(),
      one_line((lecture.folder / "media").string()));
  return result;
}

}  // namespace

LectureResult lecture(const LectureJob& job) {
  // read and plan before anything is written
  PlannedLecture planned(job);
  LectureWork& work = planned.work;
  const std::optional<Shard> shard = part_of_work(job.part, planned.words());
  if (shard) return make_products(planned, *shard);
  LectureResult result;
  result.summary = planned.left_out;
  const std::vector<std::string>& outputs = planned.outputs;
  const Scripts& scripts = planned.scripts;
  const fs::path& folder = planned.folder;
  const std::vector<std::string> files = planned.files();
  const bool pages = has_pages(outputs);
  refuse_same_files(folder, files, {job.deck});
  OutputFolder documents(folder, files);

  // render, then everything that needs it
  Media media(folder / "media");
  run_tasks(work, media, tasks_of(work, {}));
  tell_failures(work);
  fill_quotes(work.deck, work.deck_text, [&](const std::string& name) -> const Json& {
    return inspection_of(work, name);
  });
  drop_bad_formulas(work.deck, work.deck_text);
  copy_images(work, folder);
  std::vector<std::string> contents;
  for (const std::string& output : outputs) {
    if (output != "data")
      contents.push_back(make_document(output, work, folder, scripts, planned.printer));
  }
  const bool formula_font = pages && !formula_font_css().empty();
  if (pages) contents.push_back(notices(outputs, scripts.reveal, formula_font, scripts.three));
  stop_if_interrupted();
  if (planned.wants("data")) write_data(data_of(work, outputs, scripts, formula_font), folder);
  documents.commit(contents);
  media.forget_the_rest();
  for (const std::string& file : files)
    result.summary += one_line((folder / file).string()) + "\n";
  if (planned.wants("data"))
    result.summary += one_line((folder / "data/manifest.json").string()) + "\n";
  result.summary += fmt::format("{} pictures, {} made now\n", work.tasks.size(), media.made());
  result.problems = std::move(work.deck.problems);
  return result;
}

DividedWork divided_lecture(const LectureJob& job) {
  DividedWork divided;
  divided.start_s = seconds_of([&] { PlannedLecture{job}; });
  PlannedLecture planned(job);
  LectureWork& work = planned.work;
  if (!work.deck.problems.empty()) throw work.deck.problems.front();
  if (work.tasks.empty()) throw input_error("has no picture to be made").at({job.deck, 0, {}});
  const std::vector<std::string> files = planned.files();
  refuse_same_files(planned.folder, files, {job.deck});
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

std::vector<ExternalNeed> lecture_needs() {
  // in the sources one command brings all of it
  const auto install = [](const char* what) {
    return fmt::format("install {}, or run tools/install-dependencies --for lecture", what);
  };
  const Printer printer = find_printer();
  const std::optional<Reveal> reveal = find_reveal();
  const std::optional<Three> three = find_three();
  return {{"lectures", state_of_program(find_pandoc(), install("pandoc"))},
          {"slides of lectures",
           reveal ? "ok, reveal.js " + reveal->version
                  : "missing: " + install("reveal.js (docs/install.md)")},
          {"turning in lectures",
           three ? "ok, three.js " + three->version
                 : "missing: " + install("three.js (docs/install.md)")},
          {"handouts of lectures",
           printer.program.empty() ? state_of_program(printer.found, install("chromium"))
                                   : "ok, " + printer.program},
          {"font of formulas",
           formula_font_css().empty()
               ? "missing: " + install("fonts-lmodern") + "; browsers take their own font"
               : "ok, Latin Modern Math"}};
}

}  // namespace polhode
