// SPDX-License-Identifier: MIT
// One scene of `stability`: the axes of its maps, and the motion of each cell.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <vector>

#include "app/commands/stability_job.h"
#include "chart/plot_stability.h"
#include "chart/stability.h"
#include "motion/stepper_table.h"
#include "scene/scene.h"

namespace polhode {

// The key of the axis along which the step (s) of the method changes.
inline constexpr const char* kStepKey = "numerics.step";

// A motion and the step to integrate it with.
struct StabilitySetup {
  std::unique_ptr<StabilityProblem> problem;  // not null after prepare_rows()
  // s; used if no axis gives the step: numerics.step of the scene, else 0.1 /
  // typical_rate() (motion/scales.h)
  double step = 0.0;
};

// A scene and what all its maps share. Immutable after prepare_rows(), so threads may share it.
struct MappedScene {
  std::filesystem::path file;
  Scene scene;                              // as in the file
  MapAxis x, y;                             // of the columns and of the rows of cells
  std::vector<StabilitySetup> setups;       // one per row, or one per cell, row by row
  std::vector<const StepperInfo*> methods;  // that can integrate the scene: rows of stepper_table()

  // Whether every cell has a motion of its own. If the step changes along x, all cells of a row
  // share one.
  bool setup_per_cell() const { return x.key != kStepKey; }
  // The motion of a cell; column and row count from 0. Call it after prepare_rows() for this row;
  // what it returns is valid as long as `setups` is not changed.
  const StabilitySetup& setup(int column, int row) const {
    return setups[static_cast<std::size_t>(setup_per_cell() ? row * x.cells + column : row)];
  }
};

// The scene of that file with the axes that the job asks for, and those of `methods` (at least one)
// that can integrate it; `setups` is still empty. Throws Error (input) as load_scene,
// number_in_scene (scene/scene.h), make_model and start_state (motion/motion.h) do, with --x, --y,
// --x-range, --y-range or --cells as key for an impossible axis, with motion.spin as key for a body
// at rest, and without a place if no method can integrate the scene.
MappedScene make_place(const std::filesystem::path& file,
                       const StabilityJob& job,
                       const std::vector<const StepperInfo*>& methods);

// Computes the setups of the cells of these rows, with their reference solutions, on job.jobs
// threads. Throws Error (input) as load_scene, make_model and start_state do for values along the
// axes that the scene cannot have, with motion.spin as key for a body at rest, and with --turns as
// key for runs of more than a million steps; (interrupted).
void prepare_rows(MappedScene& place, const StabilityJob& job, const std::set<int>& rows);

// Runs the method on one cell, see try_method() (chart/stability.h); column and row count from 0,
// allowed_rad is the allowed attitude error. Call it after prepare_rows() for its row. Thread-safe.
// Throws Error (interrupted) only.
StabilityCell try_cell(
    const MappedScene& place, const StepperInfo& method, int column, int row, double allowed_rad);

// The same for a single cell without any preparation, with its reference solution.
StabilityCell try_cell_alone(const MappedScene& place,
                             const StepperInfo& method,
                             int column,
                             int row,
                             const StabilityJob& job);

// Throws what prepare_rows() throws for the cells at the four corners.
void check_corners(const MappedScene& place, const StabilityJob& job);

// The step limits of the methods of the place, see step_limit() (motion/step_limit.h), as curves
// with one point per row, for maps whose x axis is the step; one for each of place.methods. Rows
// for which theory gives no limit have no point; for other maps the curves are empty. It needs no
// reference solutions. Throws as prepare_rows() does.
std::vector<std::vector<LimitPoint>> limit_curves(const MappedScene& place,
                                                  const StabilityJob& job);

}  // namespace polhode
