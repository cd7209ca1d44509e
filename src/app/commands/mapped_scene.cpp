// SPDX-License-Identifier: MIT
#include "app/commands/mapped_scene.h"

#include <cmath>

#include <fmt/format.h>

#include "app/commands/able_methods.h"
#include "app/commands/map_options.h"
#include "base/error.h"
#include "base/system/parallel.h"
#include "film/error_places.h"
#include "film/overrides.h"
#include "motion/scales.h"
#include "motion/solution_method.h"
#include "motion/step_limit.h"
#include "scene/key_path.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

constexpr const char* kSpinKey = "spin";
constexpr double kMostStepsOfCell = 1e6;

// The scene with these values of the two keys, before anything is integrated.
struct Begun {
  BodyModel model;
  State start;
  double duration = 0.0;  // s
  double step = 0.0;      // s
};

Begun begin_cell(const MappedScene& place, double x, double y, const StabilityJob& job) {
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
  const Scene scene = load_scene(place.file, job.settings, numbers);
  return with_place(scene, [&] {
    const BodyModel model = with_needed_degrees(make_model(scene.body, scene.motion));
    const State start = start_state(model, scene.motion, spin);
    const double rate = typical_rate(model, start);
    if (rate <= 0.0)
      throw input_error("the body is at rest, so nothing can fail").at({{}, 0, "motion.spin"});
    if (!std::isfinite(rate * rate) || !std::isfinite(start.y.squaredNorm())) {
      throw input_error("with {:g} times the spin, squares of rates are beyond what numbers hold",
                        spin)
          .at({{}, 0, place.y.key == kSpinKey ? "--y-range" : "--x-range"});
    }
    const double duration = job.turns * 2.0 * kPi / rate;
    const double h = step.value_or(scene.numerics.step.value_or(0.1 / rate));
    if (const double steps = duration / h; !(steps <= kMostStepsOfCell)) {
      throw input_error(
          "a run would take {:.3g} steps of {:.3g} s, and a map has to do with {:.0e}; ask for "
          "fewer turns or longer steps",
          steps,
          h,
          kMostStepsOfCell)
          .at({{}, 0, "--turns"});
    }
    return Begun{model, start, duration, h};
  });
}

// that of an axis, if one gives it
double step_of_cell(const MappedScene& place, int column, int row, double otherwise) {
  if (place.y.key == kStepKey) return place.y.at(row);
  return place.x.key == kStepKey ? place.x.at(column) : otherwise;
}

// the axis with its key; its range, unless given, a factor of ten to both sides of the scene's own
MapAxis make_axis(const MappedScene& place,
                  const std::vector<Setting>& settings,
                  const std::string& key,
                  const std::optional<std::string>& range,
                  const std::string& option,
                  double rate) {
  const auto refuse = [&](const char* why) {
    throw input_error("changes nothing: {}", why).at({{}, 0, fmt::format("{} {}", option, key)});
  };
  if (key == "motion.duration") refuse("--turns says how long each run is");
  if (key != kStepKey && without_suffixes(key) == kStepKey) {
    throw input_error("steps are in seconds here; give {}", kStepKey)
        .at({{}, 0, fmt::format("{} {}", option, key)});
  }
  if (key != kSpinKey && key != kStepKey && !changes_motion(key))
    refuse("runs depend on spin, numerics.step and the keys of [body] and [motion]");
  MapAxis axis;
  if (range || (key != kStepKey && key != kSpinKey)) {
    axis = axis_of_key(place.file, settings, key, range, option);
  } else if (key == kStepKey) {
    axis.from = 0.1 / rate;
    axis.to = 10.0 / rate;
  }
  if ((key == kStepKey || key == kSpinKey) && axis.from <= 0.0) {
    throw input_error("{} must be greater than 0", key).at({{}, 0, option + "-range"});
  }
  axis.key = key;
  return axis;
}

}  // namespace

MappedScene make_place(const std::filesystem::path& file,
                       const StabilityJob& job,
                       const std::vector<const StepperInfo*>& methods) {
  MappedScene place;
  place.file = file;
  place.scene = load_scene(file, job.settings);
  refuse_panels(place.scene);
  const double rate = with_place(place.scene, [&] {
    std::vector<std::string> used = {"numerics.step"};
    if (job.x == used.front() || job.y == used.front()) used.clear();  // the map changes it
    refuse_numerics(place.scene, "for maps of stability", used);
    refuse_given(
        place.scene, "motion.duration", "is not for maps of stability, whose runs last --turns");
    refuse_given(
        place.scene, "motion.ensemble", "is not for maps of stability, which are of one motion");
    const BodyModel model = with_needed_degrees(make_model(place.scene.body, place.scene.motion));
    place.methods =
        able_methods(methods, job.methods, model, file.string(), why_not_by_fixed_steps);
    const double found = typical_rate(model, start_state(model, place.scene.motion));
    if (found <= 0.0)
      throw input_error("the body is at rest, so nothing can fail").at({{}, 0, "motion.spin"});
    return found;
  });
  const auto [columns, rows] = parse_cells(job.cells);
  place.x = make_axis(place, job.settings, job.x, job.x_range, "--x", rate);
  place.y = make_axis(place, job.settings, job.y, job.y_range, "--y", rate);
  place.x.cells = columns;
  place.y.cells = rows;
  return place;
}

void prepare_rows(MappedScene& place, const StabilityJob& job, const std::set<int>& rows) {
  const int columns = place.setup_per_cell() ? place.x.cells : 1;
  place.setups.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(place.y.cells));
  const std::vector<int> wanted(rows.begin(), rows.end());
  parallel_for(columns * static_cast<long>(wanted.size()), job.jobs, [&](long i) {
    const int column = static_cast<int>(i % columns);
    const int row = wanted[static_cast<std::size_t>(i / columns)];
    const Begun begun = begin_cell(place, place.x.at(column), place.y.at(row), job);
    StabilitySetup& setup =
        place.setups[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column)];
    setup.problem = std::make_unique<StabilityProblem>(begun.model, begun.start, begun.duration);
    setup.step = begun.step;
  });
}

StabilityCell try_cell(
    const MappedScene& place, const StepperInfo& method, int column, int row, double allowed_rad) {
  const StabilitySetup& setup = place.setup(column, row);
  return try_method(
      method, *setup.problem, step_of_cell(place, column, row, setup.step), allowed_rad);
}

StabilityCell try_cell_alone(const MappedScene& place,
                             const StepperInfo& method,
                             int column,
                             int row,
                             const StabilityJob& job) {
  const Begun begun = begin_cell(place, place.x.at(column), place.y.at(row), job);
  const StabilityProblem problem(begun.model, begun.start, begun.duration);
  return try_method(method, problem, step_of_cell(place, column, row, begun.step), job.allowed_rad);
}

void check_corners(const MappedScene& place, const StabilityJob& job) {
  for (const double x : {place.x.from, place.x.to}) {
    for (const double y : {place.y.from, place.y.to})
      begin_cell(place, x, y, job);
  }
}

std::vector<std::vector<LimitPoint>> limit_curves(const MappedScene& place,
                                                  const StabilityJob& job) {
  std::vector<std::vector<LimitPoint>> curves(place.methods.size());
  if (place.x.key != kStepKey) return curves;
  for (int row = 0; row < place.y.cells; ++row) {
    const Begun begun = begin_cell(place, place.x.at(0), place.y.at(row), job);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const double h = step_limit(*place.methods[i], begun.model, begun.start);
      if (std::isfinite(h)) curves[i].push_back({h, place.y.at(row)});
    }
  }
  return curves;
}

}  // namespace polhode
