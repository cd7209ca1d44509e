// SPDX-License-Identifier: MIT
#include "math/theta.h"

#include <cmath>

#include "base/units.h"

namespace polhode {
namespace {

constexpr int kTerms = EllipticParameter::kTerms;

// exp(-a log_nome + b) for terms that vanish with the nome
double term(double a, double log_nome, double b) {
  return std::isfinite(log_nome) ? std::exp(b - a * log_nome) : 0.0;
}

double alternating(int s) {
  return s % 2 == 0 ? 1.0 : -1.0;
}

// (cosh, sinh)(k b) / cosh(b) * exp(-a L): b may be infinite when k = 1
void hyperbolic_term(int k, double a, double log_nome, double b, double& even, double& odd) {
  const double size = std::abs(b);
  const double growth = k == 1 ? 1.0 : term(a, log_nome, (k - 1) * size);
  const double shrink = 1.0 / (1.0 + std::exp(-2.0 * size));
  even = growth * (1.0 + std::exp(-2.0 * k * size)) * shrink;
  odd = std::copysign(growth * (1.0 - std::exp(-2.0 * k * size)) * shrink, b);
}

ThetaValue turned(const ThetaValue& g, double angle, double rate) {
  // e^(i angle) g, with the slope of the factor
  const double c = std::cos(angle), s = std::sin(angle);
  const double slope_re = g.slope_re - rate * g.im;
  const double slope_im = g.slope_im + rate * g.re;
  return {c * g.re - s * g.im,
          c * g.im + s * g.re,
          c * slope_re - s * slope_im,
          c * slope_im + s * slope_re};
}

}  // namespace

ThetaPhase::ThetaPhase(const EllipticParameter& parameter, double eta) : parameter_(parameter) {
  const double K = parameter.quarter_period();
  const double K1 = parameter.other_quarter_period();
  const double L = parameter.log_nome();
  if (parameter.direct()) {
    // 1 + 2 sum (-1)^s q^(2 s^2) (cos 2sz cosh 2sb - i sin 2sz sinh 2sb), b = pi eta / 2K
    per_v_ = 0.5 * kPi / K;
    drift_ = 0.0;
    nome_ = 0.0;
    const double b = per_v_ * eta;
    for (int s = 0; s < kTerms; ++s) {
      const double up = s == 0 ? 0.5 : term(2.0 * s * s, L, 2.0 * s * b);
      const double down = s == 0 ? 0.5 : term(2.0 * s * s, L, -2.0 * s * b);
      even_[s] = alternating(s) * (up + down);
      odd_[s] = -alternating(s) * (up - down);
    }
    return;
  }
  // e^(-i drift v) sum p^(s(s+1)) (cos (2s+1)x cosh (2s+1)Z + i sin (2s+1)x sinh (2s+1)Z), p the
  // root of the other nome, x = pi eta / 4K', Z = pi v / 4K'
  per_v_ = 0.25 * kPi / K1;
  drift_ = per_v_ * eta / K;
  nome_ = std::exp(-0.5 * L);
  const double x = per_v_ * eta;
  for (int s = 0; s < kTerms; ++s) {
    // p^(s^2); the other power of p comes with Z
    const double size = 0.5 * std::pow(nome_, s * s);
    even_[s] = size * std::cos((2 * s + 1) * x);
    odd_[s] = size * std::sin((2 * s + 1) * x);
  }
}

ThetaValue ThetaPhase::at(double v) const {
  bool unused = false;
  const double near = parameter_.reduced(v, unused);
  ThetaValue g{0.0, 0.0, 0.0, 0.0};
  if (parameter_.direct()) {
    const double z2 = 2.0 * per_v_ * near;
    const double c2 = std::cos(z2), s2 = std::sin(z2);
    double c = 1.0, s = 0.0;
    for (int k = 0; k < kTerms; ++k) {
      g.re += even_[k] * c;
      g.im += odd_[k] * s;
      const double s_next = s * c2 + c * s2;
      c = c * c2 - s * s2;
      s = s_next;
    }
    return g;
  }

  // all over e^|Z|
  const double E = std::exp(-2.0 * per_v_ * std::abs(near));
  const double r = nome_ > 0.0 ? nome_ / E : 0.0;
  double power = 1.0, odd = E;
  for (int k = 0; k < kTerms; ++k) {
    g.re += even_[k] * power * (1.0 + odd);
    g.im += odd_[k] * power * (1.0 - odd);
    power *= r;
    odd *= E * E;
  }
  if (near < 0.0) g.im = -g.im;
  return turned(g, -drift_ * near, 0.0);
}

double ThetaPhase::rate() const {
  double value = 0.0, slope = 0.0, power = 1.0;
  for (int s = 0; s < kTerms; ++s) {
    if (parameter_.direct()) {
      value += even_[s];
      slope += 2.0 * s * odd_[s];
    } else {
      value += 2.0 * power * even_[s];
      slope += (2 * s + 1) * 2.0 * power * odd_[s];
      power *= nome_;
    }
  }
  return per_v_ * slope / value - drift_;
}

ThetaPair::ThetaPair(const EllipticParameter& parameter, double eta_first, double eta_second)
    : parameter_(parameter), eta_first_(eta_first), eta_second_(eta_second) {
  const double K = parameter.quarter_period();
  const double K1 = parameter.other_quarter_period();
  const double L = parameter.log_nome();
  if (parameter.direct()) {
    // sums over q^(s(s+1)) of (2s+1) z and (2s+1) b, z = pi v / 2K, b = pi eta / 2K
    per_v_ = 0.5 * kPi / K;
    drift_first_ = drift_second_ = nome_ = 0.0;
    double size_first = 0.0, size_second = 0.0;
    for (int s = 0; s < kTerms; ++s) {
      hyperbolic_term(2 * s + 1, s * (s + 1), L, per_v_ * eta_first, first_even_[s], first_odd_[s]);
      hyperbolic_term(
          2 * s + 1, s * (s + 1), L, per_v_ * eta_second, second_even_[s], second_odd_[s]);
      size_first += first_even_[s];
      size_second += second_even_[s];
    }
    for (int s = 0; s < kTerms; ++s) {
      first_even_[s] *= alternating(s) / size_first;
      first_odd_[s] *= -alternating(s) / size_first;
      second_even_[s] /= size_second;
      second_odd_[s] /= size_second;
    }
    return;
  }

  // e^(i drift v) times sums over the other nome of (2s+1) w or 2s w, w = pi v / 2K', and of the
  // same multiples of x = pi eta / 2K'
  per_v_ = 0.5 * kPi / K1;
  nome_ = std::exp(-L);
  drift_first_ = per_v_ * eta_first / K;
  drift_second_ = per_v_ * eta_second / K;
  const double x1 = per_v_ * eta_first;
  const double x2 = per_v_ * eta_second;
  double size_first = 0.0, size_second = 0.0;
  for (int s = 0; s < kTerms; ++s) {
    const double whole = std::pow(nome_, s * s);
    const double half = std::pow(nome_, s * (s + 1));
    size_first += half * std::cos((2 * s + 1) * x1);
    first_even_[s] = alternating(s) * whole * std::sin((2 * s + 1) * x1);
    first_odd_[s] = alternating(s) * whole * std::cos((2 * s + 1) * x1);
    size_second += (s == 0 ? 1.0 : 2.0) * alternating(s) * whole * std::cos(2 * s * x2);
    // nome^(s^2 - s), the other power of the nome comes with w
    const double less = s == 0 ? 1.0 : 2.0 * std::pow(nome_, s * (s - 1));
    second_even_[s] = alternating(s) * less * std::cos(2 * s * x2);
    second_odd_[s] = -alternating(s) * less * std::sin(2 * s * x2);
  }
  for (int s = 0; s < kTerms; ++s) {
    first_even_[s] *= 0.5 / size_first;
    first_odd_[s] *= 0.5 / size_first;
    second_even_[s] *= 0.5 / size_second;
    second_odd_[s] *= 0.5 / size_second;
  }
}

void ThetaPair::at(double v, ThetaValue& first, ThetaValue& second) const {
  bool odd = false;
  const double near = parameter_.reduced(v, odd);
  first = second = {0.0, 0.0, 0.0, 0.0};
  if (parameter_.direct()) {
    direct_at(near, first, second);
  } else {
    dual_at(near, first, second);
  }
  if (!odd) return;
  first = {-first.re, -first.im, -first.slope_re, -first.slope_im};
  second = {-second.re, -second.im, -second.slope_re, -second.slope_im};
}

void ThetaPair::direct_at(double v, ThetaValue& first, ThetaValue& second) const {
  const double z = per_v_ * v;
  double s = std::sin(z), c = std::cos(z);
  const double s2 = 2.0 * s * c, c2 = 1.0 - 2.0 * s * s;
  for (int k = 0; k < kTerms; ++k) {
    const double per_v = (2 * k + 1) * per_v_;
    first.re += first_even_[k] * s;
    first.im += first_odd_[k] * c;
    first.slope_re += per_v * first_even_[k] * c;
    first.slope_im -= per_v * first_odd_[k] * s;
    second.re += second_even_[k] * c;
    second.im += second_odd_[k] * s;
    second.slope_re -= per_v * second_even_[k] * s;
    second.slope_im += per_v * second_odd_[k] * c;
    const double s_next = s * c2 + c * s2;
    c = c * c2 - s * s2;
    s = s_next;
  }
}

void ThetaPair::dual_at(double v, ThetaValue& first, ThetaValue& second) const {
  // all over e^|w|
  const double e = std::exp(-per_v_ * std::abs(v));
  const double E = e * e;
  const double r = nome_ > 0.0 ? nome_ / E : 0.0;
  const double sign = v < 0.0 ? -1.0 : 1.0;
  double power = 1.0, even = 1.0;  // r^k, E^(2k)
  for (int k = 0; k < kTerms; ++k) {
    const double sum = power * (1.0 + even * E), difference = sign * power * (1.0 - even * E);
    const double per_v = (2 * k + 1) * per_v_;
    first.re += first_even_[k] * sum;
    first.im += first_odd_[k] * difference;
    first.slope_re += per_v * first_even_[k] * difference;
    first.slope_im += per_v * first_odd_[k] * sum;
    const double sum2 = power * e * (1.0 + even), difference2 = sign * power * e * (1.0 - even);
    second.re += second_even_[k] * sum2;
    second.im += second_odd_[k] * difference2;
    second.slope_re += 2 * k * per_v_ * second_even_[k] * difference2;
    second.slope_im += 2 * k * per_v_ * second_odd_[k] * sum2;
    power *= r;
    even *= E * E;
  }
  first = turned(first, drift_first_ * v, drift_first_);
  second = turned(second, drift_second_ * v, drift_second_);
}

double ThetaPair::rate(double eta) const {
  const double L = parameter_.log_nome();
  double value = 0.0, slope = 0.0;
  if (parameter_.direct()) {
    // log-derivative of theta_2 at -i b
    for (int s = 0; s < kTerms; ++s) {
      double even = 0.0, odd = 0.0;
      hyperbolic_term(2 * s + 1, s * (s + 1), L, per_v_ * eta, even, odd);
      value += even;
      slope += (2 * s + 1) * odd;
    }
    return per_v_ * slope / value;
  }
  const double x = per_v_ * eta;
  for (int s = 0; s < kTerms; ++s) {
    const double whole = alternating(s) * std::pow(nome_, s * s);
    value += (s == 0 ? 1.0 : 2.0) * whole * std::cos(2 * s * x);
    slope -= 4.0 * s * whole * std::sin(2 * s * x);
  }
  return per_v_ * slope / value + per_v_ * eta / parameter_.quarter_period();
}

}  // namespace polhode
