// SPDX-License-Identifier: MIT
#include "app/commands/mapped_scene.h"

#include <cmath>

#include <fmt/format.h>

#include "app/commands/able_methods.h"
#include "app/commands/map_options.h"
#include "base/error.h"
#include "base/system/parallel.h"
#include "film/error_places.h"
#include "motion/scales.h"
#include "motion/solution_method.h"
#include "motion/step_limit.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

constexpr const char* kSpinKey = "spin";
constexpr double kMostStepsOfCell = 1e6;

// the scene with these values of the two keys, as a problem
StabilitySetup make_setup(const MappedScene& place, double x, double y, const StabilityJob& job) {
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
    State start = start_state(model, scene.motion);
    start.y *= spin;
    start.rings.rates *= spin;
    const double rate = typical_rate(model, start);
    if (rate <= 0.0)
      throw input_error("the body is at rest, so nothing can fail").at({{}, 0, "motion.spin"});
    const double duration = job.turns * 2.0 * kPi / rate;
    StabilitySetup setup;
    setup.step = step.value_or(scene.numerics.step.value_or(0.1 / rate));
    if (const double steps = duration / setup.step; !(steps <= kMostStepsOfCell)) {
      throw input_error(
          "a run would take {:.3g} steps of {:.3g} s, and a map has to do with {:.0e}; ask for "
          "fewer "
          "turns or longer steps",
          steps,
          setup.step,
          kMostStepsOfCell)
          .at({{}, 0, "--turns"});
    }
    setup.problem = std::make_unique<StabilityProblem>(model, start, duration);
    return setup;
  });
}

// the axis with its key; its range, unless given, a factor of ten to both sides of the scene's own
MapAxis make_axis(const MappedScene& place,
                  const std::vector<Setting>& settings,
                  const std::string& key,
                  const std::optional<std::string>& range,
                  const std::string& option,
                  double rate) {
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
    const BodyModel model = with_needed_degrees(make_model(place.scene.body, place.scene.motion));
    place.methods = able_methods(methods, job.methods, model, file.string());
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

void prepare_place(MappedScene& place, const StabilityJob& job) {
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
  const StabilitySetup& setup = place.setup(column, row);
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

}  // namespace polhode
