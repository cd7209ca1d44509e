// SPDX-License-Identifier: MIT
// One scene of `stability`: the axes of its maps, and the motion of each cell.
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

// The key of an axis along which the step changes.
inline constexpr const char* kStepKey = "numerics.step";

// A motion and the step to integrate it with.
struct StabilitySetup {
  std::unique_ptr<StabilityProblem> problem;
  double step = 0.0;  // s; used if no axis gives the step
};

// A scene and what all its maps share. Immutable after prepare_place(), so threads may share it.
struct MappedScene {
  std::filesystem::path file;
  Scene scene;
  MapAxis x, y;
  std::vector<StabilitySetup> setups;  // one per row, or one per cell
  std::vector<const StepperInfo*> methods;

  // Whether every cell has a motion of its own; else a row has one.
  bool setup_per_cell() const { return x.key != kStepKey; }
  // The motion of a cell. Valid after prepare_place().
  const StabilitySetup& setup(int column, int row) const {
    return setups[static_cast<std::size_t>(setup_per_cell() ? row * x.cells + column : row)];
  }
};

// The scene of that file with its axes, and those of `methods` that can integrate it. Throws Error
// (input) as load_scene does, naming --x, --y, --x-range, --y-range or --cells for an impossible
// axis, motion.spin for a body at rest, and without a key if no method can integrate it.
MappedScene make_place(const std::filesystem::path& file,
                       const StabilityJob& job,
                       const std::vector<const StepperInfo*>& methods);

// Computes the setups of all cells, in parallel. Throws Error as make_place does, and
// (interrupted).
void prepare_place(MappedScene& place, const StabilityJob& job);

// Runs one cell, see try_method(). Thread-safe.
StabilityCell try_cell(
    const MappedScene& place, const StepperInfo& method, int column, int row, double allowed_rad);

// The method's step limit as a curve, for maps whose x axis is the step; else empty.
std::vector<LimitPoint> limit_curve(const MappedScene& place, const StepperInfo& method);

}  // namespace polhode
