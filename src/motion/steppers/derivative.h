// SPDX-License-Identifier: MIT
// The state as a vector of numbers and its time derivative, for methods on vectors (Runge-Kutta,
// Taylor, Gauss): seven numbers with three degrees of freedom, thirteen with six, and six in
// gimbals.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "math/so3.h"
#include "model/body_model.h"
#include "motion/scales.h"
#include "motion/stepper.h"
#include "motion/steppers/lanes.h"

namespace polhode {

// (q.x, q.y, q.z, q.w, y1, y2, y3), with six degrees of freedom followed by place_S and
// linear_momentum_S; in gimbals their three angles and the rates of these. Units as in State.
template <int N>
using StateVector = Eigen::Matrix<double, N, 1>;
// The values of N with three and with six degrees of freedom, and in gimbals.
inline constexpr int kThreeDegrees = 7;
inline constexpr int kSixDegrees = 13;
inline constexpr int kInGimbals = 6;

// The vector of a state.
template <int N>
StateVector<N> to_vector(const State& s) {
  StateVector<N> v;
  if constexpr (N == kInGimbals) {
    v << s.rings.angles, s.rings.rates;
  } else if constexpr (N == kThreeDegrees) {
    v << s.q.coeffs(), s.y;
  } else {
    v << s.q.coeffs(), s.y, s.place_S, s.linear_momentum_S;
  }
  return v;
}

// Stores a vector in a state and normalises the quaternion. Members of the state that the vector
// does not contain are not changed.
template <int N>
void set_state(const BodyModel& m, const StateVector<N>& v, State& s) {
  if constexpr (N == kInGimbals) {
    set_rings(m, {v.template head<3>(), v.template tail<3>()}, s);
  } else {
    s.q = normalized(Quat(Eigen::Vector4d(v.template head<4>())));
    s.y = v.template segment<3>(4);
  }
  if constexpr (N == kSixDegrees) {
    s.place_S = v.template segment<3>(7);
    s.linear_momentum_S = v.template segment<3>(10);
  }
}

// The same without gimbals, of a vector whose quaternion has unit length.
template <class Vector>
void set_unit_state(const Vector& v, State& s) {
  s.q = Quat(v[3], v[0], v[1], v[2]);
  s.y = Vec3(v[4], v[5], v[6]);
}

// The state of a vector without gimbals. The quaternion is not normalised: inside a step it leaves
// the unit sphere.
template <int N>
State raw_state(const StateVector<N>& v) {
  State s;
  s.q = Quat(Eigen::Vector4d(v.template head<4>()));
  s.y = v.template segment<3>(4);
  if constexpr (N == kSixDegrees) {
    s.place_S = v.template segment<3>(7);
    s.linear_momentum_S = v.template segment<3>(10);
  }
  return s;
}

// What heavy_rate() (motion/steppers/lanes.h) needs of a model.
inline HeavyBody<double> heavy_body(const BodyModel& m) {
  const auto three = [](const Vec3& v) {
    return std::array<double, 3>{v.x(), v.y(), v.z()};
  };
  return {three(m.inverse_moments), three(m.chi_P), three(m.up_S)};
}

// The right-hand side dv/dt at time t (s). The stages of a step leave the unit sphere; q is not
// normalised here, so that the vector field stays smooth and the method keeps its order.
template <int N>
StateVector<N> derivative(const BodyModel& m, double t, const StateVector<N>& v) {
  if constexpr (N == kInGimbals) {
    State s;
    set_state<N>(m, v, s);
    const Vec3 others = up_in_body(m, s.q).cross(m.chi_P) + torque_of_loads(m, t, s);
    StateVector<N> rate;
    rate << s.rings.rates, accelerations(*m.loads.gimbals, s.rings, m.moments, others);
    return rate;
  } else {
    StateVector<N> rate;
    heavy_rate(heavy_body(m), v.data(), rate.data());
    if (!m.loads.turning.empty()) {
      rate.template segment<3>(4) += torque_of_loads(m, t, raw_state<N>(v));
    }
    if constexpr (N == kSixDegrees) {
      rate.template segment<3>(7) = v.template segment<3>(10) / m.body.mass;
      rate.template segment<3>(10) = force(m, t, raw_state<N>(v));
    }
    return rate;
  }
}

// The norm of a difference of states: the largest of the norms of q (in gimbals, of half the
// angles), of y over a typical momentum (in gimbals, of their rates, as size_of_rates() has it,
// over the rate that goes with it), and with six degrees of freedom of the place over the radius of
// gyration and of the linear momentum over linear_momentum_scale(). Dimensionless.
class ErrorNorm {
 public:
  // momentum_scale: a typical |y|, kg m^2/s.
  ErrorNorm(const BodyModel& model, double momentum_scale)
      : momentum_scale_(momentum_scale),
        rate_scale_(momentum_scale / model.moments.maxCoeff()),
        length_scale_(std::sqrt(model.moments.maxCoeff() / model.body.mass)),
        linear_momentum_scale_(linear_momentum_scale(model, momentum_scale)),
        moment_(model.moments.maxCoeff()),
        gimbals_(model.loads.gimbals) {}

  double momentum_scale() const { return momentum_scale_; }

  // of v, an error in a step of h (s) from `start`
  template <int N>
  double of(const StateVector<N>& v,
            [[maybe_unused]] const StateVector<N>& start,
            [[maybe_unused]] double h) const {
    if constexpr (N == kInGimbals) {
      const double rates =
          size_of_rates(*gimbals_, start[1], std::abs(h * start[4]), moment_, v.template tail<3>());
      return std::max(0.5 * v.template head<3>().norm(), rates / rate_scale_);
    } else {
      return of<N>(v);
    }
  }

  // the same without gimbals, where it is all one from where
  template <int N>
  double of(const StateVector<N>& v) const {
    double size =
        std::max(v.template head<4>().norm(), v.template segment<3>(4).norm() / momentum_scale_);
    if constexpr (N == kSixDegrees) {
      size = std::max({size,
                       v.template segment<3>(7).norm() / length_scale_,
                       v.template segment<3>(10).norm() / linear_momentum_scale_});
    }
    return size;
  }

 private:
  double momentum_scale_;         // kg m^2/s
  double rate_scale_;             // rad/s
  double length_scale_;           // m
  double linear_momentum_scale_;  // kg m/s
  double moment_;                 // kg m^2
  std::optional<Gimbals> gimbals_;
};

// Makes a Method<N>(model, arguments...) with the N that the model needs.
template <template <int> class Method, class... Arguments>
std::unique_ptr<Stepper> make_on_vector(const BodyModel& model, Arguments... arguments) {
  if (model.loads.gimbals) return std::make_unique<Method<kInGimbals>>(model, arguments...);
  if (model.with_translation) return std::make_unique<Method<kSixDegrees>>(model, arguments...);
  return std::make_unique<Method<kThreeDegrees>>(model, arguments...);
}

}  // namespace polhode
