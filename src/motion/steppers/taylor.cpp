// SPDX-License-Identifier: MIT
// The Taylor series of the motion at the start of every step, by recurrence: in the right variables
// the equations of motion are quadratic, so that each further term is a sum of products of terms
// known before. Jorba and Zou, Experiment. Math. 14 (2005) 99; Barrio, Appl. Math. Comput. 163
// (2005) 525.
#include <array>
#include <cmath>

#include "base/system/wide_registers.h"
#include "motion/steppers/all.h"
#include "motion/steppers/derivative.h"
#include "motion/steppers/turn.h"

namespace polhode {
namespace {

constexpr int kMostCoefficients = 17;

// Four numbers that are added and multiplied together; two registers where they are short.
using Four [[gnu::vector_size(32)]] = double;

void put(const Vec3& v, Four& target) {
  target = Four{v.x(), v.y(), v.z(), 0.0};
}
Vec3 vec(const Four& v) {
  return {v[0], v[1], v[2]};
}

// Everything moves as dp/dt = (0, v) o p / 2, de/dt = v x e, dv/dt = bend o (v2 v3, v3 v1, v1 v2) +
// pull e. Term k of each, times h^k; p is (x, y, z, w). Terms are kept in the orders that products
// need, so that a product is one of whole registers.
struct Series {
  std::array<Four, kMostCoefficients> p, e, v;
  std::array<Four, kMostCoefficients> p1, p2, p3;  // of (0, v) o p, by v1, v2, v3
  std::array<Four, kMostCoefficients> v_left, v_right, e_left, e_right;  // (2, 3, 1) and (3, 1, 2)
  Four bend;
  std::array<Four, 3> pull;  // columns

  [[gnu::always_inline]] void set_p(std::size_t k, const Four& term) {
    p[k] = term;
    p1[k] = __builtin_shufflevector(term, term, 3, 2, 1, 0) * Four{1, -1, 1, -1};
    p2[k] = __builtin_shufflevector(term, term, 2, 3, 0, 1) * Four{1, 1, -1, -1};
    p3[k] = __builtin_shufflevector(term, term, 1, 0, 3, 2) * Four{-1, 1, 1, -1};
  }
  [[gnu::always_inline]] void set_v(std::size_t k, const Four& term) {
    v[k] = term;
    v_left[k] = __builtin_shufflevector(term, term, 1, 2, 0, 3);
    v_right[k] = __builtin_shufflevector(term, term, 2, 0, 1, 3);
  }
  [[gnu::always_inline]] void set_e(std::size_t k, const Four& term) {
    e[k] = term;
    e_left[k] = __builtin_shufflevector(term, term, 1, 2, 0, 3);
    e_right[k] = __builtin_shufflevector(term, term, 2, 0, 1, 3);
  }
};

// e is not needed where nothing pulls
template <bool Heavy>
[[gnu::always_inline]] inline void expand_terms(Series& s, std::size_t order, double h) {
  for (std::size_t k = 0; k < order; ++k) {
    // sums of products whose indices add up to k
    Four by1 = {}, by2 = {}, by3 = {}, vv = {}, cross = {};
    for (std::size_t j = 0; j <= k; ++j) {
      const Four& v = s.v[k - j];
      by1 += s.p1[j] * v[0];
      by2 += s.p2[j] * v[1];
      by3 += s.p3[j] * v[2];
      vv += s.v_left[j] * s.v_right[k - j];
      if constexpr (Heavy) cross += s.v_left[k - j] * s.e_right[j] - s.v_right[k - j] * s.e_left[j];
    }
    const double scale = h / static_cast<double>(k + 1);
    s.set_p(k + 1, 0.5 * scale * (by1 + by2 + by3));
    Four rate = s.bend * vv;
    if constexpr (Heavy) {
      s.set_e(k + 1, scale * cross);
      const Four& e = s.e[k];
      rate += s.pull[0] * e[0] + s.pull[1] * e[1] + s.pull[2] * e[2];
    }
    s.set_v(k + 1, scale * rate);
  }
}

POLHODE_WIDE_REGISTERS void expand(Series& series, std::size_t order, double h) {
  expand_terms<true>(series, order, h);
}
POLHODE_WIDE_REGISTERS void expand_free(Series& series, std::size_t order, double h) {
  expand_terms<false>(series, order, h);
}

// What both ways to see the body share: the series and its sum.
class Taylor : public Stepper {
 public:
  Taylor(const BodyModel& model, double momentum_scale, std::size_t order)
      : model_(model),
        norm_(model, momentum_scale),
        order_(order),
        heavy_(model.chi_P.squaredNorm() > 0.0) {}

  void step(double t, double h, State& s, Work& work) const override {
    step_with_error(t, h, s, work);
  }

 protected:
  // p at the end of the step and the change of v; the estimate is the size of the last term
  struct Sum {
    Quat p;
    Vec3 change_of_v;
    double last;
  };
  Sum sum(const Quat& p, const Vec3& e, const Vec3& v, double h) const {
    Series series;
    series.set_p(0, Four{p.x(), p.y(), p.z(), p.w()});
    series.set_e(0, Four{e.x(), e.y(), e.z(), 0.0});
    series.set_v(0, Four{v.x(), v.y(), v.z(), 0.0});
    put(bend_, series.bend);
    for (std::size_t i = 0; i < 3; ++i)
      put(pull_.col(static_cast<Eigen::Index>(i)), series.pull[i]);
    if (heavy_) {
      expand(series, order_, h);
    } else {
      expand_free(series, order_, h);
    }
    // the small terms first
    Four end = {}, change_of_v = {};
    for (std::size_t k = order_; k > 0; --k) {
      end += series.p[k];
      change_of_v += series.v[k];
    }
    end += series.p[0];
    const Four& last = series.p[order_];
    StateVector<kThreeDegrees> size;
    size << last[0], last[1], last[2], last[3], model_.moments.cwiseProduct(vec(series.v[order_]));
    return {normalized(Quat(end[3], end[0], end[1], end[2])),
            vec(change_of_v),
            norm_.of<kThreeDegrees>(size)};
  }

  BodyModel model_;
  ErrorNorm norm_;
  std::size_t order_;
  bool heavy_;
  Vec3 bend_ = Vec3::Zero();
  Mat3 pull_ = Mat3::Zero();
};

// Any body, seen in its own axes: p is the inverse of the attitude, e the vertical and v minus the
// angular velocity there.
class TaylorInBody final : public Taylor {
 public:
  TaylorInBody(const BodyModel& model, double momentum_scale, std::size_t order)
      : Taylor(model, momentum_scale, order) {
    const Vec3& I = model.moments;
    bend_ = -model.inverse_moments.cwiseProduct(Vec3(I[1] - I[2], I[2] - I[0], I[0] - I[1]));
    pull_ = model.inverse_moments.asDiagonal() * hat(model.chi_P);
  }

  double step_with_error(double, double h, State& s, Work& work) const override {
    const Sum end =
        sum(s.q.conjugate(), up_in_body(model_, s.q), -angular_velocity(model_, s.y), h);
    s.q = end.p.conjugate();
    // y itself is not divided by the moments and multiplied again: in a steady motion the same
    // rounding at each step would add up
    s.y -= model_.moments.cwiseProduct(end.change_of_v);
    ++work.evaluations;
    return end.last;
  }
};

// A symmetric body with its centre of mass on its axis, seen from space and without its own spin,
// which is uniform: q = p o exp(rate t axis), and p turns by v = L / I1. Slower, and v bends by no
// product.
class TaylorInSpace final : public Taylor {
 public:
  TaylorInSpace(const BodyModel& model, double momentum_scale, std::size_t order)
      : Taylor(model, momentum_scale, order),
        axis_(model.kind.axis),
        across_(model.inverse_moments[(axis_ + 1) % 3]),
        difference_(model.inverse_moments[axis_] - across_) {
    pull_ = across_ * model.chi_P[axis_] * hat(model.up_S);
  }

  double step_with_error(double, double h, State& s, Work& work) const override {
    const double spin = s.y[axis_];
    const Vec3 v = across_ * momentum_in_space(s);
    const Sum end = sum(s.q, s.q * Vec3::Unit(axis_), v, h);
    s.q = end.p;
    s.y = s.q.conjugate() * ((v + end.change_of_v) / across_);
    s.y[axis_] = spin;
    turn_about_axis(axis_, h * difference_ * spin, s.q, s.y);
    ++work.evaluations;
    return end.last;
  }

 private:
  int axis_;           // of symmetry
  double across_;      // 1 / moment across it
  double difference_;  // 1 / moment along it, less across_
};

std::unique_ptr<Stepper> make(const BodyModel& model, double momentum_scale, std::size_t order) {
  if (center_on_symmetry_axis(model))
    return std::make_unique<TaylorInSpace>(model, momentum_scale, order);
  return std::make_unique<TaylorInBody>(model, momentum_scale, order);
}

}  // namespace

std::unique_ptr<Stepper> make_taylor10(const BodyModel& model, double momentum_scale) {
  return make(model, momentum_scale, 10);
}
std::unique_ptr<Stepper> make_taylor16(const BodyModel& model, double momentum_scale) {
  return make(model, momentum_scale, 16);
}

}  // namespace polhode
