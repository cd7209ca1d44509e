// SPDX-License-Identifier: MIT
#include "app/commands/list.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/nearest.h"
#include "base/shipped_files.h"
#include "chart/gnuplot.h"
#include "film/report.h"
#include "model/solids.h"
#include "motion/simulate.h"
#include "render/context.h"
#include "render/renderer.h"
#include "scene/scene.h"
#include "scene/schema.h"
#include "text/typesetter.h"
#include "video/encoders.h"
#include "video/frame_sink.h"

namespace polhode {
namespace {

using Row = std::vector<std::string>;

// columns padded to their widest cell, the last one free
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += i + 1 < row.size() ? fmt::format("{:<{}}  ", row[i], widths[i]) : row[i];
    }
    text += line + "\n";
  }
  return text;
}

// the words whose condition holds, or a dash
std::string words(const std::vector<std::pair<bool, const char*>>& all) {
  Row kept;
  for (const auto& [holds, word] : all) {
    if (holds) kept.emplace_back(word);
  }
  return kept.empty() ? "-" : fmt::format("{}", fmt::join(kept, " "));
}

std::string list_methods() {
  std::vector<Row> rows = {{"name",
                            "order",
                            "steps",
                            "keeps",
                            "takes",
                            "cost of a step",
                            "limit of the step",
                            "source"}};
  for (const StepperInfo& m : stepper_table()) {
    rows.push_back({m.name,
                    std::to_string(m.order),
                    m.adaptive ? "adaptive" : "fixed",
                    words({{m.keeps_energy, "energy"},
                           {m.keeps_momentum_norm, "|L|"},
                           {m.keeps_momentum_space, "L"},
                           {m.symplectic, "symplectic"},
                           {m.reversible, "reversible"}}),
                    words({{true, "free"},
                           {m.takes_heavy, "heavy"},
                           {m.takes_loads, "loads"},
                           {m.takes_rotator, "rotators"}}),
                    m.cost,
                    m.limit.empty() ? "-" : m.limit,
                    m.source});
  }
  return aligned(rows);
}

std::string list_models() {
  std::vector<Row> rows = {{"name", "what it takes"}};
  for (const SolutionMethod& model : solution_methods())
    rows.push_back({model.name, model.doc});
  return aligned(rows);
}

std::string list_shapes() {
  std::vector<Row> rows = {{"name", "needs", "may have", "what it is"}};
  for (const SolidKind& kind : solid_kinds()) {
    rows.push_back({kind.name,
                    fmt::format("{}", fmt::join(kind.needs, " ")),
                    kind.takes.empty() ? "-" : fmt::format("{}", fmt::join(kind.takes, " ")),
                    kind.doc});
  }
  return aligned(rows);
}

std::string list_formats() {
  std::vector<Row> rows = {{"name", "alpha", "what it is"}};
  for (const SinkKind& kind : sink_kinds()) {
    rows.push_back({kind.name, kind.alpha ? "yes" : "no", kind.doc});
  }
  return aligned(rows);
}

// the scenes of the folder `scenes` here, or of those that come with the program
std::string list_scenes() {
  namespace fs = std::filesystem;
  std::error_code failed;
  const bool here = std::getenv("POLHODE_SCENES") == nullptr && fs::is_directory("scenes", failed);
  const fs::path folder = here ? fs::path("scenes") : shipped_scenes();
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  if (files.empty()) {
    throw input_error("there are no scenes in '{}'; POLHODE_SCENES can name another folder",
                      folder.string());
  }
  std::sort(files.begin(), files.end());
  std::vector<Row> rows = {{"file", "title"}};
  for (const fs::path& file : files)
    rows.push_back({file.string(), load_scene(file).title});
  return aligned(rows);
}

struct Listing {
  const char* name;
  std::string (*make)();
};
constexpr Listing kListings[] = {{"methods", list_methods},
                                 {"models", list_models},
                                 {"shapes", list_shapes},
                                 {"scenes", list_scenes},
                                 {"formats", list_formats}};

// one line about a back end, from really opening it and its framebuffers
std::string examine_backend(const Backend& backend, bool& works) {
  try {
    const std::unique_ptr<Context> context = backend.open();
    const Renderer renderer(*context, {64, 64, 4, false, Edges::samples});
    works = true;
    return fmt::format("ok, {}, OpenGL {}, {} samples",
                       renderer.info().gl_renderer,
                       renderer.info().gl_version,
                       renderer.info().samples);
  } catch (const Error& error) {
    return fmt::format("missing: {}", error.what());
  }
}

}  // namespace

std::vector<std::string> list_names() {
  std::vector<std::string> names;
  for (const Listing& listing : kListings)
    names.emplace_back(listing.name);
  return names;
}

std::string list_table(const std::string& name) {
  for (const Listing& listing : kListings) {
    if (name == listing.name) return listing.make();
  }
  throw input_error("there is no list of '{}'{}", name, suggestion(name, list_names()));
}

std::string schema_text() {
  return scene_schema().dump(2) + "\n";
}

Diagnosis examine(const std::vector<ExternalNeed>& needs) {
  std::vector<Row> rows;
  bool draws = false;
  const nlohmann::ordered_json all = versions();
  for (const auto& [key, value] : all.items()) {
    rows.push_back({key, value.get<std::string>()});
  }
  for (const Backend& backend : backends()) {
    rows.push_back({"back end " + backend.name, examine_backend(backend, draws)});
  }
  const std::string gnuplot = gnuplot_version();
  rows.push_back({"charts", gnuplot.empty() ? "missing: install gnuplot-nox" : "ok, " + gnuplot});
  for (const ExternalNeed& need : needs)
    rows.push_back({need.name, need.state});
  for (const FontFound& font : examine_fonts()) {
    rows.push_back({"font " + font.wanted,
                    font.there ? "ok"
                               : fmt::format("missing: {} serves instead; install {}",
                                             font.found.empty() ? "nothing" : font.found,
                                             font.package)});
  }
  for (const FilmEncoder& encoder : film_encoders()) {
    rows.push_back(
        {"encoder " + encoder.name,
         fmt::format("{}, {}: {}",
                     has_encoder(encoder.name)
                         ? "ok"
                         : "missing: install an FFmpeg that has it (Debian: libavcodec59)",
                     encoder.title,
                     encoder.doc)});
  }
  const bool encodes = has_encoder("libx264");
  rows.push_back({"threads", std::to_string(std::thread::hardware_concurrency())});
  return {aligned(rows), draws && encodes};
}

}  // namespace polhode
