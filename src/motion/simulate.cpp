// SPDX-License-Identifier: MIT
#include "motion/simulate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/nearest.h"
#include "math/so3.h"

namespace polhode {
namespace {

constexpr int kSamplesCompared = 257;     // times at which two runs are held against each other
constexpr double kLeastAccuracy = 1e-13;  // rad
constexpr long kMostStepsRefined = 4'000'000;

// largest attitude difference of two trajectories over the motion, rad; with six degrees of freedom
// also that of place, in units of the radius of gyration
double difference(const Model& model, const Trajectory& a, const Trajectory& b, double duration) {
  const double gyration = std::sqrt(model.moments.maxCoeff() / model.body.mass);
  double largest = 0.0;
  for (int i = 0; i < kSamplesCompared; ++i) {
    const double t = duration * i / (kSamplesCompared - 1);
    const State one = a.at(t), other = b.at(t);
    largest = std::max({largest,
                        rotation_angle_between(one.q, other.q),
                        (one.place_S - other.place_S).norm() / gyration});
  }
  return largest;
}

// one integration with a given fineness: the step of fixed-step methods, the tolerance of adaptive
// ones
Integration run(const StepperInfo& method,
                const Model& model,
                const State& start,
                double duration,
                double fineness) {
  return method.adaptive ? integrate_adaptive(method, model, start, duration, fineness)
                         : integrate_fixed(method, model, start, duration, fineness);
}

// refines until two runs agree within the accuracy; the finer one is the answer
Integration refine(const StepperInfo& method,
                   const Model& model,
                   const State& start,
                   double duration,
                   SimulationReport& report) {
  const double rate = typical_rate(model, start) + 1.0 / duration;
  const double factor = method.adaptive ? 1.0 / 32.0 : 0.5;
  double fineness = method.adaptive
                        ? 0.01 * report.accuracy_rad
                        : std::min(0.1 * std::max(1.0, 0.5 * method.order) / rate, duration);
  Integration coarse = run(method, model, start, duration, fineness);
  while (true) {
    fineness *= factor;
    const bool too_fine =
        method.adaptive ? fineness < 1e-15 : duration / fineness > kMostStepsRefined;
    if (too_fine) {
      throw input_error(
          "{} cannot reach an attitude accuracy of {:.3g} rad over {} s in reasonable "
          "work; give a step or tolerance yourself, a looser accuracy, or another method",
          method.name,
          report.accuracy_rad,
          duration)
          .at({{}, 0, "numerics.accuracy"});
    }
    Integration fine = run(method, model, start, duration, fineness);
    const double apart = difference(model, *coarse.trajectory, *fine.trajectory, duration);
    if (apart <= report.accuracy_rad) {
      (method.adaptive ? report.tolerance : report.step) = fineness;
      report.error_estimate_rad = apart;
      return fine;
    }
    coarse = std::move(fine);
  }
}

// runs `work`; an error without a key gets this one
template <class Work>
decltype(auto) with_key(const char* key, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw error.at({{}, 0, key});
  }
}

Integration integrate(const Model& model,
                      const char* automatic_method,
                      const State& start,
                      const MotionSpec& motion,
                      const NumericsSpec& numerics,
                      SimulationReport& report) {
  const bool automatic = numerics.method == "auto";
  const StepperInfo& method = with_key("numerics.method", [&]() -> const StepperInfo& {
    return find_stepper(automatic ? automatic_method : numerics.method);
  });
  report.method = method.name;
  report.method_reason = !automatic        ? "asked for"
                         : method.adaptive ? "adaptive, general purpose"
                                           : "splitting of high order with exact parts";
  const std::string obstacle = why_not(method, model);
  if (!obstacle.empty()) throw input_error("{}", obstacle).at({{}, 0, "numerics.method"});
  if (method.adaptive && numerics.step) {
    throw input_error(
        "{} chooses its own steps; give a tolerance, or a fixed-step method such as rk4",
        method.name)
        .at({{}, 0, "numerics.step"});
  }
  if (!method.adaptive && numerics.tolerance) {
    throw input_error("{} has fixed steps; give a step, or an adaptive method such as dopri5",
                      method.name)
        .at({{}, 0, "numerics.tolerance"});
  }
  const std::optional<double> given = method.adaptive ? numerics.tolerance : numerics.step;
  if (!given) {
    if (report.accuracy_rad < kLeastAccuracy) {
      throw input_error(
          "{:.3g} rad is beyond what an integration in double precision can reach; ask "
          "for at least {} rad",
          report.accuracy_rad,
          kLeastAccuracy)
          .at({{}, 0, "numerics.accuracy"});
    }
    Integration found = with_key(
        "numerics.accuracy", [&] { return refine(method, model, start, motion.duration, report); });
    report.method_reason +=
        fmt::format("; refined until two runs agree within {:.3g} rad", report.accuracy_rad);
    return found;
  }
  report.step = numerics.step;
  report.tolerance = numerics.tolerance;
  return with_key(method.adaptive ? "numerics.tolerance" : "numerics.step",
                  [&] { return run(method, model, start, motion.duration, *given); });
}

}  // namespace

std::vector<std::string> method_names() {
  std::vector<std::string> names = {"auto", "exact"};
  for (const StepperInfo& row : stepper_table())
    names.push_back(row.name);
  return names;
}

Simulation simulate(const Model& body,
                    const MotionSpec& motion,
                    const NumericsSpec& numerics,
                    double accuracy_rad) {
  SimulationReport report;
  report.accuracy_rad = accuracy_rad;
  const MotionModel& chosen = choose_model(body, numerics, report.model_reason);
  Model model = body;
  model.six = chosen.six;
  const State start = start_state(model, motion);
  report.model = chosen.name;
  if (!chosen.closed_form) {
    if (numerics.method == "exact") {
      throw input_error("there is no closed form for this scene ({}); use method = \"auto\"",
                        report.model_reason)
          .at({{}, 0, "numerics.method"});
    }
    Integration found = integrate(model, chosen.method, start, motion, numerics, report);
    report.record = found.record;
    return {Motion(model, found.trajectory, motion), report};
  }

  // a closed form takes no stepper and no step
  if (numerics.method != "auto" && numerics.method != "exact") {
    throw input_error("model '{}' is a closed form and takes no method; use model = \"ode\"",
                      chosen.name)
        .at({{}, 0, "numerics.method"});
  }
  if (numerics.step || numerics.tolerance) {
    throw input_error(
        "this motion is computed in closed form, without steps; leave it out or "
        "name an integrator as the method")
        .at({{}, 0, numerics.step ? "numerics.step" : "numerics.tolerance"});
  }
  report.method = "exact";
  report.method_reason = "closed form";
  std::shared_ptr<const Trajectory> trajectory = chosen.make(model, start);
  DriftWatch drift(model, start);
  for (int i = 0; i < kSamplesCompared; ++i) {
    drift.look_at(trajectory->at(motion.duration * i / (kSamplesCompared - 1)));
  }
  report.record.drift = drift.worst();
  return {Motion(model, trajectory, motion), report};
}

Accuracy parse_accuracy(const std::string& text) {
  // a number, with "px" behind it when it counts pixels of the finished picture
  const bool pixels = text.size() > 2 && text.substr(text.size() - 2) == "px";
  const std::string number = pixels ? text.substr(0, text.size() - 2) : text;
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  if (!number.empty() && *end == '\0' && value <= 0.0) {
    throw input_error("must be greater than 0, got {}", text);
  }
  if (number.empty() || *end != '\0' || !std::isfinite(value)) {
    throw input_error("'{}' is no accuracy; give radians (1e-6) or pixels (\"0.1px\")", text);
  }
  return {value, pixels};
}

}  // namespace polhode
