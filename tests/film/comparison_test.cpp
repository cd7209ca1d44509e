// SPDX-License-Identifier: MIT
#include "film/comparison.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/json.h"
#include "base/units.h"
#include "film/film_panels.h"
#include "film/frame_times.h"
#include "math/so3.h"
#include "scene/scene_file.h"
#include "support/scenes.h"

namespace polhode {
namespace {

constexpr double kFrame = 1.0 / 60.0;

Solved solved(const std::string& name) {
  return solve(load_scene(test::scene_path(name)));
}

// explicit Euler on the transverse Omega of a free symmetric body multiplies it by
// sqrt(1 + (h lambda)^2) in each step, and leaves Omega_3 alone
TEST(Comparison, ExplicitEulerGainsEnergyAsTheorySays) {
  const Solved truth = solved("compare_euler");
  const Comparison comparison(truth, kFrame);
  const Contender& euler = comparison.contenders()[0];
  const double I1 = 0.01, I3 = 0.004, h = 0.1;
  const Vec3 w = euler.motion.at(0.0).w_B;
  const double lambda = w.z() * (I3 - I1) / I1;
  const double across = I1 * (w.x() * w.x() + w.y() * w.y());
  const double growth = std::pow(1.0 + h * h * lambda * lambda, 30.0) - 1.0;
  const double expected = across * growth / (across + I3 * w.z() * w.z());
  EXPECT_NEAR(*drift_at(euler.motion, 3.0).energy, expected, 1e-9 * expected);
  const PanelNotes notes = comparison.notes(euler, 3.0, true);
  EXPECT_EQ(notes.name, "Explicit Euler");
  const double degrees = *comparison.attitude_error(euler, 3.0) * 180.0 / kPi;
  EXPECT_EQ(notes.figures.substr(0, notes.figures.find("\u00b0")),
            fmt::format("error {:.1f}", degrees));
  EXPECT_NE(notes.figures.find(fmt::format("energy +{:.1f} %", 100.0 * expected)),
            std::string::npos)
      << notes.figures;
  EXPECT_EQ(notes.details[0].substr(0, 10), "step 0.1 s");
  EXPECT_EQ(notes.details[1].substr(0, 12), "energy +20 %");
  EXPECT_NE(comparison.notes(euler, 3.0, false).stamp, "");
}

// a step that no method takes would be ignored
TEST(Comparison, RefusesAStepThatNoMethodTakes) {
  Scene scene = load_scene(test::scene_path("compare_euler"));
  const auto refusal = [&] {
    try {
      const Comparison comparison(solve(scene), kFrame);
    } catch (const Error& error) {
      return error.message();
    }
    return std::string();
  };
  scene.numerics.step = 0.1;
  scene.numerics.compare = {"dop853", "exact"};
  EXPECT_EQ(refusal(), "none of the compared methods takes a step; leave it out");
  scene.numerics.compare = {"dop853", "rk4"};
  EXPECT_EQ(refusal(), "");
  scene.numerics.tolerance = 1e-6;
  EXPECT_EQ(refusal(), "");
  scene.numerics.compare = {"rk4", "auto"};
  EXPECT_EQ(refusal(), "none of the compared methods takes a tolerance; leave it out");
}

// stamped from the first frame on which the error passes what the scene allows, and not before
TEST(Comparison, StampsFromTheFrameOnWhichTheErrorPasses) {
  for (const char* name : {"compare_euler", "compare_engines", "compare_fast_top"}) {
    const Solved truth = solved(name);
    const double allowed = truth.simulation.report.accuracy_rad;
    const Comparison comparison(truth, kFrame);
    for (const Contender& one : comparison.contenders()) {
      const auto error = [&](double t) {
        return rotation_angle_between(one.motion.at(t).q_SB, truth.simulation.motion.at(t).q_SB);
      };
      if (!one.untrusted_from) {
        for (double t = 0.0; t <= one.end; t += kFrame)
          EXPECT_LE(error(t), allowed) << name << ' ' << one.method;
        continue;
      }
      const double from = *one.untrusted_from;
      EXPECT_GT(error(from), allowed) << name << ' ' << one.method;
      if (from > 0.0) {
        EXPECT_LE(error(from - kFrame), allowed) << name << ' ' << one.method;
      }
      EXPECT_EQ(comparison.notes(one, std::max(0.0, from - 1e-9), false).stamp, "");
    }
    // the closed form is the truth
    EXPECT_FALSE(comparison.contenders().back().untrusted_from);
  }
}

// RK4 at y = h lambda = 3.99 ends in numbers that are none; the splitting does not care
TEST(Comparison, AMethodThatFailsEndsItsPanelAlone) {
  const Solved truth = solved("compare_fast_top");
  const Comparison comparison(truth, kFrame);
  const Contender& rk4 = comparison.contenders()[0];
  EXPECT_NE(rk4.failure.find("not a number"), std::string::npos);
  EXPECT_GT(rk4.end, 0.0);
  EXPECT_LT(rk4.end, 0.2);
  EXPECT_TRUE(std::isfinite(rk4.motion.at(rk4.end).w_B.norm()));
  EXPECT_NE(comparison.notes(rk4, 1.0, false).stamp.find("ended"), std::string::npos);
  EXPECT_EQ(comparison.contenders()[1].failure, "");
  EXPECT_LT(*comparison.attitude_error(comparison.contenders()[1], 2.0), 0.01);
  const Json report = comparison.report();
  EXPECT_EQ(report[0]["end_s"], rk4.end);
  EXPECT_EQ(report[1]["failure"], "");
}

// a method that cannot take one step has a panel that shows the start
TEST(Comparison, AMethodWithoutASingleStepShowsTheStart) {
  Scene scene = load_scene(test::scene_path("compare_euler"));
  scene.numerics.compare = {"dmv2", "exact"};
  scene.numerics.step = 5.0;
  const Solved truth = solve(scene);
  const Comparison comparison(truth, kFrame);
  const Contender& dmv = comparison.contenders()[0];
  EXPECT_EQ(dmv.end, 0.0);
  EXPECT_NE(dmv.failure.find("no solution"), std::string::npos) << dmv.failure;
  EXPECT_NE(comparison.notes(dmv, 1.0, false).stamp, "");
  EXPECT_EQ(*comparison.attitude_error(dmv, 0.0), 0.0);
  const Json row = comparison.report()[0];
  EXPECT_EQ(row["steps"], 0);
  EXPECT_EQ(row["attitude_error_rad"], nullptr);
  EXPECT_EQ(row["trusted"], false);
}

// energies beyond what numbers hold
TEST(Comparison, DriftsWithoutEndAreShownAsThat) {
  Scene scene = load_scene(test::scene_path("compare_fast_top"));
  scene.numerics.compare = {"explicit_euler", "exact"};
  scene.numerics.step = 0.02;
  const Comparison comparison(solve(scene), kFrame);
  const PanelNotes notes = comparison.notes(comparison.contenders()[0], 1.0, false);
  EXPECT_NE(notes.figures.find("energy +\u221e %"), std::string::npos) << notes.figures;
}

// a step that has no solution though a shorter one has: no part of it is a motion of its own
TEST(Comparison, AStepThatIsLongerThanItsSolutionsIsNoStep) {
  Scene scene = load_scene(test::scene_path("compare_fast_top"));
  scene.numerics.compare = {"gauss4", "exact"};
  scene.numerics.step = 0.02;
  const Comparison comparison(solve(scene), kFrame);
  EXPECT_EQ(comparison.contenders()[0].end, 0.0);
  EXPECT_EQ(comparison.report()[0]["trusted"], false);
  EXPECT_EQ(comparison.report()[0]["error_estimate_rad"], nullptr);
}

// A method comes as far as its whole steps, as it does alone, though parts of these have no
// solution.
TEST(Comparison, AMethodComesAsFarAsItsWholeSteps) {
  Scene scene = load_scene(test::scene_path("t_handle"));
  scene.numerics.compare = {"implicit_midpoint", "exact"};
  for (const double step : {0.4, 0.45, 0.496, 0.5}) {
    scene.numerics.step = step;
    const Comparison comparison(solve(scene), kFrame);
    const Contender& one = comparison.contenders()[0];
    EXPECT_NE(one.failure.find(fmt::format("at t = {:g} s with step {} s", one.end, step)),
              std::string::npos)
        << one.end << ": " << one.failure;
    EXPECT_GT(one.end, 0.9);
    EXPECT_EQ(static_cast<double>(one.report.record.steps) * step, one.end);
    EXPECT_FALSE(one.report.reliability.doubts.empty());
    const double momentum = one.motion.at(0.0).L_S.norm();
    for (double t = 0.0; t < one.end; t += 0.01)
      EXPECT_NEAR(one.motion.at(t).L_S.norm(), momentum, 1e-12 * momentum);
  }
}

// nothing that was tried took a step, so it is not known what "auto" would have been
TEST(Comparison, AnAutomaticChoiceThatFailsHasATitle) {
  const Solved truth = solved("compare_euler");
  const Comparison comparison(truth, kFrame);
  Contender failed = comparison.contenders()[0];
  failed.method = failed.report.method = "auto";
  failed.report.step.reset();
  failed.end = 0.0;
  failed.failure = "no method came through";
  const PanelNotes notes = comparison.notes(failed, 1.0, true);
  EXPECT_EQ(notes.name, "Automatic choice");
  ASSERT_FALSE(notes.details.empty());
  EXPECT_EQ(notes.details[0].substr(0, 8), "no steps");
  EXPECT_EQ(notes.stamp, "ended at 0.00 s");
  EXPECT_EQ(notes.figures, "no step could be taken");
}

// the T-handle: the linearly implicit scheme damps the tumbling, the explicit one feeds it
TEST(Comparison, EnginesErrInTheirOwnWays) {
  const Comparison comparison(solved("compare_engines"), kFrame);
  const auto energy = [&](std::size_t i) {
    return *drift_at(comparison.contenders()[i].motion, 6.0).energy;
  };
  EXPECT_GT(energy(0), 0.2);
  EXPECT_GT(energy(1), 0.2);
  EXPECT_LT(energy(2), -0.2);
  EXPECT_LT(std::abs(energy(4)), 1e-13);
}

// a panel draws the paths of its own method, not those of the truth
TEST(Comparison, EachPanelHasThePathsOfItsOwnMethod) {
  Scene scene = load_scene(test::scene_path("compare_euler"));
  scene.video.size = {320, 180};
  scene.show["trail"] = scene.show["herpolhode"] = true;
  const Solved truth = solve(scene);
  const FrameTimes frames = plan_frame_times(truth, {});
  const Comparison comparison(truth, kFrame);
  const Film film = make_film({truth}, frames.timeline, &comparison, {}, true);
  double apart = 0.0;
  for (std::size_t i = 0; i < film.panels().size(); ++i) {
    const Motion& motion = comparison.contenders()[i].motion;
    const Scenery& scenery = film.panels()[i].composer->scenery();
    const Path& trail = scenery.paths.axis.path();
    ASSERT_GT(trail.points.size(), 8U);
    for (std::size_t k = 0; k < trail.points.size(); k += 8) {
      const double t = trail.parameters[k];
      const double length = kTrailRadius * scenery.scale.body;
      const auto tip = [&](const Motion& of) {
        return Vec3(of.at(t).reference_S + length * (of.at(t).q_SB * Vec3::UnitZ()));
      };
      EXPECT_LT((trail.points[k] - tip(motion)).norm(), 1e-12 * length) << i << ' ' << t;
      apart = std::max(apart, (tip(motion) - tip(truth.simulation.motion)).norm() / length);
    }
    const Path& herpolhode = scenery.paths.herpolhode.path();
    for (std::size_t k = 0; k < herpolhode.points.size(); k += 8) {
      const Vec3 tip = omega_tip(scenery, motion.at(herpolhode.parameters[k]));
      EXPECT_EQ(herpolhode.points[k], tip) << i << ' ' << herpolhode.parameters[k];
    }
  }
  EXPECT_GT(apart, 0.1) << "explicit Euler is bad here";
}

}  // namespace
}  // namespace polhode
