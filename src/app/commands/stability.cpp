// SPDX-License-Identifier: MIT
#include "app/commands/stability.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <mutex>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "base/check.h"
#include "base/system/output_folder.h"
#include "base/system/parallel.h"
#include "base/version.h"
#include "chart/plot_stability.h"
#include "film/error_places.h"
#include "motion/scales.h"
#include "motion/solution_method.h"
#include "motion/step_limit.h"
#include "motion/stepper_table.h"

namespace polhode {
namespace {

constexpr const char* kStepKey = "numerics.step";
constexpr const char* kSpinKey = "spin";
constexpr int kMostCells = 1024;  // in one direction

MapAxis parse_range(const std::string& text, const std::string& option) {
  MapAxis axis;
  const std::size_t colon = text.find(':');
  const auto number = [&](const std::string& part) {
    char* end = nullptr;
    const double value = std::strtod(part.c_str(), &end);
    if (part.empty() || *end != '\0' || !std::isfinite(value)) {
      throw input_error("'{}' is not a range; write two numbers, 0.1:10", text).at({{}, 0, option});
    }
    return value;
  };
  if (colon == std::string::npos) number("");
  axis.from = number(text.substr(0, colon));
  axis.to = number(text.substr(colon + 1));
  if (axis.from >= axis.to) {
    throw input_error("the range must go up, got {}", text).at({{}, 0, option});
  }
  return axis;
}

// the two numbers of "128x96"
std::array<int, 2> parse_cells(const std::string& text) {
  int columns = 0, rows = 0, used = 0;
  if (std::sscanf(text.c_str(), "%4dx%4d%n", &columns, &rows, &used) != 2 ||
      used != static_cast<int>(text.size()) || columns < 2 || rows < 2 || columns > kMostCells ||
      rows > kMostCells) {
    throw input_error("'{}' is not the size of a map; write 64x64, at most {}", text, kMostCells)
        .at({{}, 0, "--cells"});
  }
  return {columns, rows};
}

// A motion that is ready to be tried, and the steps to try it with.
struct Setup {
  std::unique_ptr<StabilityProblem> problem;
  double step = 0.0;  // s, unless an axis says
};

// One scene with everything that its maps share.
struct MappedScene {
  std::filesystem::path file;
  Scene scene;
  MapAxis x, y;
  std::vector<Setup> setups;  // one per row, or one per cell
  std::vector<const StepperInfo*> methods;

  bool setup_per_cell() const { return x.key != kStepKey; }
  const Setup& setup(int column, int row) const {
    return setups[static_cast<std::size_t>(setup_per_cell() ? row * x.cells + column : row)];
  }
};

// the scene with these values of the two keys, as a problem
Setup make_setup(const MappedScene& place, double x, double y, const StabilityJob& job) {
  Replacements numbers;
  double spin = 1.0;
  std::optional<double> step;
  const auto apply = [&](const std::string& key, double value) {
    if (key == kSpinKey) {
      spin = value;
    } else if (key == kStepKey) {
      step = value;
    } else {
      numbers.emplace_back(key, value);
    }
  };
  apply(place.x.key, x);
  apply(place.y.key, y);
  const Scene scene = load_scene(place.file, numbers);
  return with_place(scene, [&] {
    const BodyModel model = with_needed_degrees(make_model(scene.body, scene.motion));
    State start = start_state(model, scene.motion);
    start.y *= spin;
    const double rate = typical_rate(model, start);
    if (rate <= 0.0)
      throw input_error("the body is at rest, so nothing can fail").at({{}, 0, "motion.spin"});
    Setup setup;
    setup.problem = std::make_unique<StabilityProblem>(model, start, job.turns * 2.0 * kPi / rate);
    setup.step = step.value_or(scene.numerics.step.value_or(0.1 / rate));
    return setup;
  });
}

// the axis with its key; its range, unless given, a factor of ten to both sides of the scene's own
MapAxis make_axis(const MappedScene& place,
                  const std::string& key,
                  const std::optional<std::string>& range,
                  const std::string& option,
                  double rate) {
  MapAxis axis;
  if (range) {
    axis = parse_range(*range, option + "-range");
  } else if (key == kStepKey) {
    axis.from = 0.1 / rate;
    axis.to = 10.0 / rate;
  } else if (key != kSpinKey) {
    const std::optional<double> own = number_in_scene(place.file, key);
    if (!own) {
      throw input_error(
          "{} has no number at '{}'; give {}-range A:B", place.file.string(), key, option)
          .at({{}, 0, option});
    }
    axis.from = *own > 0.0 ? 0.1 * *own : *own < 0.0 ? 2.0 * *own : -1.0;
    axis.to = *own > 0.0 ? 10.0 * *own : *own < 0.0 ? -2.0 * *own : 1.0;
  }
  if ((key == kStepKey || key == kSpinKey) && axis.from <= 0.0) {
    throw input_error("{} must be greater than 0", key).at({{}, 0, option + "-range"});
  }
  axis.key = key;
  return axis;
}

MappedScene make_place(const std::filesystem::path& file,
                       const StabilityJob& job,
                       const std::vector<const StepperInfo*>& methods) {
  MappedScene place;
  place.file = file;
  place.scene = load_scene(file);
  const double rate = with_place(place.scene, [&] {
    const BodyModel model = with_needed_degrees(make_model(place.scene.body, place.scene.motion));
    for (const StepperInfo* method : methods) {
      if (why_not(*method, model).empty()) place.methods.push_back(method);
    }
    if (place.methods.empty()) {
      throw input_error(
          "{} cannot take this scene: {}", methods.front()->name, why_not(*methods.front(), model));
    }
    const double found = typical_rate(model, start_state(model, place.scene.motion));
    if (found <= 0.0)
      throw input_error("the body is at rest, so nothing can fail").at({{}, 0, "motion.spin"});
    return found;
  });
  const std::array<int, 2> cells = parse_cells(job.cells);
  place.x = make_axis(place, job.x, job.x_range, "--x", rate);
  place.y = make_axis(place, job.y, job.y_range, "--y", rate);
  place.x.cells = cells[0];
  place.y.cells = cells[1];
  return place;
}

void prepare(MappedScene& place, const StabilityJob& job) {
  const int columns = place.setup_per_cell() ? place.x.cells : 1;
  place.setups.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(place.y.cells));
  parallel_for(static_cast<long>(place.setups.size()), job.jobs, [&](long i) {
    const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
    place.setups[static_cast<std::size_t>(i)] =
        make_setup(place, place.x.at(column), place.y.at(row), job);
  });
}

StabilityCell try_cell(
    const MappedScene& place, const StepperInfo& method, int column, int row, double allowed_rad) {
  const Setup& setup = place.setup(column, row);
  double h = setup.step;
  if (place.x.key == kStepKey) h = place.x.at(column);
  if (place.y.key == kStepKey) h = place.y.at(row);
  return try_method(method, *setup.problem, h, allowed_rad);
}

std::vector<LimitPoint> limit_curve(const MappedScene& place, const StepperInfo& method) {
  std::vector<LimitPoint> curve;
  if (place.x.key != kStepKey) return curve;
  for (int row = 0; row < place.y.cells; ++row) {
    const StabilityProblem& problem = *place.setup(0, row).problem;
    const double h = step_limit(method, problem.model, problem.start);
    if (std::isfinite(h)) curve.push_back({h, place.y.at(row)});
  }
  return curve;
}

// Finished rows of all maps, kept in a file so that a run that was stopped can go on.
class Finished {
 public:
  Finished(std::filesystem::path file, std::string words)
      : file_(std::move(file)), words_(std::move(words)) {}

  // takes up what an earlier run with the same words has left
  void load(std::vector<StabilityMap>& maps, int columns, std::set<std::pair<long, long>>& rows) {
    std::error_code missing;
    if (!std::filesystem::exists(file_, missing)) return;
    std::istringstream text(read_file(file_));
    std::string line;
    if (!std::getline(text, line) || line != words_) return;
    while (std::getline(text, line)) {
      std::istringstream in(line);
      long map = -1, row = -1;
      in >> map >> row;
      if (!in || map < 0 || map >= static_cast<long>(maps.size())) return;
      std::vector<StabilityCell>& cells = maps[static_cast<std::size_t>(map)].cells;
      for (int column = 0; column < columns; ++column) {
        std::string outcome, error, energy, momentum;
        in >> outcome >> error >> energy >> momentum;
        const auto place = static_cast<std::size_t>(row * columns + column);
        if (!in || row < 0 || place >= cells.size()) return;
        cells[place] = {parse_run_outcome(outcome),
                        std::strtod(error.c_str(), nullptr),
                        std::strtod(energy.c_str(), nullptr),
                        std::strtod(momentum.c_str(), nullptr)};
      }
      rows.emplace(map, row);
      lines_.append(line).push_back('\n');
    }
  }

  // called under a lock; writes the file now and then
  void add(long map, long row, const std::vector<StabilityCell>& cells, int columns) {
    lines_ += fmt::format("{} {}", map, row);
    for (int column = 0; column < columns; ++column) {
      const StabilityCell& cell = cells[static_cast<std::size_t>(row * columns + column)];
      fmt::format_to(std::back_inserter(lines_),
                     " {} {:.17g} {:.17g} {:.17g}",
                     name_of(cell.outcome),
                     cell.error_rad,
                     cell.energy_drift,
                     cell.momentum_drift);
    }
    lines_ += '\n';
    constexpr auto kBetween = std::chrono::seconds(2);
    const Clock::time_point now = Clock::now();
    if (now - saved_ > kBetween) {
      save();
      saved_ = now;
    }
  }

  void save() const { write_file(file_, words_ + '\n' + lines_); }
  void remove() const {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::filesystem::path file_;
  std::string words_;  // what the run was asked for, in one line
  std::string lines_;
  Clock::time_point saved_ = Clock::now();
};

// everything that a cell depends on
std::string words_of(const std::vector<MappedScene>& places, const StabilityJob& job) {
  std::string words =
      fmt::format("polhode {} {:.17g} {:.17g}", program_version(), job.turns, job.allowed_rad);
  for (const MappedScene& place : places) {
    words += fmt::format(" {}", scene_hash(place.scene));
    for (const MapAxis& axis : {place.x, place.y})
      words += fmt::format(" {} {:.17g} {:.17g} {}", axis.key, axis.from, axis.to, axis.cells);
    for (const StepperInfo* method : place.methods)
      words += fmt::format(" {}", method->name);
  }
  return words;
}

// a line per map: what became of its cells
std::string summary(const std::vector<StabilityMap>& maps) {
  std::string text;
  for (const StabilityMap& map : maps) {
    std::array<int, kRunOutcomes> count = {};
    for (const StabilityCell& cell : map.cells)
      ++count[static_cast<std::size_t>(cell.outcome)];
    text += fmt::format("{:<22} {:<22}", map.scene, map.method);
    for (std::size_t v = 0; v < count.size(); ++v) {
      if (count[v] == 0) continue;
      text += fmt::format(" {} {:.0f}%",
                          name_of(static_cast<RunOutcome>(v)),
                          100.0 * count[v] / static_cast<double>(map.cells.size()));
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::string stability(const StabilityJob& job) {
  const std::vector<const StepperInfo*> methods = parse_methods(job.methods);
  if (job.x == job.y) {
    throw input_error("both directions are '{}'; take two different keys", job.x)
        .at({{}, 0, "--y"});
  }
  // the step is cheap to change: it goes with the columns, and comes back at the end
  std::vector<MappedScene> places;
  std::set<std::string> names;
  for (const std::filesystem::path& file : job.scenes) {
    places.push_back(make_place(file, job, methods));
    if (names.insert(file.stem().string()).second) continue;
    throw input_error("two scenes are called '{}'; their maps would overwrite each other",
                      file.stem().string());
  }
  std::vector<StabilityMap> maps;
  std::vector<std::pair<const MappedScene*, const StepperInfo*>> owners;
  std::vector<std::string> files = {"stability.csv"};
  for (const MappedScene& place : places) {
    const std::string name = place.file.stem().string();
    files.push_back(fmt::format("stability_{}.png", name));
    files.push_back(fmt::format("stability_{}.svg", name));
    for (const StepperInfo* method : place.methods) {
      StabilityMap map;
      map.scene = name;
      map.title = place.scene.title.empty() ? name : place.scene.title;
      map.method = method->name;
      map.limit_words = method->limit;
      map.cells.resize(static_cast<std::size_t>(place.x.cells) *
                       static_cast<std::size_t>(place.y.cells));
      maps.push_back(std::move(map));
      owners.emplace_back(&place, method);
      files.push_back(fmt::format("stability_{}_{}.png", name, method->name));
    }
  }
  require_gnuplot();
  const std::filesystem::path where =
      folder_or_default(job.output, job.scenes.front(), "stability");
  OutputFolder folder(where, files);
  Finished finished(where / "stability.resume", words_of(places, job));

  // the cells, a row at a time on every processor
  const int columns = places[0].x.cells, rows = places[0].y.cells;
  std::set<std::pair<long, long>> done;
  finished.load(maps, columns, done);
  std::vector<std::pair<long, long>> left;
  for (long map = 0; map < static_cast<long>(maps.size()); ++map) {
    for (long row = 0; row < rows; ++row) {
      if (!done.contains({map, row})) left.emplace_back(map, row);
    }
  }
  for (MappedScene& place : places)
    prepare(place, job);
  Progress progress(job.progress, static_cast<int>(maps.size()) * rows, "rows");
  std::mutex lock;
  int count = static_cast<int>(done.size());
  try {
    parallel_for(static_cast<long>(left.size()), job.jobs, [&](long i) {
      const auto [map, row] = left[static_cast<std::size_t>(i)];
      const auto& [place, method] = owners[static_cast<std::size_t>(map)];
      std::vector<StabilityCell>& cells = maps[static_cast<std::size_t>(map)].cells;
      for (int column = 0; column < columns; ++column) {
        cells[static_cast<std::size_t>(row * columns + column)] =
            try_cell(*place, *method, column, static_cast<int>(row), job.allowed_rad);
      }
      const std::lock_guard guard(lock);
      finished.add(map, row, cells, columns);
      progress.show(++count);
    });
  } catch (...) {
    finished.save();
    throw;
  }

  // pictures: per scene the overview twice, then its maps
  std::vector<std::string> contents(files.size());
  std::vector<std::function<std::string()>> drawings;
  std::size_t map = 0;
  for (const MappedScene& place : places) {
    std::vector<const StabilityMap*> of_scene;
    for (const StepperInfo* method : place.methods) {
      maps[map].limit = limit_curve(place, *method);
      of_scene.push_back(&maps[map++]);
    }
    for (const PlotFormat format : {PlotFormat::png, PlotFormat::svg}) {
      drawings.emplace_back(
          [=, &place] { return plot_stability(of_scene, place.x, place.y, format); });
    }
    for (const StabilityMap* one : of_scene) {
      drawings.emplace_back(
          [=, &place] { return plot_stability({one}, place.x, place.y, PlotFormat::png); });
    }
  }
  parallel_for(static_cast<long>(drawings.size()), job.jobs, [&](long i) {
    contents[static_cast<std::size_t>(i) + 1] = drawings[static_cast<std::size_t>(i)]();
  });
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const MappedScene& place = *owners[i].first;
    const std::string table = stability_csv({maps[i]}, place.x, place.y);
    // one header for all
    contents[0] += i == 0 ? table : table.substr(table.find('\n') + 1);
  }
  folder.commit(contents);
  finished.remove();
  return summary(maps);
}

}  // namespace polhode
