// SPDX-License-Identifier: MIT
// A film that is ready to be rendered: everything is known except the pixels.
#pragma once

#include <memory>
#include <vector>

#include "film/comparison.h"
#include "film/frame_times.h"
#include "film/render_plan.h"
#include "film/shutter.h"
#include "film/solved_scene.h"
#include "frame/film.h"

namespace polhode {

// The motion, the frame times, and what each frame shows. Immutable; what its members return is
// valid as long as it lives. Invariant: the constructor opens neither OpenGL nor fonts and leaves
// no threads, so a process may then fork and render from its copy.
class PreparedFilm {
 public:
  // Computes everything; `plan` is not kept. Throws Error as solve, plan_frame_times, Comparison,
  // make_charts (film/film_plots.h) and make_film (film/film_panels.h) do; errors that name a key
  // of the scene have its file and line.
  explicit PreparedFilm(const RenderPlan& plan);
  PreparedFilm(const PreparedFilm&) = delete;
  PreparedFilm& operator=(const PreparedFilm&) = delete;

  // The scene with its model and its motion, which ends where the film repeats; of a film of
  // several scenes, the first.
  const Solved& solved() const { return solved_.front(); }
  // The scenes of all panels of such a film; else that of solved().
  const std::vector<Solved>& all_solved() const { return solved_; }
  // The times of the frames.
  const FrameTimes& frames() const { return frames_; }
  // What is to be seen, as a function of film time.
  const Film& film() const { return *film_; }
  // The runs of numerics.compare; null if no methods are compared.
  const Comparison* comparison() const { return comparison_.get(); }

  // Logs warnings about the film (film/film_warnings.h) and its fonts. It opens these, so call it
  // after any fork.
  void warn() const;

  // When the shutter is open in each frame.
  const Shutter& shutter() const { return shutter_; }

 private:
  std::vector<Solved> solved_;  // at least one
  FrameTimes frames_;
  std::unique_ptr<const Comparison> comparison_;
  std::unique_ptr<const Film> film_;
  Shutter shutter_;
  bool text_ = true;
};

// Throws Error (input), with file and line, where a film of the scene alone would, for times,
// elements and plots that it cannot show. Paths, which take long to prepare, are left out.
void check_film(Solved solved);

// The same of what stands beside the panels of a film. `panels`: each alone, of which the first has
// the settings of the film.
void check_charts(const std::vector<Solved>& panels);

}  // namespace polhode
