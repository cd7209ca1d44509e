// SPDX-License-Identifier: MIT
#include "film/shutter.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr int kMostMoments = 48;

// How far a body that would not turn goes in the picture while the shutter is open, at most, in
// heights of the picture: it flies, or its camera moves.
double shift_of_shutter(const FilmPanel& panel, const FrameTimes& frames, double open) {
  constexpr int kLooks = 60;
  const Composer& composer = *panel.composer;
  const Scenery& scenery = composer.scenery();
  const double length = composer.timeline().film_duration();
  const auto place = [&](double film, const Vec3& off_S) -> Vec2 {
    const double t = std::min(composer.timeline().motion_time(film), scenery.motion.duration());
    const Camera camera = composer.camera_at(film);
    return camera.project(scenery.motion.at(t).reference_S + off_S) / panel.place.height;
  };
  double most = 0.0;
  for (int i = 0; i < kLooks; ++i) {
    const double film = std::min(frames.film_time(frames.count * i / kLooks), length - open);
    if (film < 0.0) continue;
    for (const int axis : {-1, 0, 1, 2}) {
      const Vec3 off_S = axis < 0 ? Vec3(Vec3::Zero()) : scenery.scale.body * Vec3::Unit(axis);
      const double shift = (place(film + open, off_S) - place(film, off_S)).norm();
      if (std::isfinite(shift)) most = std::max(most, shift);
    }
  }
  return most;
}

// as many as leave no gaps: from one to the next the body turns by a few degrees, and goes on by
// some pixels
int moments_of_shutter(const FilmPanel& panel, const FrameTimes& frames, double open) {
  constexpr double kTurn = 0.06;          // rad
  constexpr double kShift = 1.0 / 180.0;  // of the height of the picture
  if (open <= 0.0) return 1;
  const Motion& motion = panel.composer->scenery().motion;
  const double turned = fastest_turn(motion) * open * panel.composer->timeline().time_scale();
  const double wanted = std::max(turned / kTurn, shift_of_shutter(panel, frames, open) / kShift);
  return static_cast<int>(std::clamp(std::ceil(wanted), 4.0, 1.0 * kMostMoments));
}

}  // namespace

Shutter::Shutter(const std::vector<FilmPanel>& panels, const FrameTimes& frames, double open_s)
    : open_s_(open_s) {
  for (const FilmPanel& panel : panels)
    moments_ = std::max(moments_, moments_of_shutter(panel, frames, open_s));
}

double Shutter::moment(int index) const {
  // where they are too few for a fast spin, equal steps may be whole turns: blurred, it would stand
  constexpr double kGolden = 0.6180339887498949;
  const double inside = moments_ == kMostMoments ? std::fmod((index + 1) * kGolden, 1.0) : 0.5;
  return open_s_ * (index + inside) / moments_;
}

}  // namespace polhode
