// SPDX-License-Identifier: MIT
#include "app/commands/list.h"

#include <cstdlib>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands/new_scene.h"
#include "base/error.h"
#include "base/nearest.h"
#include "base/one_line.h"
#include "base/shipped_files.h"
#include "base/system/files.h"
#include "base/text_table.h"
#include "frame/elements.h"
#include "model/loads.h"
#include "model/solids.h"
#include "motion/diagram.h"
#include "motion/recorded.h"
#include "motion/solution_method.h"
#include "motion/stepper_table.h"
#include "scene/scene_file.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

// the words whose condition holds, or a dash
std::string words(const std::vector<std::pair<bool, const char*>>& all) {
  std::vector<std::string> kept;
  for (const auto& [holds, word] : all) {
    if (holds) kept.emplace_back(word);
  }
  return kept.empty() ? "-" : fmt::format("{}", fmt::join(kept, " "));
}

std::string list_methods() {
  std::vector<TextRow> rows = {{"name",
                                "order",
                                "steps",
                                "keeps",
                                "takes",
                                "cost of a step",
                                "limit of the step",
                                "family",
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
                    words({{!m.only_table, "free"},
                           {m.takes_heavy, "heavy"},
                           {m.takes_loads && !m.only_table, "loads"},
                           {m.takes_table, "tables"},
                           {m.takes_rotator, "rotators"}}),
                    m.cost,
                    m.limit.empty() ? "-" : m.limit,
                    family_title(m.family),
                    m.source});
  }
  return aligned(rows);
}

std::string list_models() {
  std::vector<TextRow> rows = {{"name", "what it takes"}};
  for (const SolutionMethod& model : solution_methods())
    rows.push_back({model.name, model.doc});
  return aligned(rows);
}

std::string list_shapes() {
  std::vector<TextRow> rows = {{"name", "needs", "may have", "what it is"}};
  for (const SolidKind& kind : solid_kinds()) {
    rows.push_back({kind.name,
                    fmt::format("{}", fmt::join(kind.needs, " ")),
                    kind.takes.empty() ? "-" : fmt::format("{}", fmt::join(kind.takes, " ")),
                    kind.doc});
  }
  return aligned(rows);
}

std::string list_torques() {
  std::vector<TextRow> rows = {{"kind", "needs", "may have", "what it is"}};
  for (const LoadKind& kind : load_kinds()) {
    std::vector<std::string> needs = kind.needs;
    if (kind.directed) needs.insert(needs.begin(), "space|body");
    std::vector<std::string> takes = kind.takes;
    takes.insert(takes.end(), {"from", "until", "ramp"});
    rows.push_back({kind.name,
                    needs.empty() ? "-" : fmt::format("{}", fmt::join(needs, " ")),
                    fmt::format("{}", fmt::join(takes, " ")),
                    kind.doc});
  }
  return aligned(rows);
}

std::string list_plots() {
  std::vector<TextRow> rows = {{"name", "over", "unit", "what it is"}};
  for (const Recorded& quantity : recorded_quantities()) {
    rows.push_back(
        {quantity.name, "time", quantity.unit.empty() ? "-" : quantity.unit, quantity.title});
  }
  for (const DiagramKind& diagram : diagram_kinds())
    rows.push_back({diagram.name, "itself", "-", diagram.doc});
  return aligned(rows);
}

std::string list_elements() {
  std::vector<TextRow> rows = {{"name", "what it is"}};
  for (const Element& element : elements())
    rows.push_back({element.name, element.doc});
  return aligned(rows);
}

std::string list_starts() {
  std::vector<TextRow> rows = {{"name", "files", "what it is"}};
  for (const NewKind& kind : new_kinds())
    rows.push_back({kind.name, fmt::format("{}", fmt::join(kind.files, " ")), kind.doc});
  return aligned(rows);
}

std::string list_formats() {
  std::vector<TextRow> rows = {{"name", "alpha", "what it is"}};
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
  if (is_there(folder)) files = entries_of(folder);
  std::erase_if(files, [](const fs::path& file) { return file.extension() != ".toml"; });
  if (files.empty()) {
    throw input_error("there are no scenes in '{}'; POLHODE_SCENES can name another folder",
                      folder.string());
  }
  std::vector<TextRow> rows = {{"file", "title"}};
  for (const fs::path& file : files)
    rows.push_back({file.string(), one_line(load_scene(file).title)});
  return aligned(rows);
}

struct Listing {
  const char* name;
  std::string (*make)();
};
constexpr Listing kListings[] = {{"methods", list_methods},
                                 {"models", list_models},
                                 {"shapes", list_shapes},
                                 {"torques", list_torques},
                                 {"elements", list_elements},
                                 {"plots", list_plots},
                                 {"scenes", list_scenes},
                                 {"starts", list_starts},
                                 {"formats", list_formats}};

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
  throw input_error("there is no table '{}'{}", name, suggestion(name, list_names()));
}

}  // namespace polhode
