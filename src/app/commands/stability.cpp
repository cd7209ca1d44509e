// SPDX-License-Identifier: MIT
#include "app/commands/stability.h"

#include <array>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "app/commands/mapped_scene.h"
#include "app/folder_work.h"
#include "base/error.h"
#include "base/system/output_folder.h"
#include "base/system/parallel.h"
#include "base/version.h"
#include "chart/plot_stability.h"
#include "scene/canonical.h"
#include "scene/key_path.h"

namespace polhode {
namespace {

constexpr const char* kKept = "stability.resume";  // finished rows, until all are there

// All maps of a job, and the files that come of them.
struct StabilityMaps {
  std::vector<StabilityMap> maps;
  std::vector<std::pair<const MappedScene*, const StepperInfo*>> owners;  // of each map
  std::vector<std::string> files;  // the table, then per scene the overview twice and its maps
};

// A row of a map, by the numbers of both.
using RowOfMap = std::pair<long, long>;

std::vector<MappedScene> make_places(const StabilityJob& job) {
  const std::vector<const StepperInfo*> methods = parse_methods(job.methods);
  if (without_suffixes(job.x) == without_suffixes(job.y)) {
    throw input_error("both directions are '{}'; take two different keys", job.x)
        .at({{}, 0, "--y"});
  }
  refuse_same_stem(job.scenes);
  std::vector<MappedScene> places;
  for (const std::filesystem::path& file : job.scenes)
    places.push_back(make_place(file, job, methods));
  return places;
}

StabilityMaps empty_maps(const std::vector<MappedScene>& places) {
  StabilityMaps all;
  all.files = {"stability.csv"};
  for (const MappedScene& place : places) {
    const std::string name = place.file.stem().string();
    all.files.push_back(fmt::format("stability_{}.png", name));
    all.files.push_back(fmt::format("stability_{}.svg", name));
    for (const StepperInfo* method : place.methods) {
      StabilityMap map;
      map.scene = name;
      map.title = place.scene.title.empty() ? name : place.scene.title;
      map.method = method->name;
      map.limit_words = method->limit;
      map.cells.resize(static_cast<std::size_t>(place.x.cells) *
                       static_cast<std::size_t>(place.y.cells));
      all.maps.push_back(std::move(map));
      all.owners.emplace_back(&place, method);
      all.files.push_back(fmt::format("stability_{}_{}.png", name, method->name));
    }
  }
  std::set<std::string> names;
  for (const std::string& file : all.files) {
    if (names.insert(file).second) continue;
    throw input_error(
        "two of the results would be called {}, one of a scene and one of a method; rename the "
        "scene",
        file);
  }
  return all;
}

// a finished row as a line of text
std::string line_of(const RowOfMap& which, const std::vector<StabilityCell>& cells, int columns) {
  std::string line = fmt::format("{} {}", which.first, which.second);
  for (int column = 0; column < columns; ++column) {
    const StabilityCell& cell = cells[static_cast<std::size_t>(which.second * columns + column)];
    fmt::format_to(std::back_inserter(line),
                   " {} {:.17g} {:.17g} {:.17g}",
                   name_of(cell.outcome),
                   cell.error_rad,
                   cell.energy_drift,
                   cell.momentum_drift);
  }
  return line;
}

// a number as line_of() writes it; absent: it is none
std::optional<double> number_of(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);  // NaN too, of cells without a number
  if (text.empty() || *end != '\0') return {};
  return value;
}

// puts the row of such a line into its map; absent: it is of no map, or is not ours
std::optional<RowOfMap> take_up(const std::string& line,
                                std::vector<StabilityMap>& maps,
                                int columns) {
  std::istringstream in(line);
  RowOfMap which(-1, -1);
  in >> which.first >> which.second;
  if (!in || which.first < 0 || which.first >= static_cast<long>(maps.size())) return {};
  std::vector<StabilityCell>& cells = maps[static_cast<std::size_t>(which.first)].cells;
  for (int column = 0; column < columns; ++column) {
    std::string outcome, error, energy, momentum;
    in >> outcome >> error >> energy >> momentum;
    const auto place = static_cast<std::size_t>(which.second * columns + column);
    if (!in || which.second < 0 || place >= cells.size()) return {};
    const std::optional<RunOutcome> ended = find_run_outcome(outcome);
    const std::optional<double> off = number_of(error), energy_drift = number_of(energy),
                                momentum_drift = number_of(momentum);
    if (!ended || !off || !energy_drift || !momentum_drift) return {};
    cells[place] = {*ended, *off, *energy_drift, *momentum_drift};
  }
  return which;
}

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

// the rows of all maps, one map after the other; the cells of each are made one by one
Piecewise rows_of(StabilityMaps& all, std::vector<MappedScene>& places, const StabilityJob& job) {
  const int columns = places[0].x.cells, rows = places[0].y.cells;
  const auto at = [rows](long piece) {
    return RowOfMap(piece / rows, piece % rows);
  };
  Piecewise work;
  work.pieces = static_cast<long>(all.maps.size()) * rows;
  work.things = "rows";
  // the methods have the motions of a row in common
  std::vector<long> scene_of_map;
  for (const auto& [place, method] : all.owners)
    scene_of_map.push_back(place - places.data());
  work.groups = static_cast<long>(places.size()) * rows;
  work.group_of = [scene_of_map, rows](long piece) {
    return scene_of_map[static_cast<std::size_t>(piece / rows)] * rows + piece % rows;
  };
  work.take_up = [&all, columns, rows](const std::string& line) -> std::optional<long> {
    const std::optional<RowOfMap> row = take_up(line, all.maps, columns);
    if (!row) return {};
    return row->first * rows + row->second;
  };
  work.prepare = [&all, &places, &job, at](const std::vector<long>& pieces) {
    std::map<const MappedScene*, std::set<int>> needed;
    for (const long piece : pieces) {
      const auto [map, row] = at(piece);
      needed[all.owners[static_cast<std::size_t>(map)].first].insert(static_cast<int>(row));
    }
    for (MappedScene& place : places) {
      const auto found = needed.find(&place);
      if (found != needed.end()) prepare_rows(place, job, found->second);
    }
  };
  work.make = [&all, &job, at, columns](long piece) {
    const auto [map, row] = at(piece);
    const auto& [place, method] = all.owners[static_cast<std::size_t>(map)];
    std::vector<StabilityCell>& cells = all.maps[static_cast<std::size_t>(map)].cells;
    for (int column = 0; column < columns; ++column) {
      cells[static_cast<std::size_t>(row * columns + column)] =
          try_cell(*place, *method, column, static_cast<int>(row), job.allowed_rad);
    }
  };
  work.line_of = [&all, at, columns](long piece) {
    const RowOfMap which = at(piece);
    return line_of(which, all.maps[static_cast<std::size_t>(which.first)].cells, columns);
  };
  return work;
}

// of a scene with these maps
std::vector<std::string> idle_axes_of(const MappedScene& place,
                                      const std::vector<const StabilityMap*>& maps) {
  const auto alike = [&](const StabilityCell& a, const StabilityCell& b) {
    return a.outcome == b.outcome && alike_but_for_rounding(a.error_rad, b.error_rad) &&
           alike_but_for_rounding(a.energy_drift, b.energy_drift) &&
           alike_but_for_rounding(a.momentum_drift, b.momentum_drift);
  };
  return idle_axes(place.x, place.y, [&](std::size_t a, std::size_t b) {
    return std::all_of(maps.begin(), maps.end(), [&](const StabilityMap* map) {
      return alike(map->cells[a], map->cells[b]);
    });
  });
}

// of all scenes
std::vector<std::string> idle_axes_of(const StabilityMaps& all,
                                      const std::vector<MappedScene>& places) {
  std::vector<std::string> found;
  for (const MappedScene& place : places) {
    std::vector<const StabilityMap*> of_scene;
    for (std::size_t i = 0; i < all.maps.size(); ++i) {
      if (all.owners[i].first == &place) of_scene.push_back(&all.maps[i]);
    }
    for (std::string& words : idle_axes_of(place, of_scene))
      found.push_back(std::move(words));
  }
  return found;
}

// of all files; pictures: per scene the overview twice, then its maps
std::vector<std::string> contents_of(StabilityMaps& all,
                                     const std::vector<MappedScene>& places,
                                     const StabilityJob& job) {
  std::vector<std::function<std::string()>> drawings;
  std::size_t map = 0;
  for (const MappedScene& place : places) {
    std::vector<const StabilityMap*> of_scene;
    for (std::vector<LimitPoint>& curve : limit_curves(place, job)) {
      all.maps[map].limit = std::move(curve);
      of_scene.push_back(&all.maps[map++]);
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
  std::vector<std::string> contents(all.files.size());
  parallel_for(static_cast<long>(drawings.size()), job.jobs, [&](long i) {
    contents[static_cast<std::size_t>(i) + 1] = drawings[static_cast<std::size_t>(i)]();
  });
  for (std::size_t i = 0; i < all.maps.size(); ++i) {
    const MappedScene& place = *all.owners[i].first;
    const std::string table = stability_csv({all.maps[i]}, place.x, place.y);
    // one header for all
    contents[0] += i == 0 ? table : table.substr(table.find('\n') + 1);
  }
  return contents;
}

// What is to be done, checked. Its address is part of its rows.
struct PlannedMaps {
  explicit PlannedMaps(const StabilityJob& job)
      : places(make_places(job)),
        all(empty_maps(places)),
        work{folder_or_default(job.output, job.scenes.front(), "stability"),
             all.files,
             kKept,
             words_of(places, job),
             rows_of(all, places, job)} {
    refuse_own_input(work, {job.scenes.begin(), job.scenes.end()});
  }
  PlannedMaps(const PlannedMaps&) = delete;
  PlannedMaps& operator=(const PlannedMaps&) = delete;

  std::vector<MappedScene> places;
  StabilityMaps all;
  FolderWork work;
};

}  // namespace

std::string stability(const StabilityJob& job) {
  PlannedMaps plan(job);
  // what the scene cannot be at a corner is told before anything is written
  for (const MappedScene& place : plan.places)
    check_corners(place, job);
  return make_folder_work(plan.work, job.part, job.jobs, job.progress, [&] {
    return FolderResult{contents_of(plan.all, plan.places, job),
                        summary(plan.all.maps),
                        idle_axes_of(plan.all, plan.places)};
  });
}

DividedWork divided_stability(const StabilityJob& job) {
  const double start_s = seconds_of([&] { PlannedMaps{job}; });
  const PlannedMaps plan(job);
  require_gnuplot();
  for (const MappedScene& place : plan.places)
    check_corners(place, job);
  DividedWork work = divided(plan.work);
  work.start_s = start_s;
  const int columns = plan.places[0].x.cells, rows = plan.places[0].y.cells;
  const auto maps = static_cast<long>(plan.all.maps.size());
  const double of_cell = mean_seconds([&](int k) {
    const auto& [place, method] = plan.all.owners[static_cast<std::size_t>(spread_over(k, maps))];
    try_cell_alone(*place,
                   *method,
                   static_cast<int>(spread_over(5 * k + 1, columns)),
                   static_cast<int>(spread_over(3 * k + 2, rows)),
                   job);
  });
  work.piece_s =
      of_cell * columns * static_cast<double>(maps) / static_cast<double>(plan.places.size());
  return work;
}

}  // namespace polhode
