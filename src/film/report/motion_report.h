// SPDX-License-Identifier: MIT
// The part of a film's report about its motion, and the versions that pixels depend on.
#pragma once

#include "film/report/json_fields.h"
#include "motion/simulate.h"

namespace polhode {

// Lists the keys of "conditioning", see Conditioning in motion/conditioning.h.
template <class Visitor>
void report_fields(Visitor& v, Conditioning& s) {
  v.field("round_off_rad", s.effect);
  v.field("exceeds_accuracy", s.exceeds_limit);
  v.field("exceeds_accuracy_at_s", s.exceeded_at);
}

// Lists the keys of the report about the motion; docs/render.md documents them.
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
  v.optional("conditioning", s.conditioning);
  v.field("energy_drift", s.record.drift.energy);
  v.field("momentum_drift", s.record.drift.momentum);
  v.field("attitude_error_rad", s.reliability.attitude_error_rad);
  v.derived("trusted", s.reliability.doubts.empty());
  v.field("doubts", s.reliability.doubts);
}

// The versions of what pixels and encoded bytes depend on, by name: polhode, compiler, eigen,
// ffmpeg.
Json versions();

}  // namespace polhode
