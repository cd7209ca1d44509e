// SPDX-License-Identifier: MIT
#include "film/solving.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/system/interrupt.h"
#include "film/error_places.h"
#include "frame/attitude_tolerance.h"
#include "frame/body_look.h"
#include "frame/theme.h"
#include "motion/ensemble.h"

namespace polhode {

double accuracy_in_radians(const Scene& scene,
                           const BodyModel& model,
                           const std::vector<Vec3>& places) {
  const Accuracy& accuracy = scene.numerics.accuracy;
  if (!accuracy.pixels) return accuracy.value;
  constexpr int kCoarse = 16;  // segments: enough to measure how far the body reaches
  DrawnReach drawn;
  drawn.places = places;
  if (places.empty()) {
    drawn.places = {model.on_pivot ? Vec3(Vec3::Zero()) : start_state(model, scene.motion).place_S};
  }
  drawn.body = body_radius(body_look(scene.body, model, make_theme(scene.theme), kCoarse), model);
  for (const std::vector<Vec3>& points : {scene.show.points, scene.show.trail_points}) {
    for (const Vec3& point : points)
      drawn.points = std::max(drawn.points, (point - model.reference_B()).norm());
  }
  const auto seen_by = [&](const CameraSpec& camera) {
    return attitude_tolerance(camera, accuracy.value, drawn, scene.video.size);
  };
  double least = seen_by(scene.camera);
  for (std::size_t i = 0; i < scene.shots.size(); ++i) {
    try {
      least = std::min(least, seen_by(scene.shots[i].camera));
    } catch (const Error& error) {
      throw Error(error.fault(), error.message(), {{}, 0, fmt::format("shots[{}].eye", i)});
    }
  }
  return least;
}

namespace {

// where methods are compared, steps and tolerances are theirs, and the scene's motion is the truth
NumericsSpec numerics_of_truth(const Scene& scene) {
  NumericsSpec numerics = scene.numerics;
  if (numerics.compare.empty()) return numerics;
  numerics.compare.clear();
  numerics.step.reset();
  numerics.tolerance.reset();
  return numerics;
}

// Each motion keeps its states; those that begin near one another need about as many.
void refuse_large_ensemble(const Scene& scene, const Simulation& first) {
  if (!scene.motion.ensemble) return;
  constexpr double kMostBytes = 4e9;
  constexpr long kMostStates = 200'000;  // that a trajectory keeps, besides the times of its steps
  const int members = scene.motion.ensemble->members;
  const long steps = first.report.record.steps;
  const double states = static_cast<double>(std::min(steps, kMostStates)) * sizeof(State);
  const double times = first.report.tolerance ? static_cast<double>(steps) * sizeof(double) : 0.0;
  const double of_one = states + times;
  if (members * of_one <= kMostBytes) return;
  throw input_error(
      "{} motions of {} steps each would fill {:.2g} GB of memory; take at most {}, or a shorter "
      "motion",
      members,
      steps,
      1e-9 * members * of_one,
      static_cast<int>(kMostBytes / of_one))
      .at({{}, 0, "motion.ensemble.members"});
}

// Where the reference point is, if a camera that stands sees it nearer or farther; else empty.
std::vector<Vec3> places_seen(const Scene& scene, const Motion& motion) {
  const auto stands = [](const CameraSpec& camera) {
    return camera.eye.has_value();
  };
  const bool any_stands = stands(scene.camera) ||
                          std::any_of(scene.shots.begin(),
                                      scene.shots.end(),
                                      [&](const ShotSpec& shot) { return stands(shot.camera); });
  std::vector<Vec3> places;
  if (any_stands && scene.numerics.accuracy.pixels && !motion.model().on_pivot) {
    for (const double t : framing_times(motion))
      places.push_back(motion.at(t).reference_S);
  }
  return places;
}

// the motions of the ensemble; `warn` is told once of those that cannot be trusted
template <class Warn>
std::vector<Motion> solve_ensemble(const Scene& scene,
                                   const BodyModel& model,
                                   double accuracy,
                                   const Warn& warn) {
  const std::vector<MotionSpec> specs = ensemble_of(model, scene.motion);
  const NumericsSpec numerics = numerics_of_truth(scene);
  const std::vector<Simulation> found = [&] {
    try {
      return simulate_ensemble(model, specs, numerics, accuracy);
    } catch (const Error& error) {
      stop_if_interrupted();
      throw Error(
          error.fault(),
          fmt::format("a motion beside that of the scene cannot be computed: {}", error.message()),
          {{}, 0, "motion.ensemble"});
    }
  }();
  std::vector<Motion> motions;
  std::size_t doubted = 0;
  for (const Simulation& one : found) {
    motions.push_back(one.motion);
    if (!one.report.reliability.doubts.empty()) ++doubted;
  }
  if (doubted > 0) {
    warn(fmt::format("{} of {} motions cannot be trusted", doubted, motions.size()),
         "motion.ensemble");
  }
  return motions;
}

}  // namespace

Solved solve_watched(const Scene& scene, const SolveWatch& watch) {
  return with_place(scene, [&] {
    StageTime time;
    BodyModel model = make_model(scene.body, scene.motion);
    double accuracy = accuracy_in_radians(scene, model);
    const auto warn = [&](const std::string& words, const char* key) {
      if (watch.warn) watch.warn(placed(scene, input_error("{}", words).at({{}, 0, key})));
    };
    const NumericsSpec numerics = numerics_of_truth(scene);
    const std::optional<std::string> too_long =
        step_beyond_limit(model, start_state(model, scene.motion), numerics);
    if (too_long) warn(*too_long, "numerics.step");
    const auto simulated = [&] {
      const StageTimer timer(time);
      return simulate(model, scene.motion, numerics, accuracy, watch.progress);
    };
    Simulation found = simulated();
    // a body may come nearer to a camera than where it starts
    constexpr double kNearer = 0.7;
    if (const std::vector<Vec3> places = places_seen(scene, found.motion); !places.empty()) {
      const double needed = accuracy_in_radians(scene, model, places);
      if (needed < kNearer * accuracy) {
        accuracy = needed;
        found = simulated();
      }
    }
    for (const std::string& doubt : found.report.reliability.doubts)
      warn("the motion cannot be trusted: " + doubt, "numerics.method");
    refuse_large_ensemble(scene, found);
    std::vector<Motion> ensemble = [&] {
      const StageTimer timer(time);
      // what is shown beside a motion counts as well
      return solve_ensemble(scene, model, accuracy, [&](const std::string& words, const char* key) {
        warn(words, key);
        found.report.reliability.doubts.push_back("of the ensemble, " + words);
      });
    }();
    return Solved{scene, model, std::move(found), std::move(ensemble), time};
  });
}

}  // namespace polhode
