// SPDX-License-Identifier: MIT
// The golden pictures: which scenes at which times, drawn small.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "app/render_film.h"

namespace polhode::golden {

struct Case {
  std::string name;   // tests/golden/NAME.png
  std::string scene;  // scenes/SCENE.toml
  double time;        // s
  bool text = false;  // letters differ a little between versions of fonts; few cases have them
};

// how a failing test names its case
inline void PrintTo(const Case& one, std::ostream* out) {
  *out << one.name;
}

inline const std::vector<Case>& cases() {
  static const std::vector<Case> list = {
      {"free_symmetric_top", "free_symmetric_top", 1.25},
      {"free_symmetric_top_oblate", "free_symmetric_top_oblate", 3.0},
      {"spherical_top", "spherical_top", 0.7},
      {"feynman_plate", "feynman_plate", 0.4},
      {"t_handle", "t_handle", 2.0},
      {"bicycle_wheel", "bicycle_wheel", 1.0},
      {"heavy_top", "heavy_top", 0.3},
      {"compare_engines", "compare_engines", 4.0},
      {"labels", "heavy_top", 1.0, true},
      {"poinsot", "poinsot", 5.0},
      {"binet", "binet", 3.0},
      {"polhodes", "polhodes", 4.0},
      {"ghosts", "book_ghosts", 1.6},
      {"theme_light", "euler_rates", 0.5},
      {"theme_print", "two_views", 2.0},
      {"theme_projector", "why_tops_do_not_fall", 0.8},
      {"story", "cones_explained", 5.0},
      {"floor", "closed_loop", 3.0},
      {"blur", "fast_spin_blur", 2.0},
  };
  return list;
}

inline void render(const Case& one, const std::string& output) {
  RenderJob job;
  job.scene = POLHODE_SOURCE_DIR "/scenes/" + one.scene + ".toml";
  job.output = output;
  job.overrides.size = "320x180";
  job.still = one.time;
  job.text = one.text;
  render_film(job);
}

inline std::string reference(const Case& one) {
  return POLHODE_SOURCE_DIR "/tests/golden/" + one.name + ".png";
}

// A verdict of three numbers. Drawing is the same everywhere but for low bits of square roots and
// interpolation on other processors and Mesa versions: up to 3 levels (FACTS of other projects and
// of Mesa), and edge samples that fall to the other side: a quarter of an edge pixel's contrast.
inline constexpr int kThreshold = 3;         // levels of 255 that are no difference
inline constexpr double kFraction = 0.0005;  // of the pixels may differ by more ...
inline constexpr int kLimit = 70;            // ... but none by more than a quarter of full contrast

}  // namespace polhode::golden
