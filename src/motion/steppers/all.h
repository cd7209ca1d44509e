// SPDX-License-Identifier: MIT
// The makers of every stepper, for the table in motion/stepper.cpp.
#pragma once

#include <memory>

#include "motion/stepper.h"

namespace polhode {

std::unique_ptr<Stepper> make_explicit_euler(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_semi_implicit_euler(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_linearly_implicit_euler(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_renormalised_explicit(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_rk2(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_rk4(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_rk4_euler_angles(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_dopri5(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_dop853(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_taylor10(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_taylor16(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_implicit_midpoint(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_gauss4(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_gauss6(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_rkmk4(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_cf4(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_three_rotations(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_symmetric_remainder2(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_symmetric_remainder4(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_symmetric_remainder6(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_dmv2(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_dmv4(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_dmv6(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_dmv8(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_dmv10(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_kick_strang(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_kick_suzuki4(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_kick_chin4(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_kick_srkn6(const Model& model, double momentum_scale);
std::unique_ptr<Stepper> make_kick_srkn11(const Model& model, double momentum_scale);

}  // namespace polhode
