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

#include "app/film_plan.h"
#include "app/load.h"
#include "render/renderer.h"

namespace polhode {
namespace {

constexpr int kMoments = 3;
constexpr int kSide = 8;  // pictures along each side of a pixel

std::vector<float> truth(const Context& context, const Picture& picture, PictureSize size) {
  Renderer renderer(context, {size.width, size.height, 0, false, Edges::samples});
  std::vector<float> mean(4 * static_cast<std::size_t>(size.width) *
                          static_cast<std::size_t>(size.height));
  Image image;
  for (int k = 0; k < kSide * kSide; ++k) {
    Picture moved = picture;
    for (Panel& panel : moved.panels) {
      glm::mat4 aside(1.0f);
      aside[3][0] = 2.0f * ((k % kSide + 0.5f) / kSide - 0.5f) / panel.place.width;
      aside[3][1] = 2.0f * ((k / kSide + 0.5f) / kSide - 0.5f) / panel.place.height;
      panel.list.view.clip_from_world = aside * panel.list.view.clip_from_world;
    }
    renderer.draw(moved, image);
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += image.pixels[i] / static_cast<float>(kSide * kSide);
  }
  return mean;
}

double squared_error(const Image& image, const std::vector<float>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double off = i % 4 == 3 ? 0.0 : image.pixels[i] - truth[i];
    sum += off * off;
  }
  return sum / (0.75 * static_cast<double>(truth.size()));
}

void judge(const std::string& file, const std::string& size, const Context& context) {
  Overrides overrides;
  overrides.size = size;
  const Solved solved = solve(load_with_overrides(file, overrides));
  const PictureSize pixels = solved.scene.video.size;
  const Frames frames = plan_frames(solved, {});
  const Film film = make_film(solved, frames.timeline, nullptr, {}, false);
  struct Way {
    int samples;
    Edges edges;
    double error = 0.0;
  };
  std::vector<Way> ways = {{0, Edges::samples}, {4, Edges::samples}, {0, Edges::outlines}};
  for (int i = 0; i < kMoments; ++i) {
    Picture picture = film.at(frames.film_time(frames.count * (2 * i + 1) / (2 * kMoments)));
    picture.stamps.clear();
    const std::vector<float> mean = truth(context, picture, pixels);
    for (Way& way : ways) {
      Renderer renderer(context, {pixels.width, pixels.height, way.samples, false, way.edges});
      Image image;
      renderer.draw(picture, image);
      way.error += squared_error(image, mean) / kMoments;
    }
  }
  const auto psnr = [](double error) {
    return 10.0 * std::log10(255.0 * 255.0 / error);
  };
  fmt::print("{:<36} {:>8.2f} {:>9.2f} {:>9.2f} {:>+9.2f}\n",
             std::filesystem::path(file).stem().string(),
             psnr(ways[0].error),
             psnr(ways[1].error),
             psnr(ways[2].error),
             psnr(ways[2].error) - psnr(ways[1].error));
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
