// SPDX-License-Identifier: MIT
// Runs several methods on one scene, for films that show them side by side.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "film/report/json_fields.h"
#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// The run of one method of numerics.compare.
struct Contender {
  std::string method;  // as in numerics.compare, one of method_names()
  // of the run until `end`, with a doubt if it failed; if the first step did: method, step and
  // tolerance only
  SimulationReport report;
  Motion motion;        // stands still after `end`
  double end = 0.0;     // s of motion: how far the method came; the whole duration unless it failed
  std::string failure;  // why it failed; empty: it did not
  // s of motion: the first frame with an attitude error over the allowed one or, without a
  // reference motion, with a drift over kTrustedDrift (motion/reliability.h); absent: there is none
  std::optional<double> untrusted_from;
};

// The runs of all methods of numerics.compare, and the reference motion that they are compared
// with: the closed form or, if there is none, a run with a thousandth of the allowed error, but not
// less than 1e-12 rad. Immutable, so any thread may use it.
class Comparison {
 public:
  // Computes all runs. `truth` is the solved scene and is not kept; frame_s is the time between
  // frames, s of motion, positive. Throws Error (input), with the line of numerics.compare, for a
  // method that cannot handle the scene, its step, tolerance or accuracy, with that of
  // numerics.step or numerics.tolerance if no method takes one, and (interrupted). A run
  // that fails (check_failed) is not an error, see Contender::failure.
  Comparison(const Solved& truth, double frame_s);

  // In the order of numerics.compare; valid as long as this object.
  const std::vector<Contender>& contenders() const { return contenders_; }
  // The attitude error of a contender at t (s of motion), rad; for later t, that at its end. Absent
  // without a reference motion. Throws Error (check_failed) as Motion::at does.
  std::optional<double> attitude_error(const Contender& one, double t) const;
  // The notes in the panel of a contender at t (s of motion): method, attitude error and drift of
  // energy, and a stamp from when the motion has ended or cannot be trusted; with_details adds step
  // or tolerance and small numbers. Throws Error likewise.
  PanelNotes notes(const Contender& one, double t, bool with_details) const;
  // What notes() may have.
  static NoteRows note_rows(bool with_details) { return {true, true, true, with_details ? 2 : 0}; }
  // The value of "compare" in the report of a film: a list with one object per method, which has
  // the keys of its SimulationReport (film/report/motion_report.h) and end_s, failure,
  // untrusted_from_s and attitude_error_at_end_rad, the last two null where absent.
  Json report() const;

 private:
  // start: any motion of the scene; a run that fails at once shows its start
  Contender run(const Scene& scene,
                const BodyModel& model,
                const Motion& start,
                const std::string& method) const;
  std::optional<double> first_error(const Contender& one, double frame_s) const;

  double allowed_rad_;
  std::optional<Motion> truth_;  // reference motion; absent if none could be computed
  std::vector<Contender> contenders_;
};

}  // namespace polhode
