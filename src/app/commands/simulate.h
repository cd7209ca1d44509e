// SPDX-License-Identifier: MIT
// The use case `simulate`: the motion as a table.
#pragma once

#include <filesystem>
#include <string>

#include "film/overrides.h"

namespace polhode {

struct SimulateJob {
  std::filesystem::path scene;
  std::string output;  // a file, or "-" for standard output
  Overrides overrides;
  std::optional<double> rate;  // rows per second; absent: the scene's frame rate
};

// Columns t,qw,qx,qy,qz,wx,wy,wz,Lx,Ly,Lz,x,y,z,energy, 17 digits: q body to space, omega in body
// axes, L in space axes about the fixed point or else the centre of mass, the centre of mass,
// total energy. Rows at k/rate while that is within the motion. Throws Error.
void write_csv(const SimulateJob& job);

}  // namespace polhode
