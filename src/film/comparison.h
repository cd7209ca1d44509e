// SPDX-License-Identifier: MIT
// Films that show several methods on one scene side by side.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "film/json_fields.h"
#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// One method of numerics.compare on the scene, as far as it came.
struct Contender {
  std::string method;
  SimulationReport report;
  Motion motion;
  double end = 0.0;                      // s: behind this there is no motion
  std::string failure;                   // why it ended there; empty: it came through
  std::optional<double> untrusted_from;  // s: first frame at which its error passes what is allowed
};

// All of them, held against `truth` at every frame_s seconds. Throws Error (input) with file and
// line for a method that cannot take the scene.
class Comparison {
 public:
  Comparison(const Solved& truth, double frame_s);

  const std::vector<Contender>& contenders() const { return contenders_; }
  // How far a contender is off at t.
  std::optional<double> attitude_error(const Contender& one, double t) const;
  PanelNotes notes(const Contender& one, double t) const;
  // As many lines as notes() has, the stamp counted.
  static constexpr int kNoteLines = 5;
  // For the report of a film.
  Json report() const;

 private:
  // start: a motion that begins as all of them do
  Contender run(const Scene& scene,
                const BodyModel& model,
                const Motion& start,
                const std::string& method) const;
  std::optional<double> first_error(const Contender& one, double frame_s) const;

  double allowed_rad_;
  std::optional<Motion> truth_;  // none when nobody knows it
  std::vector<Contender> contenders_;
};

}  // namespace polhode
