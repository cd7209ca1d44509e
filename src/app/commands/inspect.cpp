// SPDX-License-Identifier: MIT
#include "app/commands/inspect.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/json.h"
#include "base/one_line.h"
#include "film/overrides.h"
#include "film/prepared_film.h"
#include "motion/derived.h"
#include "motion/scales.h"
#include "scene/scene_file.h"

namespace polhode {
namespace {

Json list_of(const Vec3& v) {
  // adding zero turns -0 into 0
  return {v[0] + 0.0, v[1] + 0.0, v[2] + 0.0};
}

// Evaluations that the equations of motion would take at the scene's accuracy; null: out of reach.
// A long motion is priced by its beginning, which may err by its part of the accuracy.
Json evaluations_of_ode(const Solved& solved) {
  const SimulationReport& report = solved.simulation.report;
  if (report.model == "ode" || report.model == "ode6") return report.record.evaluations;
  if (solved.model.table) return report.record.evaluations;
  NumericsSpec numerics;
  numerics.model = "ode";
  MotionSpec beginning = solved.scene.motion;
  constexpr double kTurned = 500.0;  // rad
  constexpr double kFinest = 1e-12;  // rad: what is worth pricing
  const double rate = typical_rate(solved.model, start_state(solved.model, beginning));
  const double parts = std::max(1.0, beginning.duration * rate / kTurned);
  beginning.duration /= parts;
  try {
    const Simulation found =
        simulate(solved.model, beginning, numerics, std::max(report.accuracy_rad / parts, kFinest));
    return std::llround(static_cast<double>(found.report.record.evaluations) * parts);
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    return nullptr;
  }
}

std::string shown(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  if (!value.is_array()) return value.is_null() ? "-" : value.dump();
  std::string text;
  for (const Json& entry : value)
    text += (text.empty() ? "" : value[0].is_array() ? "; " : "  ") + shown(entry);
  return text;
}

// one line per key, angles in degrees too
std::string as_text(const Json& facts) {
  std::string text;
  const auto line = [&](const std::string& key, const Json& value) {
    std::string degrees;
    const bool rate = key.size() > 10 && key.substr(key.size() - 10) == "_rad_per_s";
    const bool angle = key.size() > 4 && key.substr(key.size() - 4) == "_rad";
    if (value.is_number_float() && (rate || angle)) {
      degrees =
          fmt::format("  ({:.6g} {})", value.get<double>() * 180.0 / kPi, rate ? "deg/s" : "deg");
    }
    text += fmt::format("{:<42} {}{}\n", key, one_line(shown(value)), degrees);
  };
  for (const auto& [key, value] : facts.items()) {
    if (key == "conserved") {
      for (const auto& [name, law] : value.items()) {
        text += fmt::format("{:<42} {} {} ({})\n",
                            "conserved_" + name,
                            one_line(shown(law["value"])),
                            law["unit"].get<std::string>(),
                            law["what"].get<std::string>());
      }
      continue;
    }
    if (key == "events") {
      constexpr std::size_t kShown = 20;
      for (std::size_t i = 0; i < std::min(kShown, value.size()); ++i) {
        text += fmt::format("{:<42} {:.9g}  {}\n",
                            "event_s",
                            value[i]["t_s"].get<double>(),
                            value[i]["what"].get<std::string>());
      }
      if (value.size() > kShown)
        text += fmt::format("{:<42} {} more\n", "events", value.size() - kShown);
      continue;
    }
    if (!value.is_object()) {
      line(key, value);
      continue;
    }
    for (const auto& [name, number] : value.items())
      line(name, number);
  }
  return text;
}

// what a body on a table conserves, and the events of its motion
void add_contact(Json& facts, const Solved& solved) {
  const Motion& motion = solved.simulation.motion;
  const Moving now = moving_of(solved.model, motion.state_at(0.0));
  facts["conserved"] = Json::object();
  for (const ContactInvariant* law : invariants_from(solved.model, now)) {
    const Vec3 value = law->value(solved.model, now);
    const bool is_vector = value.tail<2>() != Eigen::Vector2d::Zero();
    facts["conserved"][law->name] = {{"what", law->doc},
                                     {"value", is_vector ? list_of(value) : Json(value[0])},
                                     {"unit", law->unit}};
  }
  if (keeps_energy(solved.model)) {
    facts["conserved"]["energy"] = {
        {"what", "kinetic and potential energy"}, {"value", motion.at(0.0).energy}, {"unit", "J"}};
  }
  const Drift& drift = solved.simulation.report.record.drift;
  facts["drift_of_energy_and_work"] = drift.energy ? Json(*drift.energy) : Json();
  facts["drift_of_invariants"] = drift.momentum ? Json(*drift.momentum) : Json();
  facts["events"] = Json::array();
  for (const ContactRecord& event : solved.simulation.report.record.events)
    facts["events"].push_back({{"t_s", event.t}, {"event", event.event}, {"what", event.words}});
}

}  // namespace

Json inspection(const Solved& solved) {
  const BodyModel& model = solved.model;
  const SimulationReport& report = solved.simulation.report;
  Json facts;
  facts["title"] = solved.scene.title;
  facts["mass_kg"] = model.body.mass;
  facts["center_of_mass_m"] = list_of(model.body.center);
  for (int i = 0; i < 3; ++i)
    facts["tensor_kg_m2"].push_back(list_of(model.body.tensor.row(i)));

  // ascending, and right-handed again after the change of order
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
    return model.moments[i] < model.moments[j];
  });
  Mat3 axes;
  Vec3 moments;
  for (int i = 0; i < 3; ++i) {
    const int from = order[static_cast<std::size_t>(i)];
    axes.row(i) = model.R_BP.col(from).transpose();
    moments[i] = model.moments[from];
  }
  if (axes.determinant() < 0.0) axes.row(1) = -axes.row(1);
  facts["reference"] = model.on_pivot ? "fixed point" : "center of mass";
  facts["principal_moments_kg_m2"] = list_of(moments);
  for (int i = 0; i < 3; ++i)
    facts["principal_axes"].push_back(list_of(axes.row(i)));
  facts["kind"] = model.kind.name();
  facts["model"] = report.model;
  facts["model_reason"] = report.model_reason;
  facts["method"] = report.method;
  facts["method_reason"] = report.method_reason;
  facts["accuracy_rad"] = report.accuracy_rad;
  facts["evaluations"] = report.record.evaluations;
  facts["evaluations_of_ode"] = evaluations_of_ode(solved);
  facts["derived"] = Json::object();
  for (const Quantity& q : derived_quantities(model, solved.scene.motion)) {
    facts["derived"][key_of(q)] =
        q.unit == QuantityUnit::verdict ? Json(q.value != 0.0) : Json(q.value + 0.0);
  }
  if (model.table) add_contact(facts, solved);
  return facts;
}

// What inspect tells is of the motion itself, which no step or tolerance of the methods that a
// scene compares changes.
void refuse_for_compared(const Scene& scene) {
  if (scene.numerics.compare.empty()) return;
  for (const char* key : {"numerics.step", "numerics.tolerance"}) {
    refuse_given(scene, key, "is for the methods that the scene compares; give --method as well");
  }
}

std::string inspect(const InspectJob& job) {
  const Scene scene = load_with_overrides(job.scene, job.overrides);
  const auto checked = [](const Scene& one) {
    with_place(one, [&] { refuse_for_compared(one); });
    Solved solved = solve_alone(one, ProgressKind::automatic);
    check_film(solved);
    return solved;
  };
  if (scene.panels.empty()) {
    const Json facts = inspection(checked(scene));
    return job.json ? facts.dump(2) + "\n" : as_text(facts);
  }
  std::string text;
  Json list = Json::array();
  std::vector<Solved> panels;
  for (const ScenePanel& panel : scene.panels) {
    panels.push_back(checked(panel.scene));
    const Json facts = inspection(panels.back());
    text +=
        fmt::format("{}{}\n{}", text.empty() ? "" : "\n", one_line(panel.caption), as_text(facts));
    list.push_back({{"caption", panel.caption}, {"inspection", facts}});
  }
  panels.front().scene = scene;
  check_charts(panels);
  return job.json ? Json{{"panels", list}}.dump(2) + "\n" : text;
}

}  // namespace polhode
