// SPDX-License-Identifier: MIT
#include "math/elliptic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"

namespace polhode {
namespace {

// K'/K above which the nome of the parameter itself is the better one
constexpr double kDirectAbove = 0.8;

}  // namespace

double carlson_rf(double x, double y, double z) {
  const double a0 = (x + y + z) / 3.0;
  // after the last duplication the series of fifth order in the deviations is exact to round-off
  double q = 390.0 * std::max({std::abs(a0 - x), std::abs(a0 - y), std::abs(a0 - z)});
  double a = a0;
  while (q > std::abs(a)) {
    const double lambda = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    a = 0.25 * (a + lambda);
    q *= 0.25;
  }
  const double X = (a - x) / a;
  const double Y = (a - y) / a;
  const double Z = -X - Y;
  const double e2 = X * Y - Z * Z;
  const double e3 = X * Y * Z;
  return (1.0 + e2 * (e2 / 24.0 - 0.1 - 3.0 * e3 / 44.0 - 5.0 * e2 * e2 / 208.0) +
          e3 * (1.0 / 14.0 + 3.0 * e3 / 104.0) + e2 * e2 * e3 / 16.0) /
         std::sqrt(a);
}

double elliptic_cel(double m1, double p, double a, double b) {
  // means of arithmetic and geometric kind; of positive numbers nothing cancels
  double g = 1.0, h = std::sqrt(m1), product = h;
  p = std::sqrt(p);
  b /= p;
  while (true) {
    const double before = a;
    a += b / p;
    b = 2.0 * (b + before * product / p);
    p += product / p;
    const double mean = g + h;
    if (std::abs(g - h) <= 1e-8 * g) return 0.5 * kPi * (b + a * mean) / (mean * (mean + p));
    h = 2.0 * std::sqrt(product);
    product = h * mean;
    g = mean;
  }
}

double elliptic_k(double m1) {
  if (m1 == 0.0) return std::numeric_limits<double>::infinity();
  double a = 1.0;
  double b = std::sqrt(m1);
  while (std::abs(a - b) > 4e-9 * a) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  // one more step is exact: the difference is squared
  return kPi / (a + b);
}

double elliptic_f(double s, double c, double m, double m1) {
  const double n = std::hypot(s, c);
  if (n == 0.0 || s == 0.0) return c < 0.0 ? std::copysign(2.0 * elliptic_k(m1), s) : 0.0;
  const double sine = s / n;
  const double cosine = c / n;
  // 1 - m sin^2 without cancellation
  const double delta = cosine * cosine + m1 * sine * sine;
  if (cosine == 0.0 && delta == 0.0) {
    return std::copysign(std::numeric_limits<double>::infinity(), s);
  }
  const double first = sine * carlson_rf(cosine * cosine, m == 0.0 ? 1.0 : delta, 1.0);
  return c < 0.0 ? std::copysign(2.0 * elliptic_k(m1), s) - first : first;
}

EllipticParameter::EllipticParameter(double m, double m1)
    : m_(m), m1_(m1), K_(elliptic_k(m1)), K1_(elliptic_k(m)), direct_(K1_ > kDirectAbove * K_) {
  log_nome_ = direct_ ? kPi * K1_ / K_ : kPi * K_ / K1_;
  const double nome = std::exp(-log_nome_);
  double theta2 = 0.0, theta3 = -1.0, theta4 = -1.0;
  for (int s = 0; s < kTerms; ++s) {
    half_[s] = std::pow(nome, s * (s + 1));
    whole_[s] = std::pow(nome, s * s);
    theta2 += half_[s];
    theta3 += 2.0 * whole_[s];
    theta4 += (s % 2 == 0 ? 2.0 : -2.0) * whole_[s];
  }
  // theta_2(0) is without its factor 2 nome^(1/4), which theta_1(v) and theta_2(v) lack as well
  sn_scale_ = direct_ ? theta3 / theta2 : theta3 / theta4;
  cn_scale_ = direct_ ? theta4 / theta2 : theta2 / theta4;
  dn_scale_ = direct_ ? theta4 / theta3 : theta2 / theta3;
}

double EllipticParameter::reduced(double v, bool& odd) const {
  const double j = std::nearbyint(v / (2.0 * K_));
  odd = (static_cast<long long>(j) & 1) != 0;
  return j == 0.0 ? v : v - 2.0 * K_ * j;
}

SnCnDn EllipticParameter::at(double v) const {
  bool odd = false;
  const double near = reduced(v, odd);
  SnCnDn value = direct_ ? direct_at(near) : dual_at(near);
  if (odd) {
    value.sn = -value.sn;
    value.cn = -value.cn;
  }
  return value;
}

SnCnDn EllipticParameter::direct_at(double v) const {
  const double z = 0.5 * kPi * v / K_;
  const double s1 = std::sin(z), c1 = std::cos(z);
  const double s2 = 2.0 * s1 * c1, c2 = 1.0 - 2.0 * s1 * s1;
  double theta1 = 0.0, theta2 = 0.0, theta3 = -1.0, theta4 = -1.0;
  // sine and cosine of (2s + 1) z and of 2s z
  double so = s1, co = c1, se = 0.0, ce = 1.0, sign = 1.0;
  for (int s = 0; s < kTerms; ++s) {
    theta1 += sign * half_[s] * so;
    theta2 += half_[s] * co;
    theta3 += 2.0 * whole_[s] * ce;
    theta4 += 2.0 * sign * whole_[s] * ce;
    const double so_next = so * c2 + co * s2;
    co = co * c2 - so * s2;
    so = so_next;
    const double se_next = se * c2 + ce * s2;
    ce = ce * c2 - se * s2;
    se = se_next;
    sign = -sign;
  }
  return {sn_scale_ * theta1 / theta4, cn_scale_ * theta2 / theta4, dn_scale_ * theta3 / theta4};
}

SnCnDn EllipticParameter::dual_at(double v) const {
  // hyperbolic functions of multiples of w, all over e^|w|: no overflow near a separatrix
  const double w = 0.5 * kPi * std::abs(v) / K1_;
  const double e = std::exp(-w);
  const double E = e * e;
  const double r = whole_[1] > 0.0 ? whole_[1] / E : 0.0;  // nome e^(2 w) <= 1
  double theta1 = 0.0, theta2 = 0.0, theta3 = e, theta4 = e;
  double power = 1.0, odd = E, sign = 1.0;  // r^s, E^(2s + 1)
  for (int s = 0; s < kTerms; ++s) {
    theta1 += 0.5 * sign * whole_[s] * power * (1.0 - odd);
    theta2 += 0.5 * whole_[s] * power * (1.0 + odd);
    power *= r;
    sign = -sign;
    if (s + 1 < kTerms) {
      const double even = half_[s] * power * e * (1.0 + odd * E);
      theta3 += even;
      theta4 += sign * even;
    }
    odd *= E * E;
  }
  return {std::copysign(sn_scale_ * theta1 / theta2, v),
          cn_scale_ * theta4 / theta2,
          dn_scale_ * theta3 / theta2};
}

}  // namespace polhode
