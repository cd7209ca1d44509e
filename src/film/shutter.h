// SPDX-License-Identifier: MIT
// Motion blur: the moments whose mean a frame is.
#pragma once

#include <vector>

#include "film/frame_times.h"
#include "frame/film.h"

namespace polhode {

// A value. Without blur it is open for an instant.
class Shutter {
 public:
  Shutter() = default;
  // One that is open for so long (s of film) in each frame, with enough moments for what turns,
  // flies or is seen by a camera that moves.
  Shutter(const std::vector<FilmPanel>& panels, const FrameTimes& frames, double open_s);

  double open_s() const { return open_s_; }
  // The number of moments, at least 1.
  int moments() const { return moments_; }
  // When one of them is, s of film after the frame's time.
  double moment(int index) const;

 private:
  double open_s_ = 0.0;
  int moments_ = 1;
};

}  // namespace polhode
