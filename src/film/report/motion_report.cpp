// SPDX-License-Identifier: MIT
#include "film/report/motion_report.h"

#include "base/version.h"
#include "math/notation.h"
#include "video/film_sink.h"

namespace polhode {

Json versions() {
  return {{"polhode", program_version()},
          {"compiler", __VERSION__},
          {"eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"ffmpeg", libav_version()}};
}

}  // namespace polhode
