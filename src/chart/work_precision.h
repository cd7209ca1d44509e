// SPDX-License-Identifier: MIT
// Speed against accuracy: what each method costs and how wrong it is, over a range of steps.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "chart/reference_solution.h"
#include "motion/stepper_table.h"

namespace polhode {

// One run of a method. Numbers that are not known are NaN.
struct WorkPoint {
  std::string method;
  int order = 0;
  double step = 0.0;  // s; the tolerance of adaptive methods
  long evaluations = 0;
  double time_us = 0.0;    // of the whole trajectory, median of repeated runs
  double error_rad = 0.0;  // largest over the motion, against the reference
  double energy_drift = 0.0;
  double momentum_drift = 0.0;
  // "ok"; "below_judge": the error is smaller than the uncertainty of the reference; "no_judge"; or
  // why there is no run: "no_solution", "not_a_number"
  std::string status;
};

inline constexpr const char* kPointOk = "ok";
inline constexpr const char* kPointBelowReference = "below_judge";

// A motion that methods are tried on.
struct WorkProblem {
  BodyModel model;
  State start;
  double duration = 0.0;  // s
};

struct WorkOptions {
  double least_work_s = 5e-3;       // timed per point
  double most_run_s = 0.05;         // finer steps than this long are not tried
  bool judge_the_end_only = false;  // not the whole motion: for runs that have nothing between
  std::function<void()> after_point = [] {
  };
};

// The points of a method from steps too long to be any use to steps that round-off makes pointless.
std::vector<WorkPoint> work_precision(const StepperInfo& method,
                                      const WorkProblem& problem,
                                      const ReferenceSolution& reference,
                                      const WorkOptions& options = {});

// The cheapest of the points whose error is known and at most `error_rad`; null if there is none.
const WorkPoint* cheapest(const std::vector<WorkPoint>& points, double error_rad);

// Median time of `run`, us, over at least `least_work_s` of running it.
double median_time_us(const std::function<void()>& run, double least_work_s);

}  // namespace polhode
