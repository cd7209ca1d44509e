// SPDX-License-Identifier: MIT
// Draws Poincaré sections and writes them as tables.
#pragma once

#include <string>
#include <vector>

#include "chart/gnuplot.h"
#include "chart/section.h"

namespace polhode {

// A section of one scene. The first orbit is that of the scene's own start.
struct SectionChart {
  std::string title;
  // of the parts that are allowed, each once round: tilt (rad), momentum (kg m^2/s)
  std::vector<std::vector<Vec2>> borders;
  std::vector<SectionOrbit> orbits;
};

// The borders of a surface.
std::vector<std::vector<Vec2>> borders_of(const SectionSurface& surface);

// The bytes of a picture: regular orbits in colours, chaotic ones grey, undecided ones black, the
// first orange. Throws Error as draw_with_gnuplot() does.
std::string plot_section(const SectionChart& chart, PlotFormat format);

// One row per crossing: orbit, verdict, exponent_per_s, tilt_rad, momentum_kg_m2_per_s.
std::string section_csv(const SectionChart& chart);

}  // namespace polhode
