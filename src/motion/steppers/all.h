// SPDX-License-Identifier: MIT
// The makers of every stepper, for the table in motion/stepper.cpp.
#pragma once

#include <memory>

#include "motion/stepper.h"

namespace polhode {

std::unique_ptr<Stepper> make_explicit_euler(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_rk4(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_implicit_midpoint(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_dopri5(const Model& model, double momentum_scale);

}  // namespace polhode
