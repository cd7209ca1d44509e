// SPDX-License-Identifier: MIT
#include "app/commands/mapped_scene.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/commands/able_methods.h"
#include "base/error.h"
#include "base/numbers.h"
#include "base/system/parallel.h"
#include "film/error_places.h"
#include "motion/scales.h"
#include "motion/solution_method.h"
#include "motion/step_limit.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

constexpr const char* kSpinKey = "spin";
constexpr int kMostCells = 1024;  // in one direction
constexpr double kMostStepsOfCell = 1e6;

MapAxis parse_range(const std::string& text, const std::string& option) {
  MapAxis axis;
  const std::size_t colon = text.find(':');
  const auto number = [&](const std::string& part) {
    const std::optional<double> value = parse_number(part);
    if (!value) {
      throw input_error("'{}' is not a range; write two numbers, 0.1:10", text).at({{}, 0, option});
    }
    return *value;
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
  if (range) {
    axis = parse_range(*range, option + "-range");
  } else if (key == kStepKey) {
    axis.from = 0.1 / rate;
    axis.to = 10.0 / rate;
  } else if (key != kSpinKey) {
    const std::optional<double> own = number_in_scene(place.file, settings, key);
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
  const std::array<int, 2> cells = parse_cells(job.cells);
  place.x = make_axis(place, job.settings, job.x, job.x_range, "--x", rate);
  place.y = make_axis(place, job.settings, job.y, job.y_range, "--y", rate);
  place.x.cells = cells[0];
  place.y.cells = cells[1];
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
