// SPDX-License-Identifier: MIT
// Splittings of H = T(y) + V(gamma) into flows that are known exactly: rotations about one
// principal axis (McLachlan 1993, Reich 1994), the symmetric top and a remainder (Hairer, Lubich,
// Wanner, Geometric Numerical Integration, VII.5.3), and the kick by gravity. All are symmetric,
// symplectic and exact in L.
#include <array>
#include <cmath>
#include <limits>

#include "math/so3.h"
#include "motion/steppers/all.h"

namespace polhode {
namespace {

// v turned by minus this angle about a coordinate axis
void turn_back(Vec3& v, int axis, double angle) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double c = std::cos(angle), s = std::sin(angle);
  const double vi = v[i], vj = v[j];
  v[i] = c * vi + s * vj;
  v[j] = c * vj - s * vi;
}

// the flow of k y_axis^2 / 2: the body turns about that axis
void axis_flow(int axis, double k, double h, State& s) {
  const double angle = h * k * s.y[axis];
  turn_back(s.y, axis, angle);
  s.q = s.q * exp_rotation(angle * Vec3::Unit(axis));
}

// the flow of V: gravity turns y, the attitude stands
void kick(const Model& m, double h, State& s) {
  s.y += h * up_in_body(m, s.q).cross(m.chi_P);
}

// T as three rotations, of second order.
struct ThreeRotations {
  explicit ThreeRotations(const Model& m) : inverse(m.inverse_moments) {}

  void flow(double h, State& s) const {
    axis_flow(0, inverse[0], 0.5 * h, s);
    axis_flow(1, inverse[1], 0.5 * h, s);
    axis_flow(2, inverse[2], h, s);
    axis_flow(1, inverse[1], 0.5 * h, s);
    axis_flow(0, inverse[0], 0.5 * h, s);
  }

  Vec3 inverse;
};

// T as that of a symmetric top and what is left, of second order; exact when two moments are equal.
// The two are those with the nearest 1/I.
struct SymmetricAndRemainder {
  explicit SymmetricAndRemainder(const Model& m) {
    double least = std::numeric_limits<double>::infinity();
    for (int third = 0; third < 3; ++third) {
      const int one = (third + 1) % 3, other = (third + 2) % 3;
      const double apart = m.inverse_moments[one] - m.inverse_moments[other];
      // a rotator's zero is no 1/I
      const bool real = m.moments[one] > 0.0 && m.moments[other] > 0.0;
      if (!real || std::abs(apart) >= least) continue;
      least = std::abs(apart);
      figure = third;
      odd = one;
      remainder = apart;
      across = m.inverse_moments[other];
      along = m.moments[third] > 0.0 ? m.inverse_moments[third] - across : 0.0;
    }
  }

  void flow(double h, State& s) const {
    if (remainder != 0.0) axis_flow(odd, remainder, 0.5 * h, s);
    const double spin = h * along * s.y[figure];
    s.q = s.q * exp_rotation(h * across * s.y) * exp_rotation(spin * Vec3::Unit(figure));
    turn_back(s.y, figure, spin);
    if (remainder != 0.0) axis_flow(odd, remainder, 0.5 * h, s);
  }

  int figure = 2, odd = 0;  // axis of the symmetric top; of the remainder
  double across = 1.0;      // 1/I across the figure axis
  double along = 0.0;       // 1/I3 - 1/I1
  double remainder = 0.0;   // 1/I of the odd axis beyond `across`
};

// Palindromic compositions of a method of second order: w1, w2, ..., w_middle, ..., w2, w1.
struct Once {
  static constexpr std::array<double, 1> kWeights = {1.0};
};
// M. Suzuki, Phys. Lett. A 146 (1990) 319: five stages of 1/(4 - 4^(1/3))
struct Suzuki4 {
  static constexpr double kOuter = 0.41449077179437573714;
  static constexpr std::array<double, 3> kWeights = {kOuter, kOuter, 1.0 - 4.0 * kOuter};
};
// H. Yoshida, Phys. Lett. A 150 (1990) 262, table 1, solution A
struct Yoshida6 {
  static constexpr double k1 = 0.78451361047755726382;
  static constexpr double k2 = 0.23557321335935813368;
  static constexpr double k3 = -1.17767998417887100695;
  static constexpr std::array<double, 4> kWeights = {k1, k2, k3, 1.0 - 2.0 * (k1 + k2 + k3)};
};

// runs `flow` with each weight in order and back
template <class Composition, class Flow>
void composed_flow(double h, const Flow& flow) {
  constexpr auto& weights = Composition::kWeights;
  for (const double weight : weights)
    flow(weight * h);
  for (std::size_t i = weights.size() - 1; i-- > 0;)
    flow(weights[i] * h);
}

// A composition of half a kick, the flow of T, half a kick.
template <class Kinetic, class Composition>
class Splitting final : public Stepper {
 public:
  explicit Splitting(const Model& model)
      : model_(model), kinetic_(model), heavy_(model.chi_P.squaredNorm() > 0.0) {}

  void step(double, double h, State& s) override {
    composed_flow<Composition>(h, [&](double part) {
      if (heavy_) kick(model_, 0.5 * part, s);
      kinetic_.flow(part, s);
      if (heavy_) kick(model_, 0.5 * part, s);
      ++evaluations_;
    });
    s.q = normalized(s.q);
  }

 private:
  Model model_;
  Kinetic kinetic_;
  bool heavy_;
};

// Kicks between flows of T that are exact, or of order six: b1 a1 b2 a2 ... with the lists
// mirrored. Legal because {V, {V, T}} depends on the attitude alone (Runge-Kutta-Nystroem). S.
// Blanes and P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313, tables 2 and 3.
struct Srkn6b {
  static constexpr std::array<double, 3> kFlow = {
      0.245298957184271, 0.604872665711080, -0.350171622895351};
  static constexpr std::array<double, 3> kKick = {
      0.0829844064174052, 0.396309801498368, -0.0390563049223486};
  static constexpr bool kEndsInFlow = false;  // the middle is a kick
};
struct Srkn11b {
  static constexpr std::array<double, 5> kFlow = {0.123229775946271,
                                                  0.290553797799558,
                                                  -0.127049212625417,
                                                  -0.246331761062075,
                                                  0.357208872795928};
  static constexpr std::array<double, 6> kKick = {0.0414649985182624,
                                                  0.198128671918067,
                                                  -0.0400061921041533,
                                                  0.0752539843015807,
                                                  -0.0115113874206879,
                                                  0.23666992478693110};
  static constexpr bool kEndsInFlow = true;  // the middle is a flow
};

template <class Table>
class KickAndFlow final : public Stepper {
 public:
  explicit KickAndFlow(const Model& model) : model_(model), kinetic_(model) {}

  void step(double, double h, State& s) override {
    constexpr auto& flows = Table::kFlow;
    constexpr auto& kicks = Table::kKick;
    for (std::size_t i = 0; i < flows.size(); ++i) {
      kick(model_, kicks[i] * h, s);
      flow(flows[i] * h, s);
    }
    if constexpr (Table::kEndsInFlow) {
      double rest = 1.0;
      for (const double a : flows)
        rest -= 2.0 * a;
      kick(model_, kicks.back() * h, s);
      flow(rest * h, s);
      kick(model_, kicks.back() * h, s);
    } else {
      double rest = 1.0;
      for (const double b : kicks)
        rest -= 2.0 * b;
      kick(model_, rest * h, s);
    }
    for (std::size_t i = flows.size(); i-- > 0;) {
      flow(flows[i] * h, s);
      kick(model_, kicks[i] * h, s);
    }
    s.q = normalized(s.q);
  }

 private:
  void flow(double h, State& s) {
    // exact in one go when two moments are equal
    if (kinetic_.remainder == 0.0) {
      kinetic_.flow(h, s);
    } else {
      composed_flow<Yoshida6>(h, [&](double part) { kinetic_.flow(part, s); });
    }
    ++evaluations_;
  }

  Model model_;
  SymmetricAndRemainder kinetic_;
};

}  // namespace

std::unique_ptr<Stepper> make_three_rotations(const Model& model, double) {
  return std::make_unique<Splitting<ThreeRotations, Once>>(model);
}

std::unique_ptr<Stepper> make_symmetric_remainder2(const Model& model, double) {
  return std::make_unique<Splitting<SymmetricAndRemainder, Once>>(model);
}

std::unique_ptr<Stepper> make_symmetric_remainder4(const Model& model, double) {
  return std::make_unique<Splitting<SymmetricAndRemainder, Suzuki4>>(model);
}

std::unique_ptr<Stepper> make_symmetric_remainder6(const Model& model, double) {
  return std::make_unique<Splitting<SymmetricAndRemainder, Yoshida6>>(model);
}

std::unique_ptr<Stepper> make_kick_srkn6(const Model& model, double) {
  return std::make_unique<KickAndFlow<Srkn6b>>(model);
}

std::unique_ptr<Stepper> make_kick_srkn11(const Model& model, double) {
  return std::make_unique<KickAndFlow<Srkn11b>>(model);
}

}  // namespace polhode
