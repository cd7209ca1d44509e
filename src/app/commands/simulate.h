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

// Writes a header and one row for each t = k / rate (k = 0, 1, ...) within the motion. The columns,
// in SI units with 17 digits: t; qw,qx,qy,qz (attitude q_SB, which rotates components in the body
// axes B into those in the space axes S); wx,wy,wz (angular velocity, components in B); Lx,Ly,Lz
// (angular momentum about the fixed point, or else the centre of mass, components in S); x,y,z
// (centre of mass in S); energy (Sample::energy in motion/motion.h). Throws Error as
// load_single and solve (film/solved_scene.h) do; (input) with --rate as key for a rate
// that is not positive or gives more than 1e7 rows, and for an output that is the scene, has
// another ending than .csv, or cannot be written; (environment) if writing fails; (interrupted).
void write_csv(const SimulateJob& job);

}  // namespace polhode
