// SPDX-License-Identifier: MIT
#include "motion/simulate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/at_place.h"
#include "base/check.h"
#include "base/error.h"
#include "base/nearest.h"
#include "base/numbers.h"
#include "motion/conditioning.h"
#include "motion/convoy.h"
#include "motion/deviation.h"
#include "motion/doubts.h"
#include "motion/method_costs.h"
#include "motion/refinement.h"
#include "motion/scales.h"
#include "motion/stepper_table.h"

namespace polhode {
namespace {

constexpr double kLeastAccuracy = 1e-13;  // rad
constexpr int kTimesOfDrift = 257;
// damping that is so much faster than all else is stiff
constexpr double kStiff = 300.0;
// A given step is checked with this part of it: the golden section, so that no load that repeats
// with the one step repeats with the other.
constexpr double kFinerStep = 0.38196601125010515;

// how a motion is to be integrated, who is told, and what did for a motion that begins nearby
struct Request {
  const NumericsSpec& numerics;
  const SimulationWatch& watch;
  const SimulationReport* neighbour;    // or null
  long most_steps = kMostStepsRefined;  // of one run, where the scene does not say
};

long most_steps(const NumericsSpec& numerics, long by_default) {
  return numerics.max_steps ? static_cast<long>(*numerics.max_steps) : by_default;
}

void refuse_wrong_fineness(const StepperInfo& method, const NumericsSpec& numerics) {
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
}

// with the step or tolerance that is given, or refined to the accuracy
Integration integrate_by(const StepperInfo& method,
                         const BodyModel& model,
                         const State& start,
                         double duration,
                         const Request& request,
                         SimulationReport& report) {
  const NumericsSpec& numerics = request.numerics;
  report.method = method.name;
  refuse_wrong_fineness(method, numerics);
  const std::optional<double> given = method.adaptive ? numerics.tolerance : numerics.step;
  if (given) {
    report.step = numerics.step;
    report.tolerance = numerics.tolerance;
    return at_place({{}, 0, method.adaptive ? "numerics.tolerance" : "numerics.step"}, [&] {
      Effort effort{most_steps(numerics, kMostStepsGiven)};
      if (request.watch) {
        effort.watch = [&told = request.watch](double part) {
          told(1, part);
        };
      }
      return integrate_with(method, model, start, duration, *given, effort);
    });
  }
  if (report.accuracy_rad < kLeastAccuracy) {
    throw input_error(
        "{:.3g} rad is beyond what an integration in double precision can reach; ask "
        "for at least {} rad",
        report.accuracy_rad,
        kLeastAccuracy)
        .at({{}, 0, "numerics.accuracy"});
  }
  const SimulationReport* neighbour = request.neighbour;
  std::optional<double> likely;
  if (neighbour != nullptr && neighbour->method == method.name)
    likely = method.adaptive ? neighbour->tolerance : neighbour->step;
  Refined found = at_place({{}, 0, "numerics.accuracy"}, [&] {
    return refine(method,
                  model,
                  start,
                  duration,
                  report.accuracy_rad,
                  most_steps(numerics, request.most_steps),
                  request.watch,
                  likely);
  });
  (method.adaptive ? report.tolerance : report.step) = found.fineness;
  report.error_estimate_rad = found.error_estimate;
  report.method_reason +=
      fmt::format("; refined until runs converge within {:.3g} rad", report.accuracy_rad);
  report.conditioning = found.conditioning;
  return std::move(found.integration);
}

// "cheapest method measured at 1e-06 rad: 180 ns per radian turned, then ..."
std::string reason_for(const std::vector<MethodCost>& able, const char* what) {
  std::string reason =
      fmt::format("cheapest {} measured at {:.0e} rad: {:.2g} ns per radian turned",
                  what,
                  able[0].accuracy_rad,
                  able[0].ns_per_rad);
  for (std::size_t i = 1; i < std::min<std::size_t>(able.size(), 3); ++i)
    reason += fmt::format(", {} {:.2g}", able[i].method, able[i].ns_per_rad);
  return reason;
}

// what the cheapest method of the other family would cost, if the model can be solved by both
std::string reason_against_others(const BodyModel& model,
                                  const SolutionMethod& chosen,
                                  const NumericsSpec& numerics,
                                  double accuracy_rad) {
  if (chosen.splits) {
    const MethodCost any = cheapest_methods(model, numerics, accuracy_rad, false).front();
    if (find_stepper(any.method).symplectic) return {};
    return fmt::format("; model = \"ode\" would take {}, {:.2g}", any.method, any.ns_per_rad);
  }
  const std::vector<MethodCost> splittings = cheapest_methods(model, numerics, accuracy_rad, true);
  if (!can_split(model) || splittings.empty()) return {};
  return fmt::format("; the cheapest splitting is {}, {:.2g}",
                     splittings.front().method,
                     splittings.front().ns_per_rad);
}

// a method to try, why, and how far
struct Candidate {
  const StepperInfo* method;
  std::string reason;
  long most_steps = kMostStepsRefined;
};

// Whether friction in the bearings of gimbals is stiff wherever the axle comes along the axis of
// the outer ring: the two turn as one there, as fast as the rings are light.
bool is_stiff_in_gimbal_lock(const BodyModel& model, const State& start) {
  if (!model.loads.gimbals) return false;
  const Gimbals& rings = *model.loads.gimbals;
  const double inertia = (rings.outer + rings.inner.z()) * typical_rate(model, start);
  return rings.friction.maxCoeff() > kStiff * inertia;
}

// those of the method tables that may suit the motion, in the order in which to try them
std::vector<Candidate> candidates(const BodyModel& model,
                                  const SolutionMethod& chosen,
                                  const State& start,
                                  double duration,
                                  const NumericsSpec& numerics,
                                  double accuracy_rad) {
  if (model.table)
    return {{&find_stepper("dop853"), "of high order, with events located on its own steps"}};
  const std::string others = reason_against_others(model, chosen, numerics, accuracy_rad);
  std::vector<Candidate> found;
  // explicit steps resolve what is at rest
  if (stiffness(model, start, duration) > kStiff && !numerics.step) {
    for (const StepperInfo& row : stepper_table()) {
      if (row.stiff) found.push_back({&row, "damping is much faster than the motion" + others});
    }
  }
  // many motions at once
  const StepperInfo& together = find_stepper("dop853");
  const bool in_lanes = in_convoy() && !chosen.splits && !model.with_translation &&
                        model.loads.turning.empty() && !numerics.step;
  if (in_lanes) {
    found.push_back({&together, "cheapest for many motions that step together" + others});
  }
  std::vector<MethodCost> able = cheapest_methods(model, numerics, accuracy_rad, chosen.splits);
  CHECK(!able.empty());
  // what three cannot do, the rest will not, and slower
  constexpr int kMostTried = 3;
  for (int i = 0; i < kMostTried && !able.empty(); ++i, able.erase(able.begin())) {
    const char* what = chosen.splits ? "splitting" : "method";
    found.push_back({&find_stepper(able.front().method), reason_for(able, what) + others});
  }
  // most motions in such gimbals do not come near to where they are stiff
  constexpr long kBeforeImplicit = 50'000, kImplicit = 200'000;
  if (is_stiff_in_gimbal_lock(model, start) && !numerics.step) {
    for (Candidate& one : found)
      one.most_steps = kBeforeImplicit;
    found.push_back(
        {&find_stepper("radau5"), "friction is stiff in gimbal lock" + others, kImplicit});
  }
  // where steps that suit the start fail later, steps that choose their own length still tell why
  const StepperInfo& last = together;
  const bool tried = std::any_of(found.begin(), found.end(), [&](const Candidate& one) {
    return one.method == &last && one.most_steps == kMostStepsRefined;
  });
  if (!tried && !chosen.splits && !numerics.step && why_not(last, model).empty())
    found.push_back({&last, "cheaper methods failed" + others});
  return found;
}

// the first candidate that does not fail
Integration integrate_by_cheapest(const BodyModel& model,
                                  const SolutionMethod& chosen,
                                  const State& start,
                                  double duration,
                                  const Request& request,
                                  SimulationReport& report) {
  const std::vector<Candidate> tried =
      candidates(model, chosen, start, duration, request.numerics, report.accuracy_rad);
  // a refusal says what the motion needs; a number that is none, only that steps were too long
  std::optional<Error> refusal;
  for (auto one = tried.begin();; ++one) {
    report.method_reason = one->reason;
    Request limited = request;
    limited.most_steps = one->most_steps;
    try {
      return integrate_by(*one->method, model, start, duration, limited, report);
    } catch (const Error& error) {
      if (error.fault() == Fault::interrupted) throw;
      const bool to_the_end = one->most_steps == kMostStepsRefined;
      if (error.fault() == Fault::input && to_the_end && !refusal) refusal = error;
      if (one + 1 != tried.end()) continue;
      if (refusal) throw *refusal;
      throw;
    }
  }
}

Integration integrate(const BodyModel& model,
                      const SolutionMethod& chosen,
                      const State& start,
                      double duration,
                      const Request& request,
                      SimulationReport& report) {
  const NumericsSpec& numerics = request.numerics;
  if (numerics.method == "auto")
    return integrate_by_cheapest(model, chosen, start, duration, request, report);
  report.method_reason = "asked for";
  const StepperInfo& method = at_place({{}, 0, "numerics.method"}, [&]() -> const StepperInfo& {
    const StepperInfo& found = find_stepper(numerics.method);
    if (const std::string wrong = why_not(found, model); !wrong.empty())
      throw input_error("{}", wrong);
    return found;
  });
  return integrate_by(method, model, start, duration, request, report);
}

// Without a closed form, a run with a given step or tolerance is held against a finer one: neither
// energy nor momentum shows an attitude that is wrong.
void doubt_given_fineness(const BodyModel& model,
                          const State& start,
                          double duration,
                          const NumericsSpec& numerics,
                          const SimulationWatch& watch,
                          const Integration& found,
                          SimulationReport& report) {
  if (!(report.step || report.tolerance) || report.error_estimate_rad) return;
  if (report.reliability.attitude_error_rad) return;
  const StepperInfo& method = find_stepper(report.method);
  double finer = method.adaptive ? *report.tolerance / kTolerancesApart
                                 : kFinerStep * std::min(*report.step, duration);
  std::string against;
  std::vector<std::string>& doubts = report.reliability.doubts;
  try {
    Effort effort{most_steps(numerics, kMostStepsGiven)};
    if (watch) {
      effort.watch = [&](double part) {
        watch(2, part);
      };
    }
    const auto run = [&] {
      against = method.adaptive ? fmt::format("a tolerance of {:.3g}", finer)
                                : fmt::format("a step of {:.3g} s", finer);
      return integrate_with(method, model, start, duration, finer, effort);
    };
    Integration check = run();
    // a few long steps may be as many with a smaller tolerance
    for (int i = 0; method.adaptive && i < 3 && 4 * check.record.steps < 5 * found.record.steps;
         ++i) {
      finer /= kTolerancesApart;
      check = run();
    }
    const double apart =
        largest_deviation(model,
                          *found.trajectory,
                          *check.trajectory,
                          times_to_compare(model, *found.trajectory, duration, kTimesOfDrift));
    // errors that fall by the order are this much larger than what the finer run takes away; those
    // of adaptive runs fall less evenly
    const double order = method.adaptive ? 2.0 : 1.0 / (1.0 - std::pow(kFinerStep, method.order));
    report.error_estimate_rad = apart * order;
    if (apart * order <= report.accuracy_rad) return;
    doubts.push_back(fmt::format(
        "{} moves the attitude by up to {:.2g} rad, so that the error may be {:.2g} rad, "
        "and the scene allows {:.2g}",
        against,
        apart,
        apart * order,
        report.accuracy_rad));
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    doubts.push_back(fmt::format("it could not be held against {}: {}", against, error.message()));
  }
}

// What rounding errors may do; `solve`: see doubt_of_body() in motion/doubts.h.
void doubt_rounding(const BodyModel& model,
                    const MotionSpec& motion,
                    const State& start,
                    const Trajectory& found,
                    const Solve& solve,
                    SimulationReport& report) {
  const bool closed_form = report.method == "exact";
  const double duration = motion.duration, accuracy = report.accuracy_rad;
  const auto add = [&](const std::optional<std::string>& doubt) {
    if (doubt) report.reliability.doubts.push_back(*doubt);
  };
  std::optional<Conditioning>& conditioning = report.conditioning;
  if (conditioning) add(doubt_of_conditioning(*conditioning, closed_form, accuracy));
  if (closed_form) add(doubt_of_kind(model, start, duration, accuracy));
  add(doubt_of_arms(model, start, duration, accuracy));
  add(doubt_of_switches(model, duration, accuracy));
  const double one_rounding = conditioning ? conditioning->effect : 0.0;
  add(doubt_of_body(model, motion, start, found, solve, one_rounding, accuracy));
  if (closed_form)
    add(doubt_of_length(typical_rate(model, start), duration, accuracy, conditioning.value()));
}

}  // namespace

std::vector<std::string> method_names() {
  std::vector<std::string> names = {"auto", "exact"};
  for (const StepperInfo& row : stepper_table())
    names.push_back(row.name);
  return names;
}

Simulation simulate(const BodyModel& body,
                    const MotionSpec& motion,
                    const NumericsSpec& numerics,
                    double accuracy_rad,
                    const SimulationWatch& watch,
                    const SimulationReport* neighbour) {
  SimulationReport report;
  report.accuracy_rad = accuracy_rad;
  const SolutionMethod& chosen =
      choose_solution_method(body, numerics, accuracy_rad, report.model_reason);
  BodyModel model = body;
  model.with_translation = chosen.with_translation;
  const State start = start_state(model, motion);
  report.model = chosen.name;
  if (!chosen.closed_form) {
    if (numerics.method == "exact") {
      throw input_error("there is no closed form for this scene ({}); use method = \"auto\"",
                        report.model_reason)
          .at({{}, 0, "numerics.method"});
    }
    const Request request{numerics, watch, neighbour};
    Integration found = integrate(model, chosen, start, motion.duration, request, report);
    report.record = found.record;
    report.reliability = reliability_of(model, start, motion.duration, report.accuracy_rad, found);
    doubt_given_fineness(model, start, motion.duration, numerics, watch, found, report);
    const auto again = [&](const BodyModel& other, const State& from) {
      const double fineness = report.step ? *report.step : report.tolerance.value();
      const Effort effort{most_steps(numerics, kMostStepsGiven)};
      const StepperInfo& method = find_stepper(report.method);
      return integrate_with(method, other, from, motion.duration, fineness, effort).trajectory;
    };
    doubt_rounding(model, motion, start, *found.trajectory, again, report);
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
  for (const double t : scattered_times(motion.duration, kTimesOfDrift))
    drift.look_at(trajectory->at(t));
  report.record.drift = drift.worst();
  report.reliability.doubts = doubts_of_drift(model, report.record.drift);
  report.conditioning =
      conditioning_of_closed_form(chosen, model, start, *trajectory, motion.duration, accuracy_rad);
  const auto again = [&](const BodyModel& other, const State& from) {
    return std::shared_ptr<const Trajectory>(chosen.make(other, from));
  };
  doubt_rounding(model, motion, start, *trajectory, again, report);
  return {Motion(model, trajectory, motion), report};
}

Accuracy parse_accuracy(const std::string& text) {
  // a number, with "px" behind it when it counts pixels of the finished picture
  const bool pixels = text.size() > 2 && text.substr(text.size() - 2) == "px";
  const std::string number = pixels ? text.substr(0, text.size() - 2) : text;
  const std::optional<double> value = parse_number(number);
  if (!value) {
    throw input_error("'{}' is not an accuracy; give radians (1e-6) or pixels (\"0.1px\")", text);
  }
  if (*value <= 0.0) throw input_error("must be greater than 0, got {}", text);
  return {*value, pixels};
}

}  // namespace polhode
