// SPDX-License-Identifier: MIT
#include "lecture/lecture.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include "base/hash.h"
#include "base/one_line.h"
#include "base/system/atomic_file.h"
#include "base/system/interrupt.h"
#include "base/system/output_folder.h"
#include "base/system/parallel.h"
#include "base/system/unfinished.h"
#include "chart/gnuplot.h"
#include "lecture/data.h"
#include "lecture/deck/own_pictures.h"
#include "lecture/deck/pandoc.h"
#include "lecture/deck/quotes.h"
#include "lecture/deck/word_list.h"
#include "lecture/documents/document_warnings.h"
#include "lecture/documents/documents.h"
#include "lecture/documents/lost_words.h"
#include "lecture/documents/notices.h"
#include "lecture/documents/sliders.h"
#include "lecture/documents/turning.h"
#include "lecture/lecture_plan.h"
#include "lecture/media.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

void run_task(LectureTask& task, Media& media) {
  try {
    task.facts = media.obtain(task.product);
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    task.failure = error;
  }
}

void run_tasks(LectureWork& work, Media& media, const std::vector<LectureTask*>& tasks) {
  std::vector<LectureTask*> together, alone;
  for (LectureTask* task : tasks)
    (task->alone ? alone : together).push_back(task);
  Progress progress(work.job->progress, static_cast<int>(tasks.size()), "pictures");
  progress.show(0);
  std::mutex lock;
  int done = 0;
  const auto run = [&](LectureTask* task) {
    stop_if_interrupted();
    run_task(*task, media);
    const std::lock_guard guard(lock);
    progress.show(++done);
  };
  parallel_for(static_cast<long>(together.size()), work.job->jobs, [&](long i) {
    run(together[static_cast<std::size_t>(i)]);
  });
  for (LectureTask* task : alone)
    run(task);
}

// the table of a picture that inspects a scene
Json table_of(const DeckPicture& picture, const Json& facts) {
  const auto keys = picture.settings.find("keys");
  return number_table(facts.at("inspection"),
                      picture.scenes.front(),
                      keys == picture.settings.end() ? "" : keys->second);
}

// The failures of products become those of the pictures that need them; those of tables of motions
// are told alone where no picture has the same.
void tell_failures(LectureWork& work) {
  std::set<std::string> told;
  for (std::size_t i = 0; i < work.deck.pictures.size(); ++i) {
    const DeckPicture& picture = work.deck.pictures[i];
    if (work.stems[i].empty()) continue;
    LectureTask& task = work.tasks.at(work.stems[i]);
    try {
      if (task.failure) throw *task.failure;
      if (picture.kind != PictureKind::inspect) continue;
      table_of(picture, task.facts);
    } catch (const Error& error) {
      told.insert(error.what());
      work.failures[i] = error.what();
      work.deck.problems.push_back(in_deck(work, picture.line, error));
    }
  }
  for (const auto& [name, stem] : work.motions) {
    const std::optional<Error>& failure = work.tasks.at(stem).failure;
    if (failure && told.insert(failure->what()).second)
      work.deck.problems.push_back(in_deck(work, 0, *failure));
  }
}

// Tells what products were made with warnings of, now or before: those of pictures with the line of
// the first that needs them, and of the others what has not been told yet.
void tell_warnings(const LectureWork& work, const std::vector<LectureTask*>& tasks) {
  std::set<std::string> stems, told;
  for (const LectureTask* task : tasks)
    stems.insert(Media::stem_of(task->product));
  const auto tell = [&](const std::string& stem, int line) {
    const LectureTask& task = work.tasks.at(stem);
    if (stems.erase(stem) == 0 || task.failure) return;
    for (const Json& warning : task.facts.at("warnings")) {
      std::string words = warning.get<std::string>();
      if (!told.insert(words).second && line == 0) continue;
      // a picture has the options of the program without their dashes
      if (words.starts_with("--")) words.erase(0, 2);
      spdlog::warn("{}", Error(Fault::input, words, Place{work.deck.file, line, {}}).what());
    }
  };
  for (std::size_t i = 0; i < work.stems.size(); ++i)
    if (!work.stems[i].empty()) tell(work.stems[i], work.deck.pictures[i].line);
  const std::set<std::string> others = stems;
  for (const std::string& stem : others)
    tell(stem, 0);
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
  const LectureTask& task = work.tasks.at(work.inspections.at(name));
  if (task.failure) throw *task.failure;
  return task.facts.at("inspection");
}

// ordinary pictures go to the rest, by their content
void copy_images(LectureWork& work, Media& media) {
  std::map<std::string, std::string>& copies = work.images;
  for (const std::string& image : work.deck.images) {
    std::string bytes = read_file(trusted_file(work.deck.root, work.deck.root.folder, image));
    const std::string ending = picture_ending(image);
    if (is_jpeg(image)) bytes = as_jfif(std::move(bytes));
    const Product copy{
        "picture", bytes + ending, [&](const fs::path& folder, const std::string& stem) {
          write_file(folder / (stem + ending), bytes);
          return Json{{"kind", "picture"}};
        }};
    media.obtain(copy);
    copies[image] = fmt::format("media/{}{}", Media::stem_of(copy), ending);
  }
  const auto rename = [&](Json& node) {
    if (node["t"] == "Image" && copies.contains(node["c"][2][0]))
      node["c"][2][0] = copies.at(node["c"][2][0]);
  };
  for_each_node(work.deck.blocks, rename);
  for (DeckPicture& picture : work.deck.pictures)
    for_each_node(picture.caption, rename);
}

std::string file_of(const std::string& output) {
  for (const LectureOutput& row : lecture_outputs())
    if (row.name == output) return row.file;
  return output;
}

// Tells what a document lacks of the deck, unless something is left out of it that was told.
void tell_lost_words(const LectureWork& work,
                     const std::string& output,
                     const std::string& document,
                     DocumentForm form) {
  if (!work.deck.problems.empty()) return;
  const std::vector<std::string> lost = lost_words(work.deck, document, form, kCountedWords);
  if (lost.empty()) return;
  spdlog::warn("{}: lacks what the deck has, which this program or pandoc has lost: {}",
               file_of(output),
               named_words(lost));
}

std::string make_document(const std::string& output,
                          const LectureWork& work,
                          const fs::path& folder,
                          const Scripts& scripts,
                          const Printer& printer) {
  const FigureOf figures = [&](const DeckPicture& picture) {
    return figure_of(work, picture);
  };
  const auto whole = [&](std::string document, DocumentForm form) {
    tell_lost_words(work, output, document, form);
    return document;
  };
  if (output == "html" || output == "slides") {
    const std::string viewers =
        scripts.three ? viewer_blocks(work.deck, figures, folder, *scripts.three, scripts.core)
                      : "";
    return whole(output == "html" ? make_page(work.deck, figures, viewers)
                                  : make_slides(work.deck, figures, *scripts.reveal, viewers),
                 DocumentForm::html);
  }
  if (output == "pptx") return whole(make_pptx(work.deck, figures, folder), DocumentForm::office);
  if (output == "beamer") return whole(make_beamer(work.deck, figures), DocumentForm::latex);
  // the page that is printed stands beside the media for as long as that takes
  const fs::path page = folder / ".handout.html";
  const Unfinished unfinished(page);
  write_file(page, whole(make_handout_html(work.deck, figures), DocumentForm::html));
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
  data.images = work.images;
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
      const LectureTask& motion = work.tasks.at(stem->second);
      if (!motion.failure) csv = motion.facts.at("csv");
    }
    data.scenes.push_back({scene, csv});
  }
  return data;
}

// the products of one shard
LectureResult make_products(PlannedLecture& lecture, const Shard& shard) {
  LectureWork& work = lecture.work;
  const std::vector<LectureTask*> mine = tasks_of(work, shard);
  Media media(lecture.folder / "media", work.deck.root.folder);
  run_tasks(work, media, mine);
  tell_warnings(work, mine);
  LectureResult result;
  for (const LectureTask* task : mine) {
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

// The documents in the folder that are not among these outputs.
std::vector<std::string> documents_left(const fs::path& folder,
                                        const std::vector<std::string>& outputs) {
  std::vector<std::string> left;
  for (const LectureOutput& output : lecture_outputs()) {
    const bool made = std::find(outputs.begin(), outputs.end(), output.name) != outputs.end();
    std::error_code ignored;
    if (!made && output.name != "data" && fs::exists(folder / output.file, ignored))
      left.push_back(one_line((folder / output.file).string()));
  }
  return left;
}

// fontconfig's program tells where the font is
std::string state_of_formula_font(const std::string& advice) {
  if (!formula_font_css().empty()) return "ok, Latin Modern Math";
  const ProgramFound program = find_program("fc-match");
  if (!program.why_not.empty()) return state_of_program(program, "install fontconfig");
  return "missing: " + advice + "; browsers take their own font";
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
  planned.refuse_overwriting();
  OutputFolder documents(folder, files);

  // render, then everything that needs it
  Media media(folder / "media", work.deck.root.folder);
  const std::vector<LectureTask*> tasks = tasks_of(work, {});
  run_tasks(work, media, tasks);
  tell_warnings(work, tasks);
  tell_failures(work);
  fill_quotes(work.deck, work.deck_text, [&](const std::string& name) -> const Json& {
    return inspection_of(work, name);
  });
  settle_formulas(work.deck, work.deck_text);
  const int made = media.made();
  copy_images(work, media);
  std::vector<std::string> contents;
  for (const std::string& output : outputs) {
    if (output == "data") continue;
    contents.push_back(make_document(output, work, folder, scripts, planned.printer));
    for (const std::string& warning : document_warnings(work.deck, output))
      spdlog::warn("{}: {}", file_of(output), warning);
  }
  const bool formula_font = pages && !formula_font_css().empty();
  if (pages) {
    std::string told =
        notices(outputs, scripts.reveal, formula_font, scripts.three, scripts.core.has_value());
    const fs::path before = folder / kNoticesFile;
    std::error_code missing;
    if (!documents_left(folder, outputs).empty() && fs::is_regular_file(before, missing))
      told = with_earlier_notices(std::move(told), read_file(before));
    contents.push_back(std::move(told));
  }
  stop_if_interrupted();
  // all is written before the first file has its name
  std::optional<DataFolder> data;
  if (planned.wants("data")) data.emplace(data_of(work, outputs, scripts, formula_font), folder);
  documents.write(contents);
  if (data) data->commit();
  documents.commit();
  // what documents of an earlier run show must stay with them
  const std::vector<std::string> older = documents_left(folder, outputs);
  const bool failed = std::any_of(work.failures.begin(),
                                  work.failures.end(),
                                  [](const std::string& failure) { return !failure.empty(); });
  if (older.empty()) {
    // nor is anything lost to a mistake that will be mended
    if (!failed) media.forget_the_rest();
  } else {
    spdlog::warn(
        "{} {} from an earlier run, so that pictures and films of that are kept; make {} again "
        "with --to, or delete {}",
        fmt::join(older, ", "),
        older.size() == 1 ? "is" : "are",
        older.size() == 1 ? "it" : "them",
        older.size() == 1 ? "it" : "them");
  }
  for (const std::string& file : files)
    result.summary += one_line((folder / file).string()) + "\n";
  if (planned.wants("data"))
    result.summary += one_line((folder / "data/manifest.json").string()) + "\n";
  result.summary += fmt::format("{} pictures, {} made now\n", work.tasks.size(), made);
  result.problems = std::move(work.deck.problems);
  return result;
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
          {"sliders in lectures",
           find_page_core() ? "ok" : "missing: build with Emscripten (docs/lecture.md)"},
          {"handouts of lectures",
           printer.program.empty() ? state_of_program(printer.found, install("chromium"))
                                   : "ok, " + printer.program},
          {"font of formulas", state_of_formula_font(install("fonts-lmodern"))}};
}

}  // namespace polhode
