// SPDX-License-Identifier: MIT
#include "app/commands/section_map.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "app/commands/map_options.h"
#include "app/folder_work.h"
#include "base/error.h"
#include "base/system/output_folder.h"
#include "base/version.h"
#include "chart/plot_exponents.h"
#include "film/error_places.h"
#include "film/overrides.h"
#include "motion/convoy.h"
#include "scene/canonical.h"
#include "scene/key_path.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

const std::vector<std::string> kMapFiles = {"section_map.csv", "section_map.png"};
constexpr const char* kKeptCells = "section_map.resume";  // until all are there

// a row of cells as a line of text
std::string line_of_cells(int row, const ExponentMap& map) {
  std::string line = std::to_string(row);
  for (int column = 0; column < map.x.cells; ++column) {
    const ExponentCell& cell = map.at(column, row);
    fmt::format_to(std::back_inserter(line),
                   " {} {:.17g} {}",
                   static_cast<int>(cell.verdict),
                   cell.exponent,
                   cell.crossings);
  }
  return line;
}

// puts such a line into the map; absent: it is of another map
std::optional<int> take_up_cells(const std::string& line, ExponentMap& map) {
  std::istringstream in(line);
  int row = -1;
  in >> row;
  if (!in || row < 0 || row >= map.y.cells) return {};
  for (int column = 0; column < map.x.cells; ++column) {
    int verdict = -1;
    ExponentCell cell;
    in >> verdict >> cell.exponent >> cell.crossings;
    if (!in || verdict < 0 || verdict > static_cast<int>(SectionVerdict::chaotic)) return {};
    cell.verdict = static_cast<SectionVerdict>(verdict);
    map.at(column, row) = cell;
  }
  return row;
}

std::pair<BodyModel, State> start_of_cell(const SectionJob& job,
                                          const ExponentMap& map,
                                          int column,
                                          int row) {
  const Scene scene =
      load_scene(job.scene,
                 job.settings,
                 Replacements{{map.x.key, map.x.at(column)}, {map.y.key, map.y.at(row)}});
  return with_place(scene, [&] { return start_of_section(scene); });
}

ExponentCell cell_of(const SectionJob& job, const std::pair<BodyModel, State>& from) {
  const auto& [model, start] = from;
  const SectionOrbit orbit = trace_section(SectionSurface(model, start), start, job.crossings);
  return {orbit.verdict, orbit.exponent(), static_cast<int>(orbit.points.size())};
}

// the motions of a row step together
void fill_row(const SectionJob& job, ExponentMap& map, int row) {
  std::vector<std::pair<BodyModel, State>> starts;
  starts.reserve(static_cast<std::size_t>(map.x.cells));
  for (int column = 0; column < map.x.cells; ++column)
    starts.push_back(start_of_cell(job, map, column, row));
  parallel_in_convoys(map.x.cells, 1, [&](long column) {
    map.at(static_cast<int>(column), row) = cell_of(job, starts[static_cast<std::size_t>(column)]);
  });
}

Piecewise rows_of_map(const SectionJob& job, ExponentMap& map) {
  Piecewise work;
  work.pieces = map.y.cells;
  work.things = "rows";
  work.take_up = [&map](const std::string& line) -> std::optional<long> {
    return take_up_cells(line, map);
  };
  work.make = [&job, &map](long row) {
    fill_row(job, map, static_cast<int>(row));
  };
  work.line_of = [&map](long row) {
    return line_of_cells(static_cast<int>(row), map);
  };
  return work;
}

// a section depends on body and motion alone, and not on how long the motion is shown
void refuse_other_axis(const std::string& key, const char* option) {
  if (changes_motion(key)) return;
  throw input_error("a section does not depend on '{}'; give a key of [body] or [motion]", key)
      .at({{}, 0, option});
}

// the map, empty, of axes that suit the scene
ExponentMap empty_map(const SectionJob& job, const Scene& scene) {
  const SectionMapAxes& asked = job.map.value();
  const CellCount count = parse_cells(asked.cells);
  constexpr double kMostOfAll = 1e7;
  if (static_cast<double>(count.columns) * count.rows * job.crossings > kMostOfAll) {
    throw input_error("{} cells with {} crossings each are more than {:g} in all",
                      count.columns * count.rows,
                      job.crossings,
                      kMostOfAll)
        .at({{}, 0, "--cells"});
  }
  refuse_other_axis(asked.x, "--x");
  refuse_other_axis(asked.y, "--y");
  ExponentMap map;
  map.title = scene.title.empty() ? job.scene.stem().string() : scene.title;
  map.x = axis_of_key(job.scene, job.settings, asked.x, asked.x_range, "--x");
  map.y = axis_of_key(job.scene, job.settings, asked.y, asked.y_range, "--y");
  map.x.cells = count.columns;
  map.y.cells = count.rows;
  map.cells.resize(static_cast<std::size_t>(count.columns) * static_cast<std::size_t>(count.rows));
  return map;
}

// everything that a cell depends on
std::string words_of_map(const SectionJob& job, const Scene& scene, const ExponentMap& map) {
  std::string words =
      fmt::format("polhode {} {} {}", program_version(), scene_hash(scene), job.crossings);
  for (const MapAxis& axis : {map.x, map.y})
    words += fmt::format(" {} {:.17g} {:.17g} {}", axis.key, axis.from, axis.to, axis.cells);
  return words;
}

std::vector<std::string> idle_axes_of(const ExponentMap& map) {
  return idle_axes(map.x, map.y, [&](std::size_t a, std::size_t b) {
    const ExponentCell &one = map.cells[a], &other = map.cells[b];
    return one.verdict == other.verdict && one.crossings == other.crossings &&
           alike_but_for_rounding(one.exponent, other.exponent);
  });
}

std::string summary_of_map(const ExponentMap& map) {
  const auto with = [&](SectionVerdict verdict) {
    return std::count_if(map.cells.begin(), map.cells.end(), [&](const ExponentCell& cell) {
      return cell.verdict == verdict;
    });
  };
  return fmt::format("{} motions: {} regular, {} chaotic, {} undecided\n",
                     map.cells.size(),
                     with(SectionVerdict::regular),
                     with(SectionVerdict::chaotic),
                     with(SectionVerdict::undecided));
}

// What is to be done, checked. Its address is part of its rows.
struct PlannedExponents {
  explicit PlannedExponents(const SectionJob& job)
      : work{folder_or_default(job.output, job.scene, "section"), kMapFiles, kKeptCells, {}, {}} {
    const SectionMapAxes& asked = job.map.value();
    if (without_suffixes(asked.x) == without_suffixes(asked.y))
      throw input_error("is the key of --x; give another").at({{}, 0, "--y"});
    Overrides overrides;
    overrides.settings = job.settings;
    const Scene scene = load_single(job.scene, overrides);
    with_place(scene, [&] { return start_of_section(scene); });
    map = empty_map(job, scene);
    // what the scene cannot be at a corner is told before anything is written
    for (const int column : {0, map.x.cells - 1}) {
      for (const int row : {0, map.y.cells - 1})
        start_of_cell(job, map, column, row);
    }
    refuse_own_input(work, input_files(scene));
    work.words = words_of_map(job, scene, map);
    work.pieces = rows_of_map(job, map);
  }
  PlannedExponents(const PlannedExponents&) = delete;
  PlannedExponents& operator=(const PlannedExponents&) = delete;

  FolderWork work;
  ExponentMap map;
};

}  // namespace

std::string section_map(const SectionJob& job) {
  PlannedExponents plan(job);
  return make_folder_work(plan.work, job.part, job.jobs, job.progress, [&] {
    return FolderResult{{exponents_csv(plan.map), plot_exponents(plan.map, PlotFormat::png)},
                        summary_of_map(plan.map),
                        idle_axes_of(plan.map)};
  });
}

DividedWork divided_section_map(const SectionJob& job) {
  require_gnuplot();
  const double start_s = seconds_of([&] { PlannedExponents{job}; });
  const PlannedExponents plan(job);
  DividedWork work = divided(plan.work);
  work.start_s = start_s;
  SectionJob few = job;
  few.crossings = std::min(job.crossings, kSampledCrossings);
  const double of_cell = mean_seconds([&](int k) {
    cell_of(few,
            start_of_cell(few,
                          plan.map,
                          static_cast<int>(spread_over(k, plan.map.x.cells)),
                          static_cast<int>(spread_over(3 * k + 1, plan.map.y.cells))));
  });
  work.piece_s = of_cell * plan.map.x.cells * job.crossings / few.crossings;
  return work;
}

}  // namespace polhode
