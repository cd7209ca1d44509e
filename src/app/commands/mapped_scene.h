// SPDX-License-Identifier: MIT
// One scene of `stability`: the axes of its maps, and a motion for each of their cells.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/commands/stability_job.h"
#include "chart/plot_stability.h"
#include "chart/stability.h"
#include "motion/stepper_table.h"
#include "scene/scene.h"

namespace polhode {

// The key of an axis along which steps change.
inline constexpr const char* kStepKey = "numerics.step";

// A motion that is ready to be tried, and the steps to try it with.
struct StabilitySetup {
  std::unique_ptr<StabilityProblem> problem;
  double step = 0.0;  // s, unless an axis says
};

// One scene with everything that its maps share.
struct MappedScene {
  std::filesystem::path file;
  Scene scene;
  MapAxis x, y;
  std::vector<StabilitySetup> setups;  // one per row, or one per cell
  std::vector<const StepperInfo*> methods;

  bool setup_per_cell() const { return x.key != kStepKey; }
  const StabilitySetup& setup(int column, int row) const {
    return setups[static_cast<std::size_t>(setup_per_cell() ? row * x.cells + column : row)];
  }
};

// The scene of that file, with its axes and those of `methods` that can take it. Throws Error
// (input) for axes that it cannot have, for a body at rest, and when no method can take it.
MappedScene make_place(const std::filesystem::path& file,
                       const StabilityJob& job,
                       const std::vector<const StepperInfo*>& methods);

// Makes its setups, on every processor. Throws Error as make_place does.
void prepare_place(MappedScene& place, const StabilityJob& job);

StabilityCell try_cell(
    const MappedScene& place, const StepperInfo& method, int column, int row, double allowed_rad);

// Where the method's limit of the step lies in a map whose columns are steps; else empty.
std::vector<LimitPoint> limit_curve(const MappedScene& place, const StepperInfo& method);

}  // namespace polhode
