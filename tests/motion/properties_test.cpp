// SPDX-License-Identifier: MIT
// What must hold for every closed form, on random tops: it is a flow, and it keeps what mechanics
// keeps. The bounds allow for how a start's round-off grows along the motion.
#include "support/properties.h"

#include <memory>

#include "motion/exact/exact.h"
#include "motion/trajectory.h"

namespace polhode {
namespace {

using namespace test;

using Maker = std::unique_ptr<Trajectory> (*)(const BodyModel&, const State&);

void keeps_its_invariants(Maker make, const BodyModel& model, const State& start, double duration) {
  const std::unique_ptr<Trajectory> motion = make(model, start);
  DriftWatch watch(model, start);
  for (int i = 0; i <= 20; ++i)
    watch.look_at(motion->at(duration * i / 20.0));
  RC_ASSERT(watch.worst().energy.value() < 1e-12);
  RC_ASSERT(watch.worst().momentum.value() < 1e-12);
}

// from 0 to t and from there on is from 0 to both
void is_a_flow(Maker make, const BodyModel& model, const State& start, double t, double more) {
  const std::unique_ptr<Trajectory> motion = make(model, start);
  const State later = make(model, motion->at(t))->at(more);
  RC_ASSERT(distance(later, motion->at(t + more)) < 1e-9);
}

RC_GTEST_PROP(AnyMotion, FreeAsymmetric, ()) {
  const Vec3 moments = any_moments();
  const BodyModel model = free_body(moments);
  RC_PRE(model.kind.shape == TopKind::Shape::asymmetric);
  const State start{any_attitude(), any_momentum(moments)};
  RC_PRE(start.y.norm() > 1e-3 * moments.maxCoeff());
  keeps_its_invariants(exact_asymmetric, model, start, 40.0);
  is_a_flow(exact_asymmetric, model, start, number_between(0.0, 4.0), number_between(0.0, 4.0));
}

RC_GTEST_PROP(AnyMotion, FreeSymmetric, ()) {
  Vec3 moments = any_moments();
  moments.y() = moments.x();
  const BodyModel model = free_body(moments);
  RC_PRE(model.kind.symmetric());
  const State start{any_attitude(), any_momentum(moments)};
  RC_PRE(start.y.norm() > 1e-3 * moments.maxCoeff());
  keeps_its_invariants(exact_symmetric, model, start, 40.0);
  is_a_flow(exact_symmetric, model, start, number_between(0.0, 20.0), number_between(0.0, 20.0));
}

RC_GTEST_PROP(AnyMotion, HeavySymmetric, ()) {
  const Vec3 moments(1.0, 1.0, number_between(0.01, 2.0));
  const BodyModel model = heavy_body(moments, Vec3(0, 0, number_between(0.05, 3.0)));
  const State start{any_attitude(), moments.cwiseProduct(vector_within(4.0))};
  RC_PRE(model.kind.symmetric());
  keeps_its_invariants(exact_heavy_symmetric, model, start, 20.0);
  is_a_flow(
      exact_heavy_symmetric, model, start, number_between(0.0, 3.0), number_between(0.0, 3.0));
}

}  // namespace
}  // namespace polhode
