// SPDX-License-Identifier: MIT
#include "app/commands/preview.h"

#include <algorithm>
#include <cmath>

#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "base/system/interrupt.h"
#include "base/system/overwriting.h"
#include "film/local_renderer.h"
#include "film/overrides.h"
#include "image/png.h"
#include "text/typesetter.h"

namespace polhode {
namespace {

constexpr int kTileColumns = 4;
constexpr int kRows = 3;
constexpr int kTileWidth = 480;        // pixels
constexpr int kTallest = 720;          // pixels; of a tile
constexpr int kGap = 16;               // pixels, between tiles
constexpr int kHead = 48;              // pixels, for the title
constexpr int kFoot = 28;              // pixels under a tile, for its time
constexpr double kTextOfTiles = 1.75;  // small pictures want larger letters
constexpr std::array<std::uint8_t, 4> kPaper = {24, 26, 30, 255};
constexpr Rgb kInk = {225, 228, 232};

// makes a scene what tiles can show
void make_small(Scene& scene) {
  PictureSize& size = scene.video.size;
  const double shrink = std::min(static_cast<double>(kTileWidth) / size.width,
                                 static_cast<double>(kTallest) / size.height);
  const auto side = [&](int pixels) {
    return std::max(kSmallestSide, static_cast<int>(std::lround(pixels * shrink)));
  };
  size = {side(size.width), side(size.height)};
  // instants, whose time stands under them
  scene.video.shutter = 0.0;
  scene.show.clock = false;
  scene.show.title = false;
  // plots have no room for more
  if (scene.show.plots.empty()) {
    scene.show.text_size = std::max(scene.show.text_size, kTextOfTiles);
  }
}

void lay_tile(Image& sheet, const Image& tile, int left, int top) {
  for (int y = 0; y < tile.height; ++y) {
    std::copy_n(tile.at(0, y), 4 * tile.width, sheet.at(left, top + y));
  }
}

// "3.25 s", with the moment of the motion where that is another
std::string time_of_tile(const FrameTimes& frames, double film) {
  const double motion = frames.timeline.motion_time(film);
  if (std::abs(motion - film) < 0.005) return fmt::format("{:.2f} s", film);
  return fmt::format("{:.2f} s   (motion {:.2f} s)", film, motion);
}

std::string output_of(const PreviewJob& job) {
  if (!job.output.empty()) return job.output;
  make_folder("output");
  return fmt::format("output/{}_preview.png", job.scene.stem().string());
}

}  // namespace

Made write_preview(const PreviewJob& job) {
  RenderPlan plan;
  plan.scene = load_with_overrides(job.scene, job.overrides);
  for_each_scene(plan.scene, make_small);
  const std::string output = output_of(job);
  if (!output.ends_with(".png")) {
    throw input_error("a preview is one picture; name a .png").at({output, 0, {}});
  }
  refuse_same_file(output, "the output", input_files(plan.scene));
  AtomicFile file(output);

  const PreparedFilm film(plan);
  film.warn();
  const std::unique_ptr<FrameRenderer> renderer = open_local_renderer(film, {job.backend});
  const Busy busy(plan.progress, "drawing the sheet");
  const FrameTimes& frames = film.frames();
  const PictureSize tile = plan.scene.video.size;
  const int step_x = tile.width + kGap, step_y = tile.height + kFoot + kGap;
  Image sheet;
  sheet.wipe(kTileColumns * step_x + kGap, kHead + kRows * step_y, kPaper);

  const Typesetter typesetter;
  const auto write = [&](const std::string& words, double size, int x, int y) {
    const TextStyle style{Face::sans, size, kInk};
    lay_over(sheet, typesetter.set(plain_text(words), style, x, y));
  };
  const std::string name = plan.scene.title.empty() ? job.scene.stem().string() : plan.scene.title;
  write(fmt::format("{}   {:.1f} s, {} frame{}",
                    one_line(name),
                    frames.count / frames.rate,
                    frames.count,
                    frames.count == 1 ? "" : "s"),
        22.0,
        kGap,
        12);
  constexpr int kTiles = kTileColumns * kRows;
  Image picture;
  for (int i = 0; i < kTiles; ++i) {
    stop_if_interrupted();
    const int index = static_cast<int>(std::int64_t{i} * (frames.count - 1) / (kTiles - 1));
    renderer->render(index, picture);
    const int left = kGap + i % kTileColumns * step_x, top = kHead + i / kTileColumns * step_y;
    lay_tile(sheet, picture, left, top);
    write(time_of_tile(frames, frames.film_time(index)), 17.0, left, top + tile.height + 4);
  }
  write_png(file, sheet, false);
  file.commit();
  Made made;
  made.output = output;
  made.frames = kTiles;
  made.is_picture = true;
  return made;
}

}  // namespace polhode
