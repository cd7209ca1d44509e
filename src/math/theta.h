// SPDX-License-Identifier: MIT
// Theta functions of complex argument, as the attitude of a top needs them: their phases carry
// Legendre's integrals of the third kind, without any quadrature (Jacobi; Klein and Sommerfeld,
// Theorie des Kreisels, VI). All are smooth in v, and bounded: positive factors that depend on v
// are left out where only the direction of the complex number counts.
#pragma once

#include "math/elliptic.h"

namespace polhode {

// A complex number and its derivative along v, over one and the same positive factor.
struct ThetaValue {
  double re = 1.0, im = 0.0;
  double slope_re = 0.0, slope_im = 0.0;
};

// theta_4(pi (v + i eta) / 2K | nome q^2), 0 <= eta <= K', over a positive function of v.
class ThetaPhase {
 public:
  ThetaPhase(const EllipticParameter& parameter, double eta);
  // the slopes of the result are filled by rate() only
  ThetaValue at(double v) const;
  // d arg / dv at v = 0
  double rate() const;

 private:
  EllipticParameter parameter_;
  double even_[EllipticParameter::kTerms];  // factors of cosines or hyperbolic cosines
  double odd_[EllipticParameter::kTerms];   // of sines or hyperbolic sines
  double per_v_;                            // theta's argument over v
  double drift_;                            // phase per v of the imaginary transformation
  double nome_;
};

// theta_1 and theta_2 (pi (v - i eta) / 2K | nome q), |eta| <= K', each with its own eta, both over
// one positive function of v. first is 1 at v = K in modulus and second 1 at v = 0 if the parameter
// is direct; else second is 1 at v = 0, and first is sin / cos of pi eta / 2K' there when q' = 0.
class ThetaPair {
 public:
  ThetaPair(const EllipticParameter& parameter, double eta_first, double eta_second);
  void at(double v, ThetaValue& first, ThetaValue& second) const;
  // d arg / dv of theta_1 at v = K, and of theta_2 at v = 0
  double rate_first() const { return rate(eta_first_); }
  double rate_second() const { return rate(eta_second_); }

 private:
  EllipticParameter parameter_;
  double eta_first_, eta_second_;
  double first_even_[EllipticParameter::kTerms], first_odd_[EllipticParameter::kTerms];
  double second_even_[EllipticParameter::kTerms], second_odd_[EllipticParameter::kTerms];
  double per_v_;
  double drift_first_, drift_second_;
  double nome_;

  double rate(double eta) const;
  void direct_at(double v, ThetaValue& first, ThetaValue& second) const;
  void dual_at(double v, ThetaValue& first, ThetaValue& second) const;
};

}  // namespace polhode
