// SPDX-License-Identifier: MIT
// Measures work-precision points: cost and error of a method over a range of steps.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "chart/reference_solution.h"
#include "motion/stepper_table.h"

namespace polhode {

// One run of a method. Unknown numbers are NaN.
struct WorkPoint {
  std::string method;           // StepperInfo::name
  int order = 0;                // of the method
  double step = 0.0;            // s; for adaptive methods the tolerance (relative)
  long evaluations = 0;         // as counted by Work in motion/stepper.h; 0 if integrating failed
  double time_us = 0.0;         // microseconds for the whole motion, median of repeated runs
  double error_rad = 0.0;       // largest deviation() (motion/deviation.h) from the reference
  double energy_drift = 0.0;    // largest |Drift::energy| of the run (motion/trajectory.h)
  double momentum_drift = 0.0;  // largest Drift::momentum of the run
  // "ok"; "below_judge": the error is below ReferenceSolution::least_error(), so it is not known
  // exactly; "no_judge": there is no usable reference; "no_solution" (a step has no solution, or a
  // tolerance cannot be reached) or "not_a_number": the run failed.
  std::string status;
};

// The status of points with a known error, and of those with an error below the reference's own.
inline constexpr const char* kPointOk = "ok";
inline constexpr const char* kPointBelowReference = "below_judge";

// A motion to test methods on, from t = 0.
struct WorkProblem {
  BodyModel model;
  State start;
  double duration = 0.0;  // s, positive
};

// How long and how far to measure.
struct WorkOptions {
  double least_work_s = 5e-3;       // s; each point is timed at least this long in total
  double most_run_s = 0.05;         // s; no finer steps are tried once a run takes longer
  bool judge_the_end_only = false;  // true: error_rad is the deviation at the end only
  // called after each point, on the same thread; not empty
  std::function<void()> after_point = [] {
  };
};

// The points of a method, from steps that are too coarse to be useful down to steps where round-off
// dominates, a run takes longer than most_run_s, or 13 runs in a row have failed. The method must
// be able to integrate the model (why_not() in motion/stepper_table.h); `reference` must be that of
// `problem`. A run that fails is a point with its status, not an error. Throws Error (interrupted),
// and (input) as integrate_fixed and integrate_adaptive in motion/grid_trajectory.h do. The times
// are only right if nothing else uses the processor.
std::vector<WorkPoint> work_precision(const StepperInfo& method,
                                      const WorkProblem& problem,
                                      const ReferenceSolution& reference,
                                      const WorkOptions& options = {});

// The point with the least time_us among those with the status "ok" or "below_judge" and an error
// of at most `error_rad`; null if there is none, or if the reference cannot judge such errors. It
// points into `points`.
const WorkPoint* cheapest(const std::vector<WorkPoint>& points, double error_rad);

// The median time of one call of `run`, in microseconds, over at least three batches of calls that
// take at least `least_work_s` seconds in total; one call before them is not counted. Throws what
// `run` throws.
double median_time_us(const std::function<void()>& run, double least_work_s);

}  // namespace polhode
