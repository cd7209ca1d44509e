// SPDX-License-Identifier: MIT
// The command `simulate`: writes the motion as a CSV table.
#pragma once

#include <filesystem>
#include <string>

#include "film/overrides.h"

namespace polhode {

// The options of `simulate`.
struct SimulateJob {
  std::filesystem::path scene;
  std::string output;  // a file, or "-" for standard output
  Overrides overrides;
  std::optional<double> rate;  // rows per second; absent: the scene's frame rate
};

// Columns, in SI units with 17 digits: t, qw,qx,qy,qz (attitude, rotates B to S), wx,wy,wz (angular
// velocity in B), Lx,Ly,Lz (angular momentum in S about the fixed point, or else the centre of
// mass), x,y,z (centre of mass in S), energy (total). Rows are at t = k/rate within the motion.
// Throws Error as load_with_overrides and solve do, (input) naming --rate, and as AtomicFile and
// print_out do.
void write_csv(const SimulateJob& job);

}  // namespace polhode
