// SPDX-License-Identifier: MIT
// Polhode's methods against those of other libraries: same motions, same judge, one run. Also what
// dense output costs, and trajectories per second. A timing is a benchmark, never a test.
#include <cmath>
#include <cstdio>
#include <limits>

#include <fmt/format.h>

#include "base/system/parallel.h"
#include "chart/work_precision.h"
#include "motion/grid_trajectory.h"
#include "motion/scales.h"
#include "motion/stepper_table.h"
#include "motion/walk.h"
#include "peers.h"
#include "support/tops.h"

namespace polhode::bench {
namespace {

constexpr double kAccuracies[] = {1e-6, 1e-9, 1e-12};
constexpr double kLeastWork_s = 0.02;  // timed per point

struct Case {
  const char* name;
  WorkProblem problem;
  double bar;  // of the ratio
};

Case free_asymmetric() {
  const BodyModel model = test::free_body({1, 2, 3});
  return {"free asymmetric body, I = (1, 2, 3), omega = (0.3, 1, 0.2), t = 100",
          {model, {Quat::Identity(), {0.3, 2.0, 0.6}}, 100.0},
          1.0 / 3.0};
}

Case heavy_symmetric() {
  // Mgl = 2
  const BodyModel model = test::heavy_body({1, 1, 0.5}, 2.0 * Vec3::UnitZ());
  return {"heavy symmetric top, I = (1, 1, 0.5), Mgl = 2, omega = (0.2, 0.1, 8), tilt 0.5, t = 20",
          {model, {exp_rotation({0.5, 0, 0}), {0.2, 0.1, 4.0}}, 20.0},
          1.0 / 3.0};
}

Case heavy_asymmetric() {
  const test::Problem p = test::heavy_asymmetric();
  return {"heavy asymmetric top of the tests, t = 20", {p.model, p.start, 20.0}, 0.5};
}

struct Best {
  std::string name = "none";
  double time_us = std::numeric_limits<double>::infinity();
};

// the cheapest run of all peers with an error at the end of at most `accuracy`
std::vector<WorkPoint> peer_points(const Case& c) {
  const ReferenceSolution reference(c.problem.model, c.problem.start, c.problem.duration);
  const PeerProblem problem(c.problem.model, c.problem.start, c.problem.duration);
  std::vector<WorkPoint> points;
  for (const Peer& peer : peers()) {
    const double factor = peer.fixed ? 1.3 : 0.5;
    for (double fineness = peer.fixed ? 100.0 : 1e-3;
         peer.fixed ? fineness < 3e5 : fineness > 1e-15;
         fineness *= factor) {
      const double exact = peer.fixed ? std::floor(fineness) : fineness;
      WorkPoint p;
      p.method = peer.name;
      p.step = exact;
      p.error_rad = reference.error_at_end(to_state(problem, peer.run(problem, exact)));
      p.time_us = median_time_us([&] { peer.run(problem, exact); }, kLeastWork_s);
      p.status = kPointOk;
      points.push_back(p);
    }
  }
  return points;
}

std::vector<WorkPoint> our_points(const Case& c) {
  const ReferenceSolution reference(c.problem.model, c.problem.start, c.problem.duration);
  WorkOptions options;
  options.least_work_s = kLeastWork_s;
  options.most_run_s = 2e-3;
  options.judge_the_end_only = true;  // as the peers are
  std::vector<WorkPoint> points;
  for (const StepperInfo& method : stepper_table()) {
    if (!why_not(method, c.problem.model).empty()) continue;
    const std::vector<WorkPoint> more = work_precision(method, c.problem, reference, options);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

void compare(const Case& c) {
  fmt::print("{}\n", c.name);
  const std::vector<WorkPoint> ours = our_points(c), theirs = peer_points(c);
  for (const double accuracy : kAccuracies) {
    const WorkPoint* best = cheapest(ours, accuracy);
    const WorkPoint* peer = cheapest(theirs, accuracy);
    if (best == nullptr || peer == nullptr) {
      fmt::print("  {:g} rad: ours {}, peers {}\n",
                 accuracy,
                 best == nullptr ? "none" : best->method,
                 peer == nullptr ? "none" : peer->method);
      continue;
    }
    fmt::print("  {:g} rad: {} {:.1f} us; best peer {} {:.1f} us; ratio {:.2f}, bar {:.2f}\n",
               accuracy,
               best->method,
               best->time_us,
               peer->method,
               peer->time_us,
               best->time_us / peer->time_us,
               c.bar);
    // a free body's exact flow is its closed form; what really steps is worth telling too
    std::vector<WorkPoint> stepping;
    for (const WorkPoint& p : ours) {
      if (!find_stepper(p.method).exact_when_free) stepping.push_back(p);
    }
    const WorkPoint* second = cheapest(stepping, accuracy);
    if (second != nullptr && second->method != best->method) {
      fmt::print("             without closed forms: {} {:.1f} us, ratio {:.2f}\n",
                 second->method,
                 second->time_us,
                 second->time_us / peer->time_us);
    }
  }
}

// 600 frames from the steps of a method, over its bare steps
void dense_output(const Case& c, const char* name, double fineness) {
  const StepperInfo& method = find_stepper(name);
  const WorkProblem& p = c.problem;
  const auto integrate = [&] {
    return method.adaptive ? integrate_adaptive(method, p.model, p.start, p.duration, fineness)
                           : integrate_fixed(method, p.model, p.start, p.duration, fineness);
  };
  const double bare = median_time_us([&] { integrate(); }, kLeastWork_s);
  const double film = median_time_us(
      [&] {
        const Integration run = integrate();
        for (int i = 0; i < 600; ++i)
          run.trajectory->at(p.duration * i / 600.0);
      },
      kLeastWork_s);
  fmt::print("  600 frames, {} {:g}: {} steps, {:.1f} us, with frames {:.1f} us, ratio {:.2f}\n",
             name,
             fineness,
             integrate().record.steps,
             bare,
             film,
             film / bare);
}

void batches(const Case& c, const char* name, double h, long steps) {
  const std::unique_ptr<Stepper> stepper =
      find_stepper(name).make(c.problem.model, momentum_scale(c.problem.model, c.problem.start));
  constexpr long kTrajectories = 4000;
  for (const int jobs : {1, 0}) {
    const double us = median_time_us(
        [&] {
          parallel_for(kTrajectories, jobs, [&](long i) {
            State s = c.problem.start;
            s.y *= 1.0 + 1e-4 * static_cast<double>(i);
            walk_fixed(*stepper, s, h, steps, [](long, const State&) {});
          });
        },
        0.5);
    fmt::print("  {} of {} steps: {:.0f} trajectories per second on {}\n",
               name,
               steps,
               kTrajectories / us * 1e6,
               jobs == 1 ? "one core" : "all cores");
  }
}

}  // namespace
}  // namespace polhode::bench

int main() {
  using namespace polhode::bench;
  std::setbuf(stdout, nullptr);
  const Case free = free_asymmetric(), top = heavy_symmetric(), heavy = heavy_asymmetric();
  for (const Case& c : {free, top, heavy})
    compare(c);
  fmt::print("dense output\n");
  dense_output(free, "dopri5", 1e-8);
  dense_output(free, "rk4", 0.02);
  dense_output(free, "symmetric_remainder6", 0.2);
  dense_output(top, "kick_srkn11", 0.05);
  dense_output(heavy, "kick_srkn11", 0.02);
  dense_output(heavy, "dop853", 1e-10);
  fmt::print("batches of heavy symmetric tops\n");
  batches(top, "rk4", 0.01, 1000);
  batches(top, "kick_strang", 0.01, 1000);
  return 0;
}
