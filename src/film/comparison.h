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
  std::string method;
  SimulationReport report;
  Motion motion;
  double end = 0.0;     // s: end of the motion; the whole duration unless the method failed
  std::string failure;  // why it failed; empty: it did not
  // s: time of the first frame whose error exceeds the allowed one
  std::optional<double> untrusted_from;
};

// All methods of numerics.compare, compared with `truth` every frame_s (s of motion). Immutable, so
// any thread may use it.
class Comparison {
 public:
  // Throws Error (input), with the line of numerics.compare, for a method that cannot handle the
  // scene. A run that fails is not an error, see Contender::failure.
  Comparison(const Solved& truth, double frame_s);

  const std::vector<Contender>& contenders() const { return contenders_; }
  // The attitude error of a contender at t (s), rad; absent without a reference motion.
  std::optional<double> attitude_error(const Contender& one, double t) const;
  // The notes in its panel at t (s).
  PanelNotes notes(const Contender& one, double t) const;
  // The number of lines of notes(), including the stamp.
  static constexpr int kNoteLines = 5;
  // The value of "compare" in the report of a film: one row per method.
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
