// SPDX-License-Identifier: MIT
#include "app/commands/chart_pictures.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "base/csv.h"
#include "base/system/interrupt.h"
#include "base/system/output_folder.h"
#include "base/system/overwriting.h"
#include "chart/plot_picture_error.h"
#include "film/overrides.h"
#include "film/solved_scene.h"
#include "frame/compose.h"
#include "image/compare.h"
#include "image/shrink.h"
#include "render/context.h"
#include "render/renderer.h"

namespace polhode {
namespace {

// A way to draw: samples per pixel by the driver, and pictures drawn larger and averaged.
struct DrawingSetting {
  const char* name;
  int samples;
  int supersampling;  // sides of the drawn picture over those of the finished one
  Edges edges = Edges::samples;
};
constexpr DrawingSetting kSettings[] = {
    {"no anti-aliasing", 0, 1},
    {"4 samples (render, small pictures)", 4, 1},
    {"outlines (render)", 0, 1, Edges::outlines},
    {"2x2 pictures", 0, 2},
    {"2x2 pictures of 4 samples", 4, 2},
    {"3x3 pictures", 0, 3},
    {"4x4 pictures", 0, 4},
    {"4x4 pictures of 4 samples", 4, 4},
};
constexpr DrawingSetting kReference = {"8x8 pictures of 4 samples", 4, 8};
constexpr int kMoments = 5;
// the reference is 64 times this
constexpr int kMostPixelsOfPictures = 960 * 540;

struct Drawn {
  std::vector<Image> pictures;
  double time_ms = 0.0;  // median of a frame
};

Composer composer_for(const Solved& solved, const PictureSize& size) {
  const Scene& scene = solved.scene;
  return {solved.simulation.motion, scene.body, scene.camera, scene.show, scene.theme, size};
}

Drawn draw(const Solved& solved, const Context& context, const DrawingSetting& setting) {
  const Scene& scene = solved.scene;
  const int k = setting.supersampling;
  const PictureSize size{scene.video.size.width * k, scene.video.size.height * k};
  const Composer composer = composer_for(solved, size);
  // an automatic camera finds another place for pictures of another size
  const Composer framing = composer_for(solved, scene.video.size);
  Renderer renderer(context, {size.width, size.height, setting.samples, false, setting.edges});
  Drawn drawn;
  std::vector<double> times;
  Image large;
  // the first one warms up
  for (int i = -1; i < kMoments; ++i) {
    stop_if_interrupted();
    const double t = scene.motion.duration * std::max(i, 0) / (kMoments - 1);
    const View view = framing.at(t).view;
    const auto start = std::chrono::steady_clock::now();
    DrawList list = composer.at(t);
    list.view = view;
    renderer.draw(list, large);
    Image picture = k == 1 ? large : shrunk(large, k);
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    if (i < 0) continue;
    times.push_back(spent.count());
    drawn.pictures.push_back(std::move(picture));
  }
  std::nth_element(times.begin(), times.begin() + kMoments / 2, times.end());
  drawn.time_ms = times[kMoments / 2];
  return drawn;
}

PicturePoint judged(const DrawingSetting& setting, const Drawn& drawn, const Drawn& truth) {
  PicturePoint p{setting.name, setting.samples, setting.supersampling, drawn.time_ms, 0.0, 0};
  double squares = 0.0;
  for (std::size_t i = 0; i < truth.pictures.size(); ++i) {
    const Difference apart = compare(drawn.pictures[i], truth.pictures[i], 0);
    p.max_levels = std::max(p.max_levels, apart.largest);
    squares += apart.rms * apart.rms;
  }
  p.rmse_levels = std::sqrt(squares / static_cast<double>(truth.pictures.size()));
  return p;
}

}  // namespace

std::string chart_pictures(const ChartJob& job) {
  refuse_same_stem(job.scenes);
  std::vector<Solved> solved;
  for (const std::filesystem::path& file : job.scenes) {
    Scene scene = load_single(file, job.overrides);
    PictureSize& size = scene.video.size;
    const auto too_large = [&] {
      return size.width * size.height > kMostPixelsOfPictures;
    };
    if (job.overrides.size && too_large()) {
      throw input_error(
          "{} x {} is too large: the reference has 64 times as many pixels; at most 960x540",
          size.width,
          size.height)
          .at({{}, 0, "--size"});
    }
    // a scene's own size is shrunk, its sides even
    const PictureSize own = size;
    for (int factor = 2; too_large(); ++factor) {
      size.width = std::max(2, own.width / (2 * factor) * 2);
      size.height = std::max(2, own.height / (2 * factor) * 2);
    }
    solved.push_back(solve(scene));
  }
  require_gnuplot();
  const std::filesystem::path where = folder_or_default(job.output, job.scenes.front(), "chart");
  const std::vector<std::string> names = {"chart.csv", "chart.svg", "chart.png", "chart.pdf"};
  refuse_same_files(where, names, {job.scenes.begin(), job.scenes.end()});
  OutputFolder folder(where, names);
  const std::unique_ptr<Context> context = open_context("auto");

  Progress progress(
      job.progress, static_cast<int>(solved.size() * (std::size(kSettings) + 1)), "settings");
  int done = 0;
  std::vector<PicturePanel> panels;
  std::string text;
  for (const Solved& scene : solved) {
    PicturePanel panel{
        std::filesystem::path(scene.scene.file).stem().string(), scene.scene.title, {}};
    const Drawn truth = draw(scene, *context, kReference);
    progress.show(++done);
    const PictureSize& size = scene.scene.video.size;
    text += fmt::format(
        "{} at {}x{}: error against {}\n", panel.scene, size.width, size.height, kReference.name);
    for (const DrawingSetting& setting : kSettings) {
      const PicturePoint p = judged(setting, draw(scene, *context, setting), truth);
      text += fmt::format("  {:<26} {:>8.1f} ms a frame, RMSE {:.3f} levels of 255\n",
                          p.setting,
                          p.time_ms,
                          p.rmse_levels);
      panel.points.push_back(p);
      progress.show(++done);
    }
    panels.push_back(std::move(panel));
  }
  folder.commit({picture_error_csv(panels),
                 plot_picture_error(panels, PlotFormat::svg),
                 plot_picture_error(panels, PlotFormat::png),
                 plot_picture_error(panels, PlotFormat::pdf)});
  return text;
}

}  // namespace polhode
