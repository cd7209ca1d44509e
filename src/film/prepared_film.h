// SPDX-License-Identifier: MIT
// A film of which everything is known but its pixels.
#pragma once

#include <memory>
#include <vector>

#include "film/comparison.h"
#include "film/frame_times.h"
#include "film/render_plan.h"

namespace polhode {

// What a film stands on: all that takes long and needs neither text nor OpenGL, whose threads do
// not come along when drawing processes are forked.
struct PreparedFilm {
  Solved solved;
  FrameTimes frames;
  std::unique_ptr<const Comparison> comparison = {};  // null: nothing is compared
  std::vector<FilmPlot> plots = {};
};

// Finds the motion. Throws Error as solve, plan_frame_times and make_plots do.
PreparedFilm prepare_film(const RenderPlan& plan);

// What each frame shows.
class FilmFrames {
 public:
  // `basis` must outlive it. Throws Error as make_film does.
  FilmFrames(const RenderPlan& plan, const PreparedFilm& basis);

  const PreparedFilm& basis() const { return basis_; }
  const Film& film() const { return film_; }

  // Tells what is doubtful of it.
  void warn() const;

  // How long the shutter is open, s of film, and in how many pictures that is seen.
  double open() const { return open_; }
  int moments() const { return moments_; }

 private:
  const PreparedFilm& basis_;
  bool text_;
  Film film_;
  double open_;
  int moments_;
};

}  // namespace polhode
