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
  std::string method;
  int order = 0;
  double step = 0.0;  // s; for adaptive methods the tolerance
  long evaluations = 0;
  double time_us = 0.0;         // for the whole trajectory, median of repeated runs
  double error_rad = 0.0;       // largest deviation from the reference
  double energy_drift = 0.0;    // relative as in motion/trajectory.h
  double momentum_drift = 0.0;  // the same
  // "ok"; "below_judge": the error is below ReferenceSolution::least_error(); "no_judge": there is
  // no usable reference; "no_solution" or "not_a_number": why the run failed.
  std::string status;
};

inline constexpr const char* kPointOk = "ok";
inline constexpr const char* kPointBelowReference = "below_judge";

// A motion to test methods on.
struct WorkProblem {
  BodyModel model;
  State start;
  double duration = 0.0;  // s
};

// How long and how far to measure.
struct WorkOptions {
  double least_work_s = 5e-3;       // least time measured per point, s
  double most_run_s = 0.05;         // s; refinement ends when a run takes longer
  bool judge_the_end_only = false;  // compare the last state only
  // called after each point, for progress
  std::function<void()> after_point = [] {
  };
};

// The points of a method, from steps that are too coarse to be useful down to steps where round-off
// dominates. Throws Error (interrupted), and (input) as the integrations do.
std::vector<WorkPoint> work_precision(const StepperInfo& method,
                                      const WorkProblem& problem,
                                      const ReferenceSolution& reference,
                                      const WorkOptions& options = {});

// The fastest of the points with a known error of at most `error_rad`; null if there is none.
const WorkPoint* cheapest(const std::vector<WorkPoint>& points, double error_rad);

// The median time of one call of `run`, us. It is repeated for at least `least_work_s` seconds.
double median_time_us(const std::function<void()>& run, double least_work_s);

}  // namespace polhode
