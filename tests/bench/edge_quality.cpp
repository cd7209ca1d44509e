// SPDX-License-Identifier: MIT
// How near to the truth edges are, by outlines and by four samples: PSNR of the shipped scenes
// against the mean of 64 pictures, each a part of a pixel aside. Text is left out.
//   edge_quality [WxH] [SCENE...]     1920x1080 and all shipped scenes
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "film/film_panels.h"
#include "film/frame_times.h"
#include "film/overrides.h"
#include "film/solved_scene.h"
#include "image/compare.h"
#include "render/renderer.h"
#include "support/edge_truth.h"

namespace polhode {
namespace {

constexpr int kMoments = 3;

void judge(const std::string& file, const std::string& size, const Context& context) {
  Overrides overrides;
  overrides.size = size;
  const Solved solved = solve(load_with_overrides(file, overrides));
  const PictureSize pixels = solved.scene.video.size;
  const FrameTimes frames = plan_frame_times(solved, {});
  const Film film = make_film({solved}, frames.timeline, nullptr, {}, false);
  struct Way {
    int samples;
    Edges edges;
    double error = 0.0;
  };
  std::vector<Way> ways = {{0, Edges::samples}, {4, Edges::samples}, {0, Edges::outlines}};
  for (int i = 0; i < kMoments; ++i) {
    Picture picture = film.at(frames.film_time(frames.count * (2 * i + 1) / (2 * kMoments)));
    picture.stamps.clear();
    const std::vector<double> truth =
        test::edge_truth(context, picture, pixels.width, pixels.height);
    for (Way& way : ways) {
      Renderer renderer(context, {pixels.width, pixels.height, way.samples, false, way.edges});
      Image image;
      renderer.draw(picture, image);
      way.error += test::mean_square_error(image, truth) / kMoments;
    }
  }
  const auto decibels = [&](std::size_t way) {
    return psnr(std::sqrt(ways[way].error));
  };
  fmt::print("{:<36} {:>8.2f} {:>9.2f} {:>9.2f} {:>+9.2f}\n",
             std::filesystem::path(file).stem().string(),
             decibels(0),
             decibels(1),
             decibels(2),
             decibels(2) - decibels(1));
}

}  // namespace
}  // namespace polhode

int main(int count, char** arguments) {
  std::vector<std::string> scenes(arguments + std::min(count, 2), arguments + count);
  if (scenes.empty()) {
    for (const auto& entry : std::filesystem::directory_iterator(POLHODE_SOURCE_DIR "/scenes")) {
      if (entry.path().extension() == ".toml") scenes.push_back(entry.path().string());
    }
    std::sort(scenes.begin(), scenes.end());
  }
  fmt::print(
      "{:<36} {:>8} {:>9} {:>9} {:>9}\n", "PSNR, dB", "none", "4 samples", "outlines", "gain");
  const auto context = polhode::open_context("auto");
  for (const std::string& scene : scenes)
    polhode::judge(scene, count > 1 ? arguments[1] : "1920x1080", *context);
}
