// SPDX-License-Identifier: MIT
// A measured error against its bound. POLHODE_RESIDUALS=1 prints every one of them.
#pragma once

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace polhode::test {

inline void expect_residual(const std::string& what, double measured, double bound) {
  static const bool print = std::getenv("POLHODE_RESIDUALS") != nullptr;
  if (print) fmt::print("    {:<58} {:9.2e} of {:9.2e}\n", what, measured, bound);
  // written so that a NaN fails
  EXPECT_TRUE(measured <= bound) << what << ": " << measured << " is more than " << bound;
}

// The larger of two, and a NaN of either: std::max would lose it.
inline double worse(double worst, double next) {
  return next > worst || std::isnan(next) ? next : worst;
}

// The reverse: an effect that theory demands must be there.
inline void expect_effect(const std::string& what, double measured, double least) {
  static const bool print = std::getenv("POLHODE_RESIDUALS") != nullptr;
  if (print) fmt::print("    {:<58} {:9.2e} above {:9.2e}\n", what, measured, least);
  EXPECT_TRUE(measured >= least) << what << ": " << measured << " is less than " << least;
}

}  // namespace polhode::test
