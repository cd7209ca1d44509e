// SPDX-License-Identifier: MIT
// How a motion was found, and the versions of what pixels depend on: part of every report.
#pragma once

#include "film/json_fields.h"
#include "motion/simulate.h"

namespace polhode {

// Keys: docs/render.md.
template <class Visitor>
void report_fields(Visitor& v, SimulationReport& s) {
  v.field("model", s.model);
  v.field("model_reason", s.model_reason);
  v.field("method", s.method);
  v.field("method_reason", s.method_reason);
  v.field("step_s", s.step);
  v.field("tolerance", s.tolerance);
  v.field("steps", s.record.steps);
  v.field("rejected_steps", s.record.rejected);
  v.field("evaluations", s.record.evaluations);
  v.field("accuracy_rad", s.accuracy_rad);
  v.field("error_estimate_rad", s.error_estimate_rad);
  v.field("energy_drift", s.record.drift.energy);
  v.field("momentum_drift", s.record.drift.momentum);
  v.field("attitude_error_rad", s.reliability.attitude_error_rad);
  v.derived("trusted", s.reliability.doubts.empty());
  v.field("doubts", s.reliability.doubts);
}

// Versions of the program and of the libraries that pixels and bytes depend on.
Json versions();

}  // namespace polhode
