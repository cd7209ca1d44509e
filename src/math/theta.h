// SPDX-License-Identifier: MIT
// Theta functions (DLMF 20.2) of a complex argument, for the attitude of a top. Their phases give
// Legendre's elliptic integrals of the third kind without quadrature (Jacobi; Klein and Sommerfeld,
// Theorie des Kreisels, VI). Only the phase is needed, so positive factors that depend on v are
// left out. The results are smooth in v and bounded. K and K' are the quarter periods of the
// parameter, and q = exp(-pi K'/K) is its nome.
#pragma once

#include "math/elliptic.h"

namespace polhode {

// A complex number and its derivative with respect to v, both divided by the same positive factor.
struct ThetaValue {
  double re = 1.0, im = 0.0;
  double slope_re = 0.0, slope_im = 0.0;  // the derivative
};

// theta_4(pi (v + i eta) / 2K | nome q^2), divided by a positive function of v. Requires 0 <= eta
// <= K'. Immutable, so any thread may use it.
class ThetaPhase {
 public:
  ThetaPhase(const EllipticParameter& parameter, double eta);
  // The value at v; its slopes are 0, whatever the derivative.
  ThetaValue at(double v) const;
  // d arg / dv at v = 0, rad.
  double rate() const;

 private:
  EllipticParameter parameter_;
  double even_[EllipticParameter::kTerms];  // factors of cosines or hyperbolic cosines
  double odd_[EllipticParameter::kTerms];   // of sines or hyperbolic sines
  double per_v_;                            // theta's argument over v
  double drift_;                            // phase per v of the imaginary transformation
  double nome_;
};

// theta_1 and theta_2 of (pi (v - i eta) / 2K | nome q), each with its own eta, |eta| <= K', both
// divided by the same positive function of v. Normalisation: if the parameter is direct, first is 1
// at v = K and second is 1 at v = 0. Otherwise second is 1 at v = 0, and first there tends to
// tan(pi eta / 2K') as the nome vanishes. Immutable, so any thread may use it.
class ThetaPair {
 public:
  ThetaPair(const EllipticParameter& parameter, double eta_first, double eta_second);
  // The values at v, with their slopes.
  void at(double v, ThetaValue& first, ThetaValue& second) const;
  // d arg / dv of theta_1 at v = K, and of theta_2 at v = 0, rad.
  double rate_first() const { return rate(eta_first_); }
  double rate_second() const { return rate(eta_second_); }

 private:
  EllipticParameter parameter_;
  double eta_first_, eta_second_;
  double first_even_[EllipticParameter::kTerms], first_odd_[EllipticParameter::kTerms];
  double second_even_[EllipticParameter::kTerms], second_odd_[EllipticParameter::kTerms];
  double per_v_;                       // theta's argument over v
  double drift_first_, drift_second_;  // phase per v of the imaginary transformation
  double nome_;

  double rate(double eta) const;
  void direct_at(double v, ThetaValue& first, ThetaValue& second) const;
  void dual_at(double v, ThetaValue& first, ThetaValue& second) const;
};

}  // namespace polhode
