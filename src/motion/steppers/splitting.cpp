// SPDX-License-Identifier: MIT
// The splitting methods of the table: three rotations, a symmetric body and a remainder, and kicks
// between exact motions of the free body.
#include "motion/steppers/splitting.h"

#include <cmath>

#include "motion/steppers/all.h"
#include "motion/steppers/free_flow.h"

namespace polhode {
namespace {

// T = sum y_i^2 / 2 I_i: each term turns the body about an axis, GNI VII.5.3; symmetric order
// 1 2 3 2 1 (McLachlan, Phys. Rev. Lett. 71 (1993) 3043; Reich, Physica D 76 (1994) 375).
class ThreeRotations {
 public:
  explicit ThreeRotations(const BodyModel& model) : inverse_(model.inverse_moments) {}

  void operator()(double h, Quat& q, Vec3& y) const {
    turn(0, 0.5 * h, q, y);
    turn(1, 0.5 * h, q, y);
    turn(2, h, q, y);
    turn(1, 0.5 * h, q, y);
    turn(0, 0.5 * h, q, y);
  }

 private:
  Vec3 inverse_;

  void turn(int k, double h, Quat& q, Vec3& y) const {
    turn_about_axis(k, h * y[k] * inverse_[k], q, y);
  }
};

// T = T of a symmetric body + (1/I_j - 1/I_i) y_j^2 / 2, the remainder being a turn about axis j
// (Dullweber, Leimkuhler, McLachlan, J. Chem. Phys. 107 (1997) 5840; GNI VII.5.3). i and j are the
// two axes whose inverse moments are closest; among the splittings this has the least remainder
// (Fasso, J. Comput. Phys. 189 (2003) 527).
class SymmetricRemainder {
 public:
  explicit SymmetricRemainder(const BodyModel& model) {
    const Vec3& inverse = model.inverse_moments;
    double least = std::abs(inverse[0] - inverse[1]);
    for (int k = 0; k < 2; ++k) {
      const double apart = std::abs(inverse[k + 1] - inverse[(k + 2) % 3]);
      if (apart >= least) continue;
      least = apart;
      axis_ = k;
    }
    const int i = (axis_ + 1) % 3;
    aside_ = (axis_ + 2) % 3;
    across_ = inverse[i];
    difference_ = inverse[axis_] - across_;
    remainder_ = inverse[aside_] - across_;
  }

  void operator()(double h, Quat& q, Vec3& y) const {
    turn_about_axis(aside_, 0.5 * h * remainder_ * y[aside_], q, y);
    q = q * turn_by(h * across_ * y);
    turn_about_axis(axis_, h * difference_ * y[axis_], q, y);
    turn_about_axis(aside_, 0.5 * h * remainder_ * y[aside_], q, y);
  }

 private:
  int axis_ = 2;       // of symmetry
  int aside_ = 0;      // of the remainder
  double across_;      // 1 / moment across the axis of symmetry
  double difference_;  // 1 / moment along it, less across_
  double remainder_;   // 1 / I_j - 1 / I_i
};

constexpr SplittingScheme kStrang = composition<1>({1.0});

// Suzuki, Phys. Lett. A 146 (1990) 319: 1 / (4 - 4^(1/3))
constexpr double kSuzuki = 0.41449077179437573714;
constexpr SplittingScheme kSuzuki4 =
    composition<5>({kSuzuki, kSuzuki, 1.0 - 4.0 * kSuzuki, kSuzuki, kSuzuki});

// Kahan and Li, Math. Comp. 66 (1997) 1089: order 6 with 9 stages (GNI V.3.11)
constexpr double kKahanLi[] = {0.39216144400731413928,
                               0.33259913678935943860,
                               -0.70624617255763935981,
                               0.08221359629355080023};
constexpr SplittingScheme kKahanLi6 = composition<9>({kKahanLi[0],
                                                      kKahanLi[1],
                                                      kKahanLi[2],
                                                      kKahanLi[3],
                                                      0.79854399093482996340,
                                                      kKahanLi[3],
                                                      kKahanLi[2],
                                                      kKahanLi[1],
                                                      kKahanLi[0]});

// Chin, Phys. Lett. A 226 (1997) 344, scheme A: kick h/6, kick 2h/3 with gradient, kick h/6
constexpr SplittingScheme kChin4 = {2, {0.5, 0.5}, {1.0 / 6, 2.0 / 3, 1.0 / 6}, 1.0 / 36};

// Blanes and Moan, J. Comput. Appl. Math. 142 (2002) 313, table 3: Runge-Kutta-Nystroem splittings
// SRKN 6b (order 4) and 11b (order 6). Legal here: [V, [V, [T, V]]] depends on the attitude alone.
// clang-format off
constexpr SplittingScheme kSrkn6 = {
    6,
    { 0.245298957184271, 0.604872665711080, -0.350171622895351, -0.350171622895351,
      0.604872665711080, 0.245298957184271},
    { 0.0829844064174052, 0.396309801498368, -0.0390563049223486, 0.1195241940131508,
     -0.0390563049223486, 0.396309801498368, 0.0829844064174052},
    0.0};
constexpr SplittingScheme kSrkn11 = {
    11,
    { 0.123229775946271,  0.290553797799558, -0.127049212625417, -0.246331761062075,
      0.357208872795928,  0.204777054291470,  0.357208872795928, -0.246331761062075,
     -0.127049212625417,  0.290553797799558,  0.123229775946271},
    { 0.0414649985182624,  0.198128671918067, -0.0400061921041533, 0.0752539843015807,
     -0.0115113874206879,  0.2366699247869311, 0.2366699247869311, -0.0115113874206879,
      0.0752539843015807, -0.0400061921041533, 0.198128671918067,  0.0414649985182624},
    0.0};
// clang-format on

template <class Flow>
std::unique_ptr<Stepper> make(const BodyModel& model, const SplittingScheme& scheme) {
  return std::make_unique<Splitting<Flow>>(model, scheme);
}

}  // namespace

std::unique_ptr<Stepper> make_three_rotations(const BodyModel& model, double) {
  return make<ThreeRotations>(model, kStrang);
}

std::unique_ptr<Stepper> make_symmetric_remainder2(const BodyModel& model, double) {
  return make<SymmetricRemainder>(model, kStrang);
}

std::unique_ptr<Stepper> make_symmetric_remainder4(const BodyModel& model, double) {
  return make<SymmetricRemainder>(model, kSuzuki4);
}

std::unique_ptr<Stepper> make_symmetric_remainder6(const BodyModel& model, double) {
  return make<SymmetricRemainder>(model, kKahanLi6);
}

std::unique_ptr<Stepper> make_kick_strang(const BodyModel& model, double) {
  return make<FreeFlow>(model, kStrang);
}

std::unique_ptr<Stepper> make_kick_suzuki4(const BodyModel& model, double) {
  return make<FreeFlow>(model, kSuzuki4);
}

std::unique_ptr<Stepper> make_kick_chin4(const BodyModel& model, double) {
  return make<FreeFlow>(model, kChin4);
}

std::unique_ptr<Stepper> make_kick_srkn6(const BodyModel& model, double) {
  return make<FreeFlow>(model, kSrkn6);
}

std::unique_ptr<Stepper> make_kick_srkn11(const BodyModel& model, double) {
  return make<FreeFlow>(model, kSrkn11);
}

}  // namespace polhode
