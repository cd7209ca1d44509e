// SPDX-License-Identifier: MIT
#include "motion/walk.h"

#include "base/error.h"

namespace polhode {

bool is_finite(const State& s) {
  return s.q.coeffs().allFinite() && s.y.allFinite() && s.place_S.allFinite() &&
         s.linear_momentum_S.allFinite();
}

void refuse_nan(const State& s, const StepperInfo& method, double t) {
  if (is_finite(s)) return;
  throw Error(
      Fault::check_failed,
      fmt::format("the motion is not a number at t = {:.6g} s with method {}; {}",
                  t,
                  method.name,
                  method.adaptive ? "no step is short enough there, so that another tolerance or "
                                    "method may not do, either"
                                  : "take a smaller step or another method"));
}

void refuse_tolerance(const StepperInfo& method, double tolerance, double t) {
  throw StepTooSmall(Fault::check_failed,
                     fmt::format("{} cannot reach tolerance {} at t = {:.6g} s: its step fell to "
                                 "round-off; ask for another tolerance",
                                 method.name,
                                 tolerance,
                                 t));
}

}  // namespace polhode
