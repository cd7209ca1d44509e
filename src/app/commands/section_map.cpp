// SPDX-License-Identifier: MIT
#include "app/commands/section_map.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "app/commands/map_options.h"
#include "base/error.h"
#include "base/system/kept_rows.h"
#include "base/system/output_folder.h"
#include "base/system/overwriting.h"
#include "base/system/parallel.h"
#include "base/version.h"
#include "chart/plot_exponents.h"
#include "film/error_places.h"
#include "film/overrides.h"
#include "motion/convoy.h"
#include "scene/canonical.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

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

// the motions of a row step together
void fill_row(const SectionJob& job, ExponentMap& map, int row) {
  std::vector<std::pair<BodyModel, State>> starts;
  for (int column = 0; column < map.x.cells; ++column)
    starts.push_back(start_of_cell(job, map, column, row));
  parallel_in_convoys(map.x.cells, 1, [&](long column) {
    const auto& [model, start] = starts[static_cast<std::size_t>(column)];
    const SectionOrbit orbit = trace_section(SectionSurface(model, start), start, job.crossings);
    map.at(static_cast<int>(column), row) = {
        orbit.verdict, orbit.exponent(), static_cast<int>(orbit.points.size())};
  });
}

// a row at a time on every processor; rows of an earlier run are taken up
void fill(const SectionJob& job, ExponentMap& map, KeptRows& kept) {
  std::set<int> done;
  kept.load([&](const std::string& line) {
    const std::optional<int> row = take_up_cells(line, map);
    if (row) done.insert(*row);
    return row.has_value();
  });
  std::vector<int> left;
  for (int row = 0; row < map.y.cells; ++row)
    if (!done.contains(row)) left.push_back(row);
  Progress progress(job.progress, map.y.cells, "rows", static_cast<int>(done.size()));
  std::mutex lock;
  int count = 0;
  try {
    parallel_for(static_cast<long>(left.size()), job.jobs, [&](long i) {
      const int row = left[static_cast<std::size_t>(i)];
      fill_row(job, map, row);
      const std::lock_guard guard(lock);
      kept.add(line_of_cells(row, map));
      progress.show(++count);
    });
  } catch (...) {
    kept.save();
    throw;
  }
}

// a section depends on body and motion alone, and not on how long the motion is shown
void refuse_other_axis(const std::string& key, const char* option) {
  const bool matters = key.starts_with("body.") || key.starts_with("motion.");
  if (matters && !key.starts_with("motion.duration")) return;
  throw input_error("a section does not depend on '{}'; give a key of [body] or [motion]", key)
      .at({{}, 0, option});
}

}  // namespace

std::string section_map(const SectionJob& job) {
  const SectionMapAxes& asked = job.map.value();
  if (asked.x == asked.y) throw input_error("is the key of --x; give another").at({{}, 0, "--y"});
  Overrides overrides;
  overrides.settings = job.settings;
  const Scene scene = load_single(job.scene, overrides);
  with_place(scene, [&] { return start_of_section(scene); });
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
  // what the scene cannot be at a corner is told before anything is written
  for (const int column : {0, count.columns - 1}) {
    for (const int row : {0, count.rows - 1})
      start_of_cell(job, map, column, row);
  }
  require_gnuplot();

  const std::filesystem::path where = folder_or_default(job.output, job.scene, "section");
  const std::vector<std::string> names = {"section_map.csv", "section_map.png"};
  refuse_same_files(where, names, input_files(scene));
  refuse_same_files(where, {"section_map.resume"}, input_files(scene));
  OutputFolder folder(where, names);
  std::string words =
      fmt::format("polhode {} {} {}", program_version(), scene_hash(scene), job.crossings);
  for (const MapAxis& axis : {map.x, map.y})
    words += fmt::format(" {} {:.17g} {:.17g} {}", axis.key, axis.from, axis.to, axis.cells);
  KeptRows kept(where / "section_map.resume", words);
  fill(job, map, kept);
  folder.commit({exponents_csv(map), plot_exponents(map, PlotFormat::png)});
  kept.remove();

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

}  // namespace polhode
