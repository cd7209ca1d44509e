// SPDX-License-Identifier: MIT
// The equations of motion for one motion or for several in the lanes of wide registers: written
// once, for any type of number, and with the same operations in the same order, so that a motion
// has the same bits in both.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace polhode {

// What the equations need of a body without loads besides gravity: 1/moments (1/(kg m^2)), chi_P
// (J) and up_S of BodyModel.
template <class Number>
struct HeavyBody {
  std::array<Number, 3> inverse_moments, chi, up;
};

// gamma, up_S in principal axes: up + 2 w up x u + 2 (up x u) x u + (|q|^2 - 1) up with
// u = (x, y, z), for q = (x, y, z, w) of any length.
template <class Number>
[[gnu::always_inline]] inline void find_up(const std::array<Number, 3>& up,
                                           const Number* q,
                                           std::array<Number, 3>& gamma) {
  const Number &x = q[0], &y = q[1], &z = q[2], &w = q[3];
  const auto& [up1, up2, up3] = up;
  Number c1 = up2 * z - up3 * y, c2 = up3 * x - up1 * z, c3 = up1 * y - up2 * x;
  c1 += c1;
  c2 += c2;
  c3 += c3;
  const Number off_sphere = ((x * x + z * z) + (y * y + w * w)) - 1.0;
  gamma[0] = ((up1 + w * c1) + (c2 * z - c3 * y)) + off_sphere * up1;
  gamma[1] = ((up2 + w * c2) + (c3 * x - c1 * z)) + off_sphere * up2;
  gamma[2] = ((up3 + w * c3) + (c1 * y - c2 * x)) + off_sphere * up3;
}

// The right-hand side of StateVector (motion/steppers/derivative.h) with three degrees of freedom:
// dq/dt = q o (0, w) / 2 and dy/dt = y x w + gamma x chi. v is (q.x, q.y, q.z, q.w, y1, y2, y3);
// rate, of the same length, is another array. q need not be of unit length: gamma is the quadratic
// form q* up q of it, with which d gamma/dt = gamma x w holds for every q, and the vector field
// keeps its quadratic invariants.
template <class Number>
[[gnu::always_inline]] inline void heavy_rate(const HeavyBody<Number>& body,
                                              const Number* v,
                                              Number* rate) {
  const Number &x = v[0], &y = v[1], &z = v[2], &w = v[3];
  const Number &L1 = v[4], &L2 = v[5], &L3 = v[6];
  const Number w1 = body.inverse_moments[0] * L1;
  const Number w2 = body.inverse_moments[1] * L2;
  const Number w3 = body.inverse_moments[2] * L3;
  rate[0] = 0.5 * ((w * w1 + y * w3) - z * w2);
  rate[1] = 0.5 * (w * w2 + (z * w1 - x * w3));
  rate[2] = 0.5 * ((w * w3 - y * w1) + x * w2);
  rate[3] = 0.5 * (-(y * w2) - (z * w3 + x * w1));

  std::array<Number, 3> gamma;
  find_up(body.up, v, gamma);
  const auto& [g1, g2, g3] = gamma;
  const auto& [chi1, chi2, chi3] = body.chi;
  rate[4] = (L2 * w3 - L3 * w2) + (g2 * chi3 - g3 * chi2);
  rate[5] = (L3 * w1 - L1 * w3) + (g3 * chi1 - g1 * chi3);
  rate[6] = (L1 * w2 - L2 * w1) + (g1 * chi2 - g2 * chi1);
}

// What such a body conserves: energy (J) and angular momentum about the vertical (kg m^2/s).
template <class Number>
struct HeavyInvariants {
  Number energy, momentum;
};
template <class Number>
[[gnu::always_inline]] inline HeavyInvariants<Number> heavy_invariants(
    const HeavyBody<Number>& body, const Number* v) {
  std::array<Number, 3> gamma;
  find_up(body.up, v, gamma);
  const auto& [chi1, chi2, chi3] = body.chi;
  const auto& [inverse1, inverse2, inverse3] = body.inverse_moments;
  const Number &L1 = v[4], &L2 = v[5], &L3 = v[6];
  const Number twice_kinetic = (L1 * L1 * inverse1 + L2 * L2 * inverse2) + L3 * L3 * inverse3;
  const Number potential = (chi1 * gamma[0] + chi2 * gamma[1]) + chi3 * gamma[2];
  return {0.5 * twice_kinetic + potential, (gamma[0] * L1 + gamma[1] * L2) + gamma[2] * L3};
}

// The same seven numbers of as many motions as a register has lanes.
template <class Wide>
struct WideVector {
  std::array<Wide, 7> of;

  [[gnu::always_inline]] WideVector& operator+=(const WideVector& b) {
    for (std::size_t i = 0; i < 7; ++i)
      of[i] += b.of[i];
    return *this;
  }
  [[gnu::always_inline]] friend WideVector operator+(const WideVector& a, const WideVector& b) {
    WideVector sum;
    for (std::size_t i = 0; i < 7; ++i)
      sum.of[i] = a.of[i] + b.of[i];
    return sum;
  }
  [[gnu::always_inline]] friend WideVector operator-(const WideVector& a, const WideVector& b) {
    WideVector difference;
    for (std::size_t i = 0; i < 7; ++i)
      difference.of[i] = a.of[i] - b.of[i];
    return difference;
  }
  template <class Number>
  [[gnu::always_inline]] friend WideVector operator*(const Number& factor, const WideVector& a) {
    WideVector product;
    for (std::size_t i = 0; i < 7; ++i)
      product.of[i] = factor * a.of[i];
    return product;
  }
};

// Registers of two, four and eight numbers.
using TwoLanes [[gnu::vector_size(16)]] = double;
using FourLanes [[gnu::vector_size(32)]] = double;
using EightLanes [[gnu::vector_size(64)]] = double;

// The lanes of a register from get(part) of as many parts, and the other way round.
template <class Wide, class Part, class Get>
[[gnu::always_inline]] inline void gather(Part* const* parts, Wide& wide, const Get& get) {
  std::array<double, sizeof(Wide) / sizeof(double)> lanes;
  for (std::size_t i = 0; i < lanes.size(); ++i)
    lanes[i] = get(*parts[i]);
  std::memcpy(&wide, lanes.data(), sizeof(Wide));
}
template <class Wide, class Part, class Get>
[[gnu::always_inline]] inline void scatter(Part* const* parts, const Wide& wide, const Get& get) {
  std::array<double, sizeof(Wide) / sizeof(double)> lanes;
  std::memcpy(lanes.data(), &wide, sizeof(Wide));
  for (std::size_t i = 0; i < lanes.size(); ++i)
    get(*parts[i]) = lanes[i];
}

// Whether the mask of a comparison is set in any lane.
template <class Mask>
[[gnu::always_inline]] inline bool any(const Mask& mask) {
  std::array<long, sizeof(Mask) / sizeof(long)> lanes;
  std::memcpy(lanes.data(), &mask, sizeof(Mask));
  long all = 0;
  for (const long lane : lanes)
    all |= lane;
  return all != 0;
}

// The square root of each lane, or of a number.
template <class Number>
[[gnu::always_inline]] inline void take_root(Number& x) {
  constexpr std::size_t kBytes = sizeof(double);
  std::array<double, sizeof(Number) / kBytes> lanes;
  std::memcpy(lanes.data(), &x, sizeof(Number));
  for (double& lane : lanes)
    lane = std::sqrt(lane);
  std::memcpy(&x, lanes.data(), sizeof(Number));
}

// Scales q to unit length.
template <class Wide>
[[gnu::always_inline]] inline void normalize(WideVector<Wide>& v) {
  Wide norm = (v.of[0] * v.of[0] + v.of[2] * v.of[2]) + (v.of[1] * v.of[1] + v.of[3] * v.of[3]);
  take_root(norm);
  for (std::size_t i = 0; i < 4; ++i)
    v.of[i] /= norm;
}

// The norm of ErrorNorm (motion/steppers/derivative.h); squares are added up in the order of Eigen.
template <class Wide>
[[gnu::always_inline]] inline void find_size(const WideVector<Wide>& v,
                                             const Wide& momentum_scale,
                                             Wide& size) {
  Wide q = (v.of[0] * v.of[0] + v.of[2] * v.of[2]) + (v.of[1] * v.of[1] + v.of[3] * v.of[3]);
  Wide y = (v.of[4] * v.of[4] + v.of[5] * v.of[5]) + v.of[6] * v.of[6];
  take_root(q);
  take_root(y);
  y /= momentum_scale;
  size = q < y ? y : q;
}

}  // namespace polhode
