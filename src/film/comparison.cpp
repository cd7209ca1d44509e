// SPDX-License-Identifier: MIT
#include "film/comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/units.h"
#include "film/error_places.h"
#include "film/report/motion_report.h"
#include "math/so3.h"
#include "motion/stepper_table.h"

namespace polhode {
namespace {

constexpr double kFinerTruth = 1e-3;  // of what the scene allows, where there is no closed form
constexpr int kHalvings = 40;         // of the time in which a method fails

// the motion of a scene by one method with the scene's step or tolerance
Simulation simulate_by(const Scene& scene,
                       const BodyModel& model,
                       const std::string& method,
                       double duration,
                       double allowed_rad) {
  MotionSpec motion = scene.motion;
  motion.duration = duration;
  NumericsSpec numerics = scene.numerics;
  numerics.method = method;
  const bool steps = method != "exact" && method != "auto";
  const bool adaptive = steps && find_stepper(method).adaptive;
  if (!steps || adaptive) numerics.step.reset();
  if (!steps || !adaptive) numerics.tolerance.reset();
  return simulate(model, motion, numerics, allowed_rad);
}

// what the panels are held against: the closed form, else a much finer run; none if that fails
std::optional<Motion> truth_of(const Solved& solved) {
  const Simulation& found = solved.simulation;
  if (found.report.method == "exact") return found.motion;
  try {
    return simulate(solved.model,
                    solved.scene.motion,
                    NumericsSpec{},
                    std::max(1e-12, kFinerTruth * found.report.accuracy_rad))
        .motion;
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    return {};
  }
}

// A motion up to where its method came; behind that it stands still.
class Held final : public Trajectory {
 public:
  Held(const Motion& motion, double end) : motion_(motion), end_(end) {}
  State at(double t) const override { return motion_.state_at(std::min(t, end_)); }

 private:
  Motion motion_;
  double end_;
};

Motion held(const Motion& motion, double end, const MotionSpec& spec) {
  return {motion.model(), std::make_shared<const Held>(motion, end), spec};
}

// "+12.3 %", "-3e-12"
std::string relative(double value) {
  if (value == 0.0) return "+0";
  if (std::abs(value) < 1e-3) return fmt::format("{:+.0e}", value);
  return std::abs(value) < 10.0 ? fmt::format("{:+.3g} %", 100.0 * value)
                                : fmt::format("{:+.0e} times", value);
}

std::string angle(double rad) {
  if (rad == 0.0) return "0";
  const double degrees = rad * 180.0 / kPi;
  return degrees < 0.1 ? fmt::format("{:.0e} rad", rad) : fmt::format("{:.1f}°", degrees);
}

std::string title_of(const std::string& method) {
  return method == "exact" ? "Closed form" : find_stepper(method).title;
}

}  // namespace

Comparison::Comparison(const Solved& truth, double frame_s)
    : allowed_rad_(truth.simulation.report.accuracy_rad), truth_(truth_of(truth)) {
  const Scene& scene = truth.scene;
  const BodyModel model = make_model(scene.body, scene.motion);
  for (std::size_t i = 0; i < scene.numerics.compare.size(); ++i) {
    try {
      contenders_.push_back(run(scene, model, truth.simulation.motion, scene.numerics.compare[i]));
    } catch (const Error& error) {
      const Error found(error.fault(), error.message());
      throw placed(scene, found.at({{}, 0, fmt::format("numerics.compare[{}]", i)}));
    }
    contenders_.back().untrusted_from = first_error(contenders_.back(), frame_s);
  }
}

Contender Comparison::run(const Scene& scene,
                          const BodyModel& model,
                          const Motion& start,
                          const std::string& method) const {
  const double whole = scene.motion.duration;
  try {
    Simulation found = simulate_by(scene, model, method, whole, allowed_rad_);
    return {method, found.report, found.motion, whole, {}, {}};
  } catch (const Error& error) {
    if (error.fault() != Fault::check_failed) throw;
    // it fails: how far does it come?
    double comes = 0.0;
    double fails = whole;
    std::optional<Simulation> found;
    for (int i = 0; i < kHalvings && (fails - comes) > 1e-9 * whole; ++i) {
      const double middle = 0.5 * (comes + fails);
      try {
        found = simulate_by(scene, model, method, middle, allowed_rad_);
        comes = middle;
      } catch (const Error& again) {
        if (again.fault() != Fault::check_failed) throw;
        fails = middle;
      }
    }
    // not even one step: the panel shows the start
    if (!found) {
      SimulationReport report;
      report.method = method;
      report.step = scene.numerics.step;
      return {method, report, held(start, 0.0, scene.motion), 0.0, error.message(), {}};
    }
    // the last whole step: the partial one behind it is part of what fails
    const double h = found->report.step.value_or(0.0);
    const double end = h > 0.0 ? std::floor(comes / h * (1.0 + 1e-12)) * h : comes;
    return {
        method, found->report, held(found->motion, end, scene.motion), end, error.message(), {}};
  }
}

std::optional<double> Comparison::attitude_error(const Contender& one, double t) const {
  if (!truth_) return {};
  const double known = std::min(t, one.end);
  return rotation_angle_between(one.motion.at(known).q_SB, truth_->at(known).q_SB);
}

std::optional<double> Comparison::first_error(const Contender& one, double frame_s) const {
  for (long i = 0;; ++i) {
    const double t = std::min(static_cast<double>(i) * frame_s, one.end);
    bool wrong = false;
    if (const std::optional<double> error = attitude_error(one, t)) {
      wrong = !(*error <= allowed_rad_);
    } else {
      const Drift now = drift_at(one.motion, t);
      wrong = !(std::abs(now.energy.value_or(0.0)) <= kTrustedDrift) ||
              !(now.momentum.value_or(0.0) <= kTrustedDrift);
    }
    if (wrong) return t;
    if (t >= one.end) return {};
  }
}

PanelNotes Comparison::notes(const Contender& one, double t) const {
  const double known = std::min(t, one.end);
  const Drift now = drift_at(one.motion, known);
  PanelNotes notes;
  const SimulationReport& report = one.report;
  notes.lines.push_back(title_of(report.method));
  notes.lines.push_back(report.step        ? fmt::format("step {:.4g} s", *report.step)
                        : report.tolerance ? fmt::format("tolerance {:.2g}", *report.tolerance)
                                           : "no steps");
  std::string drifts = now.energy ? "energy " + relative(*now.energy) : "";
  if (now.momentum) {
    const char* name = one.motion.model().chi_P.squaredNorm() > 0.0 ? "Lz" : "L";
    drifts += fmt::format(
        "{}{} {}", drifts.empty() ? "" : "   ", name, relative(*now.momentum).substr(1));
  }
  notes.lines.push_back(drifts.empty() ? "nothing is conserved" : drifts);
  const std::optional<double> error = attitude_error(one, known);
  notes.lines.push_back(error ? "attitude off by " + angle(*error) : "no exact motion is known");
  if (!one.failure.empty() && t >= one.end) {
    notes.stamp = fmt::format("ended at {:.2f} s", one.end);
  } else if (one.untrusted_from && t >= *one.untrusted_from) {
    notes.stamp = fmt::format("not to be trusted since {:.2f} s", *one.untrusted_from);
  }
  return notes;
}

Json Comparison::report() const {
  Json list = Json::array();
  for (const Contender& one : contenders_) {
    Json row = json_of(one.report);
    row["end_s"] = one.end;
    row["failure"] = one.failure;
    row["untrusted_from_s"] = one.untrusted_from ? Json(*one.untrusted_from) : Json(nullptr);
    row["attitude_error_at_end_rad"] = nullptr;
    if (const std::optional<double> error = attitude_error(one, one.end))
      row["attitude_error_at_end_rad"] = *error;
    list.push_back(row);
  }
  return list;
}

}  // namespace polhode
