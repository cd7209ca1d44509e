// SPDX-License-Identifier: MIT
#include "film/comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/json.h"
#include "base/units.h"
#include "film/error_places.h"
#include "film/report/motion_report.h"
#include "frame/ticks.h"
#include "math/so3.h"
#include "motion/stepper_table.h"

namespace polhode {
namespace {

constexpr double kFinerTruth = 1e-3;  // of what the scene allows, where there is no closed form
constexpr double kFinestEnd = 1e-9;   // of the motion: how finely it is told where a method fails

// closed forms and the automatic choice take neither
bool is_stepper(const std::string& method) {
  return method != "exact" && method != "auto";
}
bool takes_step(const std::string& method) {
  return is_stepper(method) && !find_stepper(method).adaptive;
}
bool takes_tolerance(const std::string& method) {
  return is_stepper(method) && find_stepper(method).adaptive;
}

// the numerics of one method, with the scene's step or tolerance where it takes one
NumericsSpec numerics_of(const Scene& scene, const std::string& method) {
  NumericsSpec numerics = scene.numerics;
  numerics.method = method;
  if (!takes_step(method)) numerics.step.reset();
  if (!takes_tolerance(method)) numerics.tolerance.reset();
  return numerics;
}

// a step or a tolerance that no method takes would be ignored
void refuse_unused(const NumericsSpec& numerics) {
  const std::vector<std::string>& methods = numerics.compare;
  if (numerics.step && std::none_of(methods.begin(), methods.end(), takes_step)) {
    throw input_error("none of the compared methods takes a step; leave it out")
        .at({{}, 0, "numerics.step"});
  }
  if (numerics.tolerance && std::none_of(methods.begin(), methods.end(), takes_tolerance)) {
    throw input_error("none of the compared methods takes a tolerance; leave it out")
        .at({{}, 0, "numerics.tolerance"});
  }
}

// the motion of a scene by one method
Simulation simulate_by(const Scene& scene,
                       const BodyModel& model,
                       const std::string& method,
                       double duration,
                       double allowed_rad) {
  MotionSpec motion = scene.motion;
  motion.duration = duration;
  return simulate(model, motion, numerics_of(scene, method), allowed_rad);
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

// A method that fails, as far as it comes: by halving, to a whole step where steps are given.
// start: shown where not even one step can be taken.
Contender until_failure(const Scene& scene,
                        const BodyModel& model,
                        const Motion& start,
                        const std::string& method,
                        double allowed_rad) {
  const NumericsSpec numerics = numerics_of(scene, method);
  const double whole = scene.motion.duration;
  const double unit = numerics.step.value_or(kFinestEnd * whole);
  double comes = 0.0, fails = std::ceil(whole / unit * (1.0 - 1e-12));  // units
  std::optional<Simulation> found;
  while (fails - comes > 1.5) {
    const double middle = std::floor(0.5 * (comes + fails));
    try {
      found = simulate_by(scene, model, method, middle * unit, allowed_rad);
      comes = middle;
    } catch (const Error& error) {
      if (error.fault() != Fault::check_failed) throw;
      fails = middle;
    }
  }
  if (found) {
    // of steps that were refined, too, the partial one at the end is part of what fails
    const double step = found->report.step.value_or(0.0);
    const double came = comes * unit;
    const double end = step > 0.0 ? std::floor(came / step * (1.0 + 1e-12)) * step : came;
    if (end > 0.0)
      return {method, found->report, held(found->motion, end, scene.motion), end, {}, {}};
  }
  SimulationReport report;
  report.method = method;
  report.step = numerics.step;
  report.tolerance = numerics.tolerance;
  return {method, report, held(start, 0.0, scene.motion), 0.0, {}, {}};
}

// "+12.3 %", "-3e-12"
std::string relative(double value) {
  if (value == 0.0) return "+0";
  if (std::abs(value) < 1e-3) return fmt::format("{:+.0e}", value);
  return std::abs(value) < 10.0 ? fmt::format("{:+.3g} %", 100.0 * value)
                                : fmt::format("{:+.0e} times", value);
}

// as wide as the widest number of its kind, so that what stands behind it does not move
std::string degrees(const std::string& number, std::size_t digits_and_point) {
  constexpr const char* kFigureSpace = "\u2007";
  std::string free;
  for (std::size_t i = number.size(); i < digits_and_point; ++i)
    free += kFigureSpace;
  return number + "\u00b0" + free;
}

// "+20.3 %", "\u221226.3 %", "0.0 %", "+3\u00b710\u2077 %"
std::string percent(double part) {
  const double value = 100.0 * part;
  if (!(std::abs(value) >= 1e4)) {
    const std::string number = number_text(value, 0, 1);
    const bool zero = number == number_text(0.0, 0, 1);
    return (value > 0.0 && !zero ? "+" : "") + number + " %";
  }
  const char* sign = value < 0.0 ? "\u2212" : "+";
  if (!std::isfinite(value)) return fmt::format("{}\u221e %", sign);
  const int power = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fmt::format("{}{:.0f}\u00b7{} %",
                     sign,
                     std::floor(std::abs(value) / std::pow(10.0, power)),
                     power_of_ten(power));
}

std::string title_of(const std::string& method) {
  if (method == "exact") return "Closed form";
  // it stays "auto" if none of those that it tried took a step
  return method == "auto" ? "Automatic choice" : find_stepper(method).title;
}

}  // namespace

Comparison::Comparison(const Solved& truth, double frame_s)
    : allowed_rad_(truth.simulation.report.accuracy_rad), truth_(truth_of(truth)) {
  const Scene& scene = truth.scene;
  with_place(scene, [&] { refuse_unused(scene.numerics); });
  const BodyModel model = make_model(scene.body, scene.motion);
  for (std::size_t i = 0; i < scene.numerics.compare.size(); ++i) {
    try {
      contenders_.push_back(run(scene, model, truth.simulation.motion, scene.numerics.compare[i]));
      contenders_.back().untrusted_from = first_error(contenders_.back(), frame_s);
    } catch (const Error& error) {
      const Error found(error.fault(), error.message());
      throw placed(scene, found.at({{}, 0, fmt::format("numerics.compare[{}]", i)}));
    }
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
    Contender failed = until_failure(scene, model, start, method, allowed_rad_);
    failed.failure = error.message();
    failed.report.reliability.doubts.insert(failed.report.reliability.doubts.begin(),
                                            "the method failed before the end of the motion");
    return failed;
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

PanelNotes Comparison::notes(const Contender& one, double t, bool with_details) const {
  // what it shows is the start, of which an error would say nothing
  if (one.end == 0.0 && !one.failure.empty()) {
    const std::vector<std::string> details(with_details ? 1 : 0, "no steps");
    return {title_of(one.report.method), "no step could be taken", details, "ended at 0.00 s"};
  }
  const double known = std::min(t, one.end);
  const Drift now = drift_at(one.motion, known);
  const std::optional<double> error = attitude_error(one, known);
  const SimulationReport& report = one.report;
  PanelNotes notes;
  notes.name = title_of(report.method);

  // two digits of the error at which a panel is stamped
  const int decimals =
      std::clamp(1 - static_cast<int>(std::floor(std::log10(allowed_rad_ / kDegree))), 1, 9);
  if (error) {
    notes.figures = fmt::format("error {}",
                                degrees(fmt::format("{:.{}f}", *error / kDegree, decimals),
                                        static_cast<std::size_t>(decimals) + 4));
  }
  if (now.energy)
    notes.figures += (notes.figures.empty() ? "energy " : "   energy ") + percent(*now.energy);
  if (notes.figures.empty()) notes.figures = "no exact motion is known";

  if (with_details) {
    std::string how = report.step        ? fmt::format("step {:.4g} s", *report.step)
                      : report.tolerance ? fmt::format("tolerance {:.2g}", *report.tolerance)
                                         : "no steps";
    if (error) how += fmt::format("   error {:.2g} rad", *error);
    notes.details.push_back(how);
    std::string drifts = now.energy ? "energy " + relative(*now.energy) : "";
    if (now.momentum) {
      const char* name = one.motion.model().chi_P.squaredNorm() > 0.0 ? "Lz" : "L";
      drifts += fmt::format(
          "{}{} {}", drifts.empty() ? "" : "   ", name, relative(*now.momentum).substr(1));
    }
    notes.details.push_back(drifts.empty() ? "nothing is conserved" : drifts);
  }
  if (!one.failure.empty() && t >= one.end) {
    notes.stamp = fmt::format("ended at {:.2f} s", one.end);
  } else if (one.untrusted_from && t >= *one.untrusted_from) {
    // which may be less again later: a wrong attitude comes by the right one
    notes.stamp = truth_ ? fmt::format("first over {:.3g}\u00b0 at {:.2f} s",
                                       allowed_rad_ / kDegree,
                                       *one.untrusted_from)
                         : fmt::format("drift first over {:g} % at {:.2f} s",
                                       100.0 * kTrustedDrift,
                                       *one.untrusted_from);
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
