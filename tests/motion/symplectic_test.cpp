// SPDX-License-Identifier: MIT
// Does a step keep the canonical form of the phase space? Measured on the derivative of the step,
// in the axes of the body: dtheta turns the body, dy changes its momentum, and the form is
//   (dtheta1 . dy2 - dtheta2 . dy1) + y . (dtheta1 x dtheta2)
// (Marsden and Ratiu, Introduction to Mechanics and Symmetry, 13.4, left trivialisation).
#include <functional>

#include <gtest/gtest.h>

#include "motion/grid_trajectory.h"
#include "motion/scales.h"
#include "motion/stepper_table.h"
#include "support/residual.h"
#include "support/stepper_rows.h"
#include "support/taylor_oracle.h"
#include "support/tops.h"

namespace polhode {
namespace {

using namespace test;

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Step = std::function<State(const State&)>;

State moved(const State& s, int direction, double size) {
  Vec6 by = Vec6::Zero();
  by[direction] = size;
  return {s.q * exp_rotation(by.head<3>()), s.y + by.tail<3>()};
}

Vec6 between(const State& from, const State& to) {
  const Quat turn = from.q.conjugate() * to.q;
  Vec6 difference;
  difference << 2.0 * turn.vec() * (turn.w() < 0.0 ? -1.0 : 1.0), to.y - from.y;
  return difference;
}

// central differences of the fourth order; the third-order difference of a rotation vector from
// twice the vector part is odd and cancels with them
Mat6 slope(const Step& step, const State& s) {
  const State end = step(s);
  const double d = 2e-3;
  Mat6 result;
  for (int i = 0; i < 6; ++i) {
    const Vec6 near = between(end, step(moved(s, i, d))) - between(end, step(moved(s, i, -d)));
    const Vec6 far =
        between(end, step(moved(s, i, 2 * d))) - between(end, step(moved(s, i, -2 * d)));
    result.col(i) = (8.0 * near - far) / (12.0 * d);
  }
  return result;
}

Mat6 form_at(const State& s) {
  Mat6 form = Mat6::Zero();
  form.topLeftCorner<3, 3>() = -hat(s.y);
  form.topRightCorner<3, 3>().setIdentity();
  form.bottomLeftCorner<3, 3>() = -Mat3::Identity();
  return form;
}

// largest change of the form by the step
double change_of_form(const Step& step, const State& s) {
  const Mat6 J = slope(step, s);
  return (J.transpose() * form_at(step(s)) * J - form_at(s)).cwiseAbs().maxCoeff();
}

// the judge is judged first: the true motion keeps the form
TEST(CanonicalForm, IsKeptByTheMotionItself) {
  for (const Problem& p : {upright(hairer_vilmart()), heavy_asymmetric()}) {
    const auto motion = [&](const State& s) {
      return TaylorOracle(p.model, s).at(0.3L);
    };
    expect_residual("form, true motion", change_of_form(motion, p.start), 1e-10);
  }
}

class FormOfEveryStepper : public StepperTest {};
INSTANTIATE_TEST_SUITE_P(Table, FormOfEveryStepper, every_stepper(), stepper_name);

TEST_P(FormOfEveryStepper, IsKeptExactlyWhenTheTableSaysSo) {
  const StepperInfo& row = GetParam();
  for (const Problem& p : {upright(hairer_vilmart()), heavy_asymmetric()}) {
    if (!why_not(row, p.model).empty()) continue;
    const double turn = row.order < 8     ? 0.7
                        : row.order <= 10 ? 0.95
                                          : 3.0;  // large: a small error is almost symplectic
    const double h = turn / angular_velocity(p.model, p.start.y).norm();
    const std::unique_ptr<Stepper> stepper = row.make(p.model, momentum_scale(p.model, p.start));
    const auto step = [&](State s) {
      stepper->step(0.0, h, s);
      return s;
    };
    const double change = change_of_form(step, p.start);
    if (row.symplectic) {
      expect_residual(row.name + ": form kept", change, 2e-11);
    } else {
      expect_effect(row.name + ": form lost", change, 1e-9);
    }
  }
}

}  // namespace
}  // namespace polhode
