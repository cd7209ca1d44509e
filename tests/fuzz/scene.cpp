// SPDX-License-Identifier: MIT
// Scenes and films, up to the plan of the film: everything but integration and drawing. Mesh files
// are looked for among the shipped scenes.
#include <cmath>

#include "base/error.h"
#include "base/json.h"
#include "film/frame_times.h"
#include "film/solved_scene.h"
#include "frame/timeline.h"
#include "fuzz/harness.h"
#include "fuzz/scene_text.h"
#include "model/fall_on_table.h"
#include "motion/derived.h"
#include "motion/motion.h"
#include "motion/solution_method.h"
#include "motion/step_limit.h"
#include "scene/canonical.h"

namespace polhode {
namespace {

bool is_finite(const Sample& s) {
  return s.q_SB.coeffs().allFinite() && s.w_B.allFinite() && s.w_S.allFinite() &&
         s.L_S.allFinite() && s.center_S.allFinite() && std::isfinite(s.energy);
}

void read_back(const Scene& scene) {
  const Json json = scene_to_json(scene);
  const Scene again = scene_from_json(json, (kScenes / "a.toml").string());
  promise(scene_to_json(again).dump() == json.dump(),
          "a scene that is written and read is the same");
  promise(scene_hash(again) == scene_hash(scene), "and has the same hash");
}

// a body on a table: where it touches, and what the table does to it
void look_at_contact(const BodyModel& model, const State& start) {
  const ContactSurface& surface = *model.table->surface;
  const Moving now = moving_of(model, start);
  for (const Vec3& down : {Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0.48, -0.6, 0.64)}) {
    const int piece = surface.lowest(down);
    const SurfacePoint point = surface.at(down, Vec3(0.6, 0.8, 0.0).cross(down), piece);
    promise(point.arm_P.allFinite() && point.arm_rate_P.allFinite(), "a contact is finite");
    promise(point.arm_P.norm() <= surface.reach() * (1.0 + 1e-9), "a contact is within reach");
    promise(surface.clearance(down, piece) >= 0.0, "the lowest piece is the lowest");
  }
  Touch touch;
  touch.piece = surface.lowest(-(now.q.conjugate() * Vec3::UnitZ()));
  for (const bool sticks : {true, false}) {
    touch.sticks = sticks;
    const Reaction reaction = reaction_of(model, touch, 0.0, now);
    promise(std::isfinite(reaction.normal) && reaction.friction_S.allFinite(), "a force is finite");
  }
  Moving falls = now;
  falls.velocity_S.z() -= 1.0;
  fall_on_table(model, touch, model.table->friction.restitution, falls);
  promise(falls.velocity_S.allFinite() && falls.y.allFinite(), "a fall is finite");
}

void plan(const Scene& scene) {
  const BodyModel model = make_model(scene.body, scene.motion);
  promise(model.moments.allFinite() && model.R_BP.allFinite() && model.chi_P.allFinite(),
          "a model is finite");
  const double accuracy = accuracy_in_radians(scene, model);
  promise(accuracy > 0.0, "an accuracy is positive");
  const State start = start_state(model, scene.motion);
  promise(start.q.coeffs().allFinite() && start.y.allFinite(), "a start is finite");
  for (const StepperInfo& method : stepper_table())
    promise(!(step_limit(method, model, start) <= 0.0), "a step limit is positive");
  if (model.table) look_at_contact(model, start);
  for (const Quantity& quantity : derived_quantities(model, scene.motion))
    promise(!std::isnan(quantity.value), quantity.name);
  check_time_range(scene, {});
  const Timeline timeline(scene.story, scene.motion.duration, scene.video.time_scale);
  promise(timeline.film_duration() > 0.0, "a film has a duration");
  std::string reason;
  const SolutionMethod& method = choose_solution_method(model, scene.numerics, accuracy, reason);
  promise(!reason.empty(), "a choice has a reason");
  if (!method.closed_form) return;
  const Motion motion = solve(scene).simulation.motion;
  for (const double part : {0.0, 0.5, 1.0})
    promise(is_finite(motion.at(part * motion.duration())), "a motion is finite");
}

}  // namespace

void run_harness(const std::string& bytes) {
  for (const Scene& scene : scenes_of_text(bytes)) {
    read_back(scene);
    plan(scene);
  }
}

}  // namespace polhode
