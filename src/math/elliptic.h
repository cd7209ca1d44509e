// SPDX-License-Identifier: MIT
// Elliptic integrals and Jacobi's elliptic functions of a real argument, to round-off for every
// parameter. The parameter is m = k^2 and always comes with m1 = 1 - m: near m = 1 all that matters
// is in m1, and a subtraction would lose it.
#pragma once

namespace polhode {

// Carlson's symmetric integral of the first kind, x, y, z >= 0 and at most one of them 0
// (B. C. Carlson, Numer. Algorithms 10 (1995) 13; DLMF 19.36).
double carlson_rf(double x, double y, double z);

// Complete integral of the first kind K(m), from m1 = 1 - m by the arithmetic-geometric mean;
// infinite for m1 = 0.
double elliptic_k(double m1);

// Incomplete integral F(phi | m) for the angle phi in [-pi, pi] of the point (c, s), which need not
// be on the unit circle. Exact where atan2 is: no half of the digits is lost near phi = pi/2.
double elliptic_f(double s, double c, double m, double m1);

struct SnCnDn {
  double sn, cn, dn;
};

// One parameter, with all that does not depend on the argument.
class EllipticParameter {
 public:
  static constexpr int kTerms = 5;

  // 0 <= m, m1 <= 1, m + m1 = 1
  EllipticParameter(double m, double m1);

  double m() const { return m_; }
  double m1() const { return m1_; }
  double quarter_period() const { return K_; }         // K; infinite when m1 = 0
  double other_quarter_period() const { return K1_; }  // K' = K(m1); infinite when m = 0
  // Whether series in the nome q = exp(-pi K'/K) converge fast; else those in the nome
  // exp(-pi K/K') of Jacobi's imaginary transformation do. At most kTerms terms either way.
  bool direct() const { return direct_; }
  // minus the logarithm of that one of the two nomes; infinite for the nome 0
  double log_nome() const { return log_nome_; }

  // v less the nearest multiple 2 K j of half a period, |result| <= K; odd tells whether j is odd.
  double reduced(double v, bool& odd) const;

  // Quotients of theta functions (DLMF 22.2.4-6 and, for m near 1, 22.6.1).
  SnCnDn at(double v) const;

 private:
  double m_, m1_, K_, K1_;
  bool direct_;
  double log_nome_;
  double half_[kTerms], whole_[kTerms];  // nome^(s(s+1)) and nome^(s^2)
  double sn_scale_, cn_scale_, dn_scale_;

  SnCnDn direct_at(double v) const;
  SnCnDn dual_at(double v) const;
};

}  // namespace polhode
