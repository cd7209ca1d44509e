// SPDX-License-Identifier: MIT
// Elliptic integrals and Jacobi's elliptic functions of a real argument, to round-off for every
// parameter. The parameter is m = k^2 and always comes with m1 = 1 - m: near m = 1 the subtraction
// would lose all digits of m1.
#pragma once

namespace polhode {

// Carlson's symmetric integral of the first kind R_F(x, y, z) for x, y, z >= 0, of which at most
// one may be 0 (B. C. Carlson, Numer. Algorithms 10 (1995) 13; DLMF 19.36).
double carlson_rf(double x, double y, double z);

// The complete integral of (a cos^2 + b sin^2) / ((cos^2 + p sin^2) sqrt(cos^2 + m1 sin^2)) over 0
// to pi/2, for 0 < m1 <= 1 and p > 0: of all three kinds (R. Bulirsch, Numer. Math. 13 (1969) 305;
// DLMF 19.2.11).
double elliptic_cel(double m1, double p, double a, double b);

// Complete integral of the first kind K(m), from m1 = 1 - m, 0 <= m1 <= 1, by the
// arithmetic-geometric mean (DLMF 19.8.5); infinite for m1 = 0.
double elliptic_k(double m1);

// Incomplete integral of the first kind F(phi | m) for the angle phi in [-pi, pi] of the point (c,
// s), which need not be on the unit circle. Taking the point instead of phi keeps all digits near
// phi = pi/2. Requires 0 <= m, m1 and m + m1 = 1. 0 for (0, 0); infinite for |phi| >= pi/2 and
// m1 = 0.
double elliptic_f(double s, double c, double m, double m1);

// Jacobi's sn, cn and dn of one argument.
struct SnCnDn {
  double sn, cn, dn;
};

// One parameter m, with everything precomputed that does not depend on the argument. Immutable, so
// any thread may use it.
class EllipticParameter {
 public:
  // Number of terms of the series, enough for round-off.
  static constexpr int kTerms = 5;

  // Requires 0 <= m, m1 <= 1 and m + m1 = 1.
  EllipticParameter(double m, double m1);

  double m() const { return m_; }
  double m1() const { return m1_; }
  double quarter_period() const { return K_; }         // K; infinite when m1 = 0
  double other_quarter_period() const { return K1_; }  // K' = K(m1); infinite when m = 0
  // True: the series use the nome q = exp(-pi K'/K). False: they use the nome exp(-pi K/K') of
  // Jacobi's imaginary transformation, which converges faster for this m.
  bool direct() const { return direct_; }
  // Minus the logarithm of the nome in use; infinite if it is 0.
  double log_nome() const { return log_nome_; }

  // v - 2 K j with the integer j for which |result| <= K; v itself if K is infinite. `odd` is set
  // to whether j is odd.
  double reduced(double v, bool& odd) const;

  // sn, cn and dn at v, as quotients of theta functions (DLMF 22.2.4-6 and, if not direct(),
  // Jacobi's imaginary transformation, DLMF 22.6(iv)).
  SnCnDn at(double v) const;

 private:
  double m_, m1_, K_, K1_;
  bool direct_;
  double log_nome_;
  double half_[kTerms], whole_[kTerms];    // nome^(s(s+1)) and nome^(s^2)
  double sn_scale_, cn_scale_, dn_scale_;  // of the quotients of theta functions

  SnCnDn direct_at(double v) const;
  SnCnDn dual_at(double v) const;
};

}  // namespace polhode
