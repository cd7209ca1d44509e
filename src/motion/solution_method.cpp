// SPDX-License-Identifier: MIT
#include "motion/solution_method.h"

#include <algorithm>

#include "base/error.h"
#include "base/nearest.h"
#include "motion/exact/exact.h"
#include "motion/method_costs.h"
#include "motion/stepper_table.h"

namespace polhode {
namespace {

// what keeps every closed form of a free body from answering; damping -c L does not
std::string against_free(const BodyModel& model) {
  if (model.table) return "the body is on a table";
  if (model.chi_P.squaredNorm() > 0.0) return "gravity turns the body about its pivot";
  if (!model.loads.only_damp_momentum()) return "torques act that have no closed form here";
  return {};
}

std::string why_not_spherical(const BodyModel& model) {
  if (std::string wrong = against_free(model); !wrong.empty()) return wrong;
  if (model.kind.shape == TopKind::Shape::spherical) return {};
  return "the three moments are not equal (" + model.kind.name() + ")";
}

std::string why_not_symmetric(const BodyModel& model) {
  if (std::string wrong = against_free(model); !wrong.empty()) return wrong;
  if (model.kind.symmetric()) return {};
  return "no two moments are equal, or all three are (" + model.kind.name() + ")";
}

std::string why_not_asymmetric(const BodyModel& model) {
  if (std::string wrong = against_free(model); !wrong.empty()) return wrong;
  if (model.kind.shape == TopKind::Shape::asymmetric) return {};
  return "two moments are equal (" + model.kind.name() + ")";
}

std::string why_not_heavy_symmetric(const BodyModel& model) {
  if (model.table) return "the body is on a table";
  if (model.chi_P.squaredNorm() == 0.0) return "no gravity turns the body";
  if (model.loads.turn_body()) return "other torques than that of gravity act";
  if (model.kind.shape == TopKind::Shape::spherical) return {};
  if (!model.kind.symmetric()) return "no two moments are equal (" + model.kind.name() + ")";
  if (center_on_symmetry_axis(model)) return {};
  return "the centre of mass is not on the symmetry axis through the pivot";
}

std::string why_not_splitting(const BodyModel& model) {
  if (model.chi_P.squaredNorm() == 0.0) return "no gravity turns the body";
  if (model.loads.turn_body()) return "other torques than that of gravity act";
  return {};
}

std::string why_not_ode(const BodyModel& model) {
  if (model.table) return "the body is on a table";
  if (!model.loads.need_place) return {};
  return "the force on the centre of mass depends on where the body is or how it stands";
}

std::string why_not_ode6(const BodyModel& model) {
  if (model.table) return "the body is on a table";
  if (!model.on_pivot) return {};
  return "the body turns about a fixed point, so it has three degrees of freedom only";
}

// the models of a table, one for each law of friction
template <Friction::Kind kind>
std::string why_not_table(const BodyModel& model) {
  if (!model.table) return "the body is not on a table";
  if (model.table->friction.kind == kind) return {};
  return "the table has another law of friction";
}

// the closed form, or with damping the same in rescaled time
template <std::unique_ptr<Trajectory> (*Exact)(const BodyModel&, const State&)>
std::unique_ptr<Trajectory> maybe_damped(const BodyModel& model, const State& start) {
  const double c = model.loads.momentum_damping();
  if (c == 0.0) return Exact(model, start);
  return damped(Exact(model, start), c);
}

bool is_splitting(const std::string& method) {
  const std::vector<StepperInfo>& table = stepper_table();
  return std::any_of(table.begin(), table.end(), [&](const StepperInfo& row) {
    return row.name == method && row.symplectic;
  });
}

bool splitting_is_cheapest(const BodyModel& model,
                           const NumericsSpec& numerics,
                           double accuracy_rad) {
  const std::vector<MethodCost> able = cheapest_methods(model, numerics, accuracy_rad, false);
  return !able.empty() && find_stepper(able.front().method).symplectic;
}

const SolutionMethod& find_model(const std::string& name) {
  for (const SolutionMethod& row : solution_methods()) {
    if (row.name == name) return row;
  }
  throw input_error("unknown model '{}'{}", name, suggestion(name, model_names()))
      .at({{}, 0, "numerics.model"});
}

// why the least model that takes the scene is this one
std::string reason_for(const SolutionMethod& row, const BodyModel& model) {
  const std::string kind = model.kind.name();
  const bool heavy = model.chi_P.squaredNorm() > 0.0;
  if (row.closed_form) {
    if (heavy) return kind + " body with gravity on a pivot: closed form";
    if (model.loads.momentum_damping() > 0.0) {
      return kind + " body with damping -c L: closed form in rescaled time";
    }
    return kind + " body without torque: closed form";
  }
  if (row.splits) {
    return "no closed form in this version for this body with gravity on a pivot; kicks and free "
           "motion are both known exactly";
  }
  if (row.on_table) return row.doc;
  if (row.with_translation) return why_not_ode(model) + ": six degrees of freedom";
  const bool vowel = kind.front() == 'a' || kind.front() == 'o';
  const bool loaded = model.loads.turn_body();
  return fmt::format("no closed form in this version for {} {} body {}{}",
                     vowel ? "an" : "a",
                     kind,
                     heavy    ? "with gravity on a pivot"
                     : loaded ? "with torques"
                              : "without torque",
                     heavy && loaded ? " and other torques" : "");
}

}  // namespace

const std::vector<SolutionMethod>& solution_methods() {
  static const std::vector<SolutionMethod> models = {
      {.name = "spherical",
       .doc = "free body with three equal moments, closed form",
       .closed_form = true,
       .why_not = why_not_spherical,
       .make = maybe_damped<exact_spherical>},
      {.name = "symmetric",
       .doc = "free body with two equal moments, closed form",
       .closed_form = true,
       .why_not = why_not_symmetric,
       .make = maybe_damped<exact_symmetric>},
      {.name = "asymmetric",
       .doc = "free body with three different moments, closed form in elliptic functions",
       .closed_form = true,
       .why_not = why_not_asymmetric,
       .make = maybe_damped<exact_asymmetric>},
      {.name = "heavy_symmetric",
       .doc = "symmetric body on a pivot under gravity (Lagrange's top, pendulum), closed form",
       .closed_form = true,
       .why_not = why_not_heavy_symmetric,
       .make = exact_heavy_symmetric},
      {.name = "splitting",
       .doc = "any body that gravity turns, by kicks and free motions, each known exactly",
       .splits = true,
       .why_not = why_not_splitting,
       .make = nullptr},
      {.name = "ode",
       .doc = "any rotation, equations of motion integrated, three degrees of freedom",
       .why_not = why_not_ode,
       .make = nullptr},
      {.name = "ode6",
       .doc = "any free body, equations of motion integrated, six degrees of freedom",
       .with_translation = true,
       .why_not = why_not_ode6,
       .make = nullptr},
      {.name = "table_frictionless",
       .doc = "body on a table without friction: only a vertical force acts, five degrees of "
              "freedom",
       .with_translation = true,
       .on_table = true,
       .why_not = why_not_table<Friction::Kind::none>,
       .make = nullptr},
      {.name = "table_rolling",
       .doc = "body that rolls on a table without slipping: three degrees of freedom, the velocity "
              "follows from the rotation",
       .with_translation = true,
       .on_table = true,
       .why_not = why_not_table<Friction::Kind::rolling>,
       .make = nullptr},
      {.name = "table_viscous",
       .doc = "body that slides on a table with friction in proportion to the slip: five degrees "
              "of freedom",
       .with_translation = true,
       .on_table = true,
       .why_not = why_not_table<Friction::Kind::viscous>,
       .make = nullptr},
      {.name = "table_coulomb",
       .doc = "body on a table with dry friction: slides or sticks, and the equations change at "
              "the events between",
       .with_translation = true,
       .on_table = true,
       .why_not = why_not_table<Friction::Kind::coulomb>,
       .make = nullptr},
  };
  return models;
}

std::vector<std::string> model_names() {
  std::vector<std::string> names = {"auto"};
  for (const SolutionMethod& row : solution_methods())
    names.push_back(row.name);
  return names;
}

const SolutionMethod& choose_solution_method(const BodyModel& model,
                                             const NumericsSpec& numerics,
                                             double accuracy_rad,
                                             std::string& reason) {
  if (numerics.model != "auto") {
    const SolutionMethod& asked = find_model(numerics.model);
    const std::string wrong = asked.why_not(model);
    if (!wrong.empty()) {
      throw input_error("model '{}' cannot take this scene: {}", asked.name, wrong)
          .at({{}, 0, "numerics.model"});
    }
    const bool automatic = numerics.method == "auto" || numerics.method == "exact";
    if (asked.splits && !automatic && !is_splitting(numerics.method)) {
      throw input_error(
          "model 'splitting' needs a symplectic method, and {} is not; use "
          "kick_srkn11, or model = \"ode\"",
          numerics.method)
          .at({{}, 0, "numerics.method"});
    }
    reason = "asked for";
    return asked;
  }
  const bool wants_stepper = numerics.method != "auto" && numerics.method != "exact";
  for (const SolutionMethod& row : solution_methods()) {
    if (wants_stepper && row.closed_form) continue;
    if (wants_stepper && row.splits && !is_splitting(numerics.method)) continue;
    if (!row.why_not(model).empty()) continue;
    if (row.splits && !wants_stepper && !splitting_is_cheapest(model, numerics, accuracy_rad))
      continue;
    reason = reason_for(row, model);
    if (wants_stepper && !row.with_translation) {
      reason = "method " + numerics.method + " integrates the equations of motion";
    }
    return row;
  }
  throw Error(Fault::input, "no model takes this scene");
}

bool can_split(const BodyModel& model) {
  return why_not_splitting(model).empty();
}

BodyModel with_needed_degrees(BodyModel model) {
  model.with_translation = !why_not_ode(model).empty();
  return model;
}

}  // namespace polhode
