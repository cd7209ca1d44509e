// SPDX-License-Identifier: MIT
// The collocation methods of Gauss with two and three stages on the state as a vector: they keep
// every quadratic invariant, so energy (gravity included) and |y|, but not L in space, which is of
// third degree in (q, y). Hairer, Lubich, Wanner, GNI, II.1.3 and IV.2.1.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/steppers/all.h"
#include "motion/steppers/derivative.h"
#include "motion/steppers/no_solution.h"

namespace polhode {
namespace {

template <int Stages>
struct GaussTable;

template <>
struct GaussTable<2> {
  static constexpr double kRoot = 1.73205080756887729353;  // of 3
  static constexpr const char* kName = "gauss4";
  static constexpr std::array<double, 2> kB = {0.5, 0.5};
  static constexpr std::array<double, 2> kC = {0.5 - kRoot / 6, 0.5 + kRoot / 6};
  static constexpr std::array<std::array<double, 2>, 2> kA = {
      {{0.25, 0.25 - kRoot / 6}, {0.25 + kRoot / 6, 0.25}}};
};

template <>
struct GaussTable<3> {
  static constexpr double kRoot = 3.87298334620741688518;  // of 15
  static constexpr const char* kName = "gauss6";
  static constexpr std::array<double, 3> kB = {5.0 / 18, 4.0 / 9, 5.0 / 18};
  static constexpr std::array<double, 3> kC = {0.5 - kRoot / 10, 0.5, 0.5 + kRoot / 10};
  static constexpr std::array<std::array<double, 3>, 3> kA = {
      {{5.0 / 36, 2.0 / 9 - kRoot / 15, 5.0 / 36 - kRoot / 30},
       {5.0 / 36 + kRoot / 24, 2.0 / 9, 5.0 / 36 - kRoot / 24},
       {5.0 / 36 + kRoot / 30, 2.0 / 9 + kRoot / 15, 5.0 / 36}}};
};

template <int N, int Stages>
class Gauss final : public Stepper {
 public:
  Gauss(const BodyModel& model, double momentum_scale)
      : model_(model), norm_(model, momentum_scale) {}

  void step(double t, double h, State& s, Work& work) const override {
    const Vector v = to_vector<N>(s);
    std::array<Vector, Stages> k;
    k.fill(derivative<N>(model_, t, v));
    solve(t, h, v, s.y, k, work);
    Vector change = Vector::Zero();
    for (int i = 0; i < Stages; ++i)
      change += Table::kB[i] * k[i];
    set_state<N>(model_, v + h * change, s);
  }

 private:
  using Vector = StateVector<N>;
  using Table = GaussTable<Stages>;

  static constexpr int kMostIterations = 200;

  BodyModel model_;
  ErrorNorm norm_;

  // fixed-point iteration for the slopes of the stages, until round-off stops it
  void solve(double t,
             double h,
             const Vector& v,
             const Vec3& y,
             std::array<Vector, Stages>& k,
             Work& work) const {
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      double change = 0.0;
      std::array<Vector, Stages> next;
      for (int i = 0; i < Stages; ++i) {
        Vector stage = Vector::Zero();
        for (int j = 0; j < Stages; ++j)
          stage += Table::kA[i][j] * k[j];
        next[i] = derivative<N>(model_, t + Table::kC[i] * h, v + h * stage);
        change = std::max(change, norm_.template of<N>(h * (next[i] - k[i]), v, h));
      }
      work.evaluations += Stages;
      k = next;
      if (change <= std::numeric_limits<double>::epsilon()) return;
      if (change >= last && change <= 1e-13) return;
      if (!std::isfinite(change)) break;
      last = change;
    }
    throw no_solution(
        Table::kName, t, h, model_, y, "its fixed-point iteration contracts below about 1");
  }
};

template <int N>
using Gauss4 = Gauss<N, 2>;
template <int N>
using Gauss6 = Gauss<N, 3>;

}  // namespace

std::unique_ptr<Stepper> make_gauss4(const BodyModel& model, double momentum_scale) {
  return make_on_vector<Gauss4>(model, momentum_scale);
}

std::unique_ptr<Stepper> make_gauss6(const BodyModel& model, double momentum_scale) {
  return make_on_vector<Gauss6>(model, momentum_scale);
}

}  // namespace polhode
