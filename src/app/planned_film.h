// SPDX-License-Identifier: MIT
// A film of which everything is known but its pixels.
#pragma once

#include <memory>

#include "app/comparison.h"
#include "app/film_order.h"
#include "app/film_plan.h"

namespace polhode {

// The motion, the frames, and what each of them shows. Nothing here has touched OpenGL, and no
// thread of its own runs, so that drawing processes can be forked from it.
class PlannedFilm {
 public:
  // Finds the motion and tells what is doubtful of the film. Throws Error as solve, plan_frames and
  // make_film do.
  explicit PlannedFilm(const FilmOrder& order);
  PlannedFilm(const PlannedFilm&) = delete;
  PlannedFilm& operator=(const PlannedFilm&) = delete;

  const Solved& solved() const { return solved_; }
  const Frames& frames() const { return frames_; }
  const Film& film() const { return *film_; }
  const Comparison* comparison() const { return comparison_.get(); }  // null: nothing is compared

  // How long the shutter is open, s of film, and in how many pictures that is seen.
  double open() const { return open_; }
  int moments() const { return moments_; }

 private:
  Solved solved_;
  Frames frames_;
  std::unique_ptr<Comparison> comparison_;
  std::unique_ptr<Film> film_;
  double open_ = 0.0;
  int moments_ = 1;
};

}  // namespace polhode
