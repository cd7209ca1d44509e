// SPDX-License-Identifier: MIT
// Dormand and Prince's method of order 8 with twelve stages and an error estimate from two embedded
// ones of order 5 and 3, for any vector. Coefficients: Hairer, Norsett, Wanner, Solving Ordinary
// Differential Equations I, 2nd edition 1993, II.5 and II.10, to 25 digits.
#pragma once

#include <array>

#include "motion/steppers/lanes.h"

namespace polhode::dormand_prince {

inline constexpr int kStages = 12;

// one row: the slopes of stages `from..` that a stage needs besides that of the first
struct TableRow {
  double c;      // time of the stage, in steps
  double first;  // weight of the first slope
  int from;      // index of the first slope in `rest`
  int count;
  std::array<double, 8> rest;
};

// clang-format off
inline constexpr std::array<TableRow, kStages - 1> kRows = {{
    {0.0526001519587677318785587544488, 0.0526001519587677318785587544488, 1, 0, {}},
    {0.0789002279381515978178381316732, 0.0197250569845378994544595329183, 1, 1, {0.0591751709536136983633785987549}},
    {0.118350341907227396726757197510, 0.0295875854768068491816892993775, 2, 1, {0.0887627564304205475450678981324}},
    {0.281649658092772603273242802490, 0.241365134159266685502369798665, 2, 2, {-0.884549479328286085344864962717, 0.924834003261792003115737966543}},
    {1.0 / 3, 0.037037037037037037037037037037, 3, 2, {0.170828608729473871279604482173, 0.125467687566822425016691814123}},
    {0.25, 0.037109375, 3, 3, {0.170252211019544039314978060272, 0.0602165389804559606850219397283, -0.017578125}},
    {4.0 / 13, 0.0370920001185047927108779319836, 3, 4, {0.170383925712239993810214054705, 0.107262030446373284651809199168, -0.0153194377486244017527936158236, 0.00827378916381402288758473766002}},
    {0.651282051282051282051282051282, 0.624110958716075717114429577812, 3, 5, {-3.36089262944694129406857109825, -0.868219346841726006818189891453, 27.5920996994467083049415600797, 20.1540675504778934086186788979, -43.4898841810699588477366255144}},
    {0.6, 0.477662536438264365890433908527, 3, 6, {-2.48811461997166764192642586468, -0.590290826836842996371446475743, 21.2300514481811942347288949897, 15.2792336328824235832596922938, -33.2882109689848629194453265587, -0.0203312017085086261358222928593}},
    {6.0 / 7, -0.93714243008598732571704021658, 3, 7, {5.18637242884406370830023853209, 1.09143734899672957818500254654, -8.14978701074692612513997267357, -18.5200656599969598641566180701, 22.7394870993505042818970056734, 2.49360555267965238987089396762, -3.0467644718982195003823669022}},
    {1.0, 2.27331014751653820792359768449, 3, 8, {-10.5344954667372501984066689879, -2.00087205822486249909675718444, -17.9589318631187989172765950534, 27.9488845294199600508499808837, -2.85899827713502369474065508674, -8.87285693353062954433549289258, 12.3605671757943030647266201528, 0.643392746015763530355970484046}},
}};

// weights of the first slope and of slopes 5 to 11: the step, and its difference from order 5
inline constexpr std::array<double, 8> kStepWeights = {
    0.0542937341165687622380535766363, 4.45031289275240888144113950566, 1.89151789931450038304281599044,
    -5.8012039600105847814672114227, 0.31116436695781989440891606237, -0.152160949662516078556178806805,
    0.201365400804030348374776537501, 0.0447106157277725905176885569043};
inline constexpr std::array<double, 8> kError5 = {
    0.01312004499419488073250102996, -1.225156446376204440720569753, -0.4957589496572501915214079952,
    1.664377182454986536961530415, -0.3503288487499736816886487290, 0.3341791187130174790297318841,
    0.08192320648511571246570742613, -0.02235530786388629525884427845};
// the embedded method of order 3 has slopes 0, 8 and 11
inline constexpr double kThird0 = 0.244094488188976377952755905512;
inline constexpr double kThird8 = 0.733846688281611857341361741547;
inline constexpr double kThird11 = 0.0220588235294117647058823529412;
// clang-format on

// What a step moves by, per time, and the two estimates of its error.
template <class Vector>
struct Slopes {
  Vector step, error5, error3;
};

// The step of h from v; rate(c, v) is the right-hand side c h after its start. For one motion h is
// a number, for several in the lanes of registers it has lanes too.
template <class Vector, class Length, class Rate>
[[gnu::always_inline]] inline Slopes<Vector> slopes_of(const Vector& v,
                                                       const Length& h,
                                                       const Rate& rate) {
  std::array<Vector, kStages> k;
  k[0] = rate(0.0, v);
#pragma GCC unroll 11
  for (int i = 0; i + 1 < kStages; ++i) {
    const TableRow& row = kRows[i];
    Vector sum = row.first * k[0];
#pragma GCC unroll 8
    for (int j = 0; j < row.count; ++j)
      sum += row.rest[j] * k[row.from + j];
    k[i + 1] = rate(row.c, v + h * sum);
  }
  Slopes<Vector> found;
  found.step = kStepWeights[0] * k[0];
  found.error5 = kError5[0] * k[0];
#pragma GCC unroll 7
  for (int j = 1; j < 8; ++j) {
    found.step += kStepWeights[j] * k[j + 4];
    found.error5 += kError5[j] * k[j + 4];
  }
  found.error3 = found.step - kThird0 * k[0] - kThird8 * k[8] - kThird11 * k[11];
  return found;
}

// HNW II.10, eq. 10.17: an error of the eighth power of the step
template <class Number>
[[gnu::always_inline]] inline Number error_of(const Number& fifth, const Number& third) {
  Number root = fifth * fifth + 0.01 * third * third;
  const auto is_zero = root == 0.0;
  take_root(root);
  return is_zero ? Number{} : fifth * fifth / root;
}

// The change of v in a step h (s) from t (s), where slope(t, v) is dv/dt and size(v) the norm of an
// error. Sets `error` to the estimate of the local error.
template <class Vector, class Slope, class Size>
Vector step_of_order_8(
    double t, double h, const Vector& v, const Slope& slope_at, const Size& size, double& error) {
  const Slopes<Vector> slopes = slopes_of(
      v, h, [&](double c, const Vector& at) -> Vector { return slope_at(t + c * h, at); });
  error = error_of(size(Vector(h * slopes.error5)), size(Vector(h * slopes.error3)));
  return h * slopes.step;
}

}  // namespace polhode::dormand_prince
