// SPDX-License-Identifier: MIT
// Splitting methods: kicks by gravity alternate with flows of the free body, which are exact or
// split themselves. Sources of the schemes: motion/steppers/splitting.cpp.
#pragma once

#include <array>
#include <cstddef>

#include "motion/stepper.h"
#include "motion/steppers/turn.h"

namespace polhode {

// The coefficients of a symmetric scheme: kick b[0] h, flow a[0] h, kick b[1] h, ..., flow a[n-1]
// h, kick b[n] h.
struct SplittingScheme {
  static constexpr std::size_t kMostFlows = 12;
  std::size_t flows = 0;                  // n
  std::array<double, kMostFlows> a = {};  // fractions of the step for flows; the first n are used
  std::array<double, kMostFlows + 1> b = {};  // for kicks; the first n + 1 are used
  // The middle kick adds this times h^3 times the gradient of torque . I^-1 torque / 2; 0: no such
  // term.
  double gradient = 0.0;
};

// The composition of (kick h/2, flow h, kick h/2) with these fractions of the step, which must be
// symmetric and at most kMostFlows.
template <std::size_t N>
constexpr SplittingScheme composition(const std::array<double, N>& fractions) {
  SplittingScheme scheme;
  scheme.flows = N;
  for (std::size_t i = 0; i < N; ++i) {
    scheme.a[i] = fractions[i];
    scheme.b[i] += 0.5 * fractions[i];
    scheme.b[i + 1] += 0.5 * fractions[i];
  }
  return scheme;
}

// A stepper made of kicks and flows. Flow is constructed from a BodyModel; flow(h, q, y) advances q
// and y by the motion of the free body, exactly or to second order, symmetric in time. A kick keeps
// L.up and a flow keeps L in space. Kicks are symplectic maps, so the method is symplectic if Flow
// is. Torques other than that of gravity are ignored.
template <class Flow>
class Splitting final : public Stepper {
 public:
  Splitting(const BodyModel& model, const SplittingScheme& scheme)
      : flow_(model),
        scheme_(scheme),
        heavy_(model.chi_P.squaredNorm() > 0.0),
        up_S_(model.up_S),
        chi_P_(model.chi_P),
        inverse_(model.inverse_moments) {}

  void step(double, double h, State& s, Work& work) const override {
    for (std::size_t i = 0; i < scheme_.flows; ++i) {
      if (heavy_) kick(i, h, s);
      flow_(scheme_.a[i] * h, s.q, s.y);
    }
    if (heavy_) kick(scheme_.flows, h, s);
    trim(s.q);
    work.evaluations += static_cast<long>(scheme_.flows) + (heavy_ ? 1 : 0);
  }

 private:
  Flow flow_;
  SplittingScheme scheme_;
  bool heavy_;
  Vec3 up_S_, chi_P_, inverse_;

  // dy/dt = gamma x chi with constant gamma; the gradient kick is that of the potential V -
  // gradient / (2 b) h^2 torque . I^-1 torque
  void kick(std::size_t i, double h, State& s) const {
    const Vec3 gamma = s.q.conjugate() * up_S_;
    const Vec3 torque = gamma.cross(chi_P_);
    s.y += scheme_.b[i] * h * torque;
    if (scheme_.gradient != 0.0 && 2 * i == scheme_.flows) {
      const Vec3 turned = inverse_.cwiseProduct(torque);
      s.y -= scheme_.gradient * h * h * h * gamma.cross(chi_P_.cross(turned));
    }
  }
};

}  // namespace polhode
