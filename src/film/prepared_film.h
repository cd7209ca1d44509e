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
struct FilmBasis {
  Solved solved;
  Frames frames;
  std::unique_ptr<const Comparison> comparison = {};  // null: nothing is compared
  std::vector<FilmPlot> plots = {};
};

// Finds the motion. Throws Error as solve, plan_frames and make_plots do.
FilmBasis find_basis(const FilmOrder& order);

// What each frame shows.
class PlannedFilm {
 public:
  // `basis` must outlive it. Throws Error as make_film does.
  PlannedFilm(const FilmOrder& order, const FilmBasis& basis);

  const FilmBasis& basis() const { return basis_; }
  const Film& film() const { return film_; }

  // Tells what is doubtful of it.
  void warn() const;

  // How long the shutter is open, s of film, and in how many pictures that is seen.
  double open() const { return open_; }
  int moments() const { return moments_; }

 private:
  const FilmBasis& basis_;
  bool text_;
  Film film_;
  double open_;
  int moments_;
};

}  // namespace polhode
