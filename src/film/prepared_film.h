// SPDX-License-Identifier: MIT
// A film that is ready to be rendered: everything is known except the pixels.
#pragma once

#include <memory>

#include "film/comparison.h"
#include "film/frame_times.h"
#include "film/render_plan.h"
#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// The motion, the frame times, and what each frame shows. Immutable. Invariant: it has not opened
// OpenGL or fonts and has no running threads, so a process may fork and render from its copy.
class PreparedFilm {
 public:
  // Computes the motion. Throws Error as solve, plan_frame_times, Comparison, make_plots and
  // make_film do.
  explicit PreparedFilm(const RenderPlan& plan);
  PreparedFilm(const PreparedFilm&) = delete;
  PreparedFilm& operator=(const PreparedFilm&) = delete;

  const Solved& solved() const { return solved_; }
  const FrameTimes& frames() const { return frames_; }
  const Film& film() const { return *film_; }
  const Comparison* comparison() const { return comparison_.get(); }  // may be null

  // Logs warnings about the film: missing fonts, open loops, camera, apparent backward rotation. It
  // opens fonts, so call it after any fork.
  void warn() const;

  // How long the shutter is open (s of film), and the number of pictures that a frame averages over
  // that time.
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
