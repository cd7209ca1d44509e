// SPDX-License-Identifier: MIT
// A film of which everything is known but its pixels.
#pragma once

#include <memory>

#include "film/comparison.h"
#include "film/frame_times.h"
#include "film/render_plan.h"
#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// The motion, the frame times, and what each frame shows. Invariant: nothing here has opened OpenGL
// or fonts, and no thread of it is running, so that a process can fork and draw from its copy.
class PreparedFilm {
 public:
  // Finds the motion. Throws Error as solve, plan_frame_times and make_film do.
  explicit PreparedFilm(const RenderPlan& plan);
  PreparedFilm(const PreparedFilm&) = delete;
  PreparedFilm& operator=(const PreparedFilm&) = delete;

  const Solved& solved() const { return solved_; }
  const FrameTimes& frames() const { return frames_; }
  const Film& film() const { return *film_; }
  const Comparison* comparison() const { return comparison_.get(); }  // null: nothing is compared

  // Logs what is doubtful about the film. It looks for fonts, so it comes after any fork.
  void warn() const;

  // How long the shutter is open, s of film, and in how many pictures a frame averages over that.
  double shutter_s() const { return shutter_s_; }
  int moments() const { return moments_; }

 private:
  Solved solved_;
  FrameTimes frames_;
  std::unique_ptr<const Comparison> comparison_;
  std::unique_ptr<const Film> film_;
  double shutter_s_ = 0.0;
  int moments_ = 1;
  bool text_ = true;
};

}  // namespace polhode
