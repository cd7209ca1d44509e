// SPDX-License-Identifier: MIT
// Declares the function that makes each stepper, for the table in motion/stepper_table.cpp, which
// has the sources and properties of the methods. Each copies what it needs of the model.
// momentum_scale: a typical |y| for the error norm, kg m^2/s, as momentum_scale() in
// motion/scales.h gives it; methods that use no such norm ignore it.
#pragma once

#include <memory>

#include "motion/stepper.h"

namespace polhode {

std::unique_ptr<Stepper> make_explicit_euler(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_semi_implicit_euler(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_linearly_implicit_euler(const BodyModel& model,
                                                      double momentum_scale);
std::unique_ptr<Stepper> make_renormalised_explicit(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_rk2(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_rk4(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_rk4_euler_angles(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_dopri5(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_dop853(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_taylor10(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_taylor16(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_implicit_midpoint(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_gauss4(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_gauss6(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_radau5(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_rkmk4(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_cf4(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_three_rotations(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_symmetric_remainder2(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_symmetric_remainder4(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_symmetric_remainder6(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_dmv2(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_dmv4(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_dmv6(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_dmv8(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_dmv10(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_kick_strang(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_kick_suzuki4(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_kick_chin4(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_kick_srkn6(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_kick_srkn11(const BodyModel& model, double momentum_scale);
// For models with a table only.
std::unique_ptr<Stepper> make_table_euler(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_table_penalty(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_table_smoothed(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_table_baumgarte(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_table_baumgarte_hard(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_table_projection(const BodyModel& model, double momentum_scale);
std::unique_ptr<Stepper> make_table_rk4(const BodyModel& model, double momentum_scale);

}  // namespace polhode
