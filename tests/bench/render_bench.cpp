// SPDX-License-Identifier: MIT
// What composing and drawing a frame of the demo costs at 1920x1080 and 640x360.
#include <benchmark/benchmark.h>

#include "film/overrides.h"
#include "film/solved_scene.h"
#include "render/renderer.h"

namespace polhode {
namespace {

void draw_frame(benchmark::State& run) {
  const int height = static_cast<int>(run.range(0));
  Overrides overrides;
  overrides.size = fmt::format("{}x{}", height * 16 / 9, height);
  const Solved solved =
      solve(load_with_overrides(POLHODE_SOURCE_DIR "/scenes/free_symmetric_top.toml", overrides));
  const Scene& scene = solved.scene;
  const Composer composer(solved.simulation.motion,
                          scene.body,
                          scene.camera,
                          scene.show,
                          scene.theme,
                          scene.video.size);
  const std::unique_ptr<Context> context = open_context("auto");
  Renderer renderer(*context, {scene.video.size.width, scene.video.size.height, 4, false});
  Image image;
  double t = 0.0;
  for (auto _ : run) {
    t = t < 9.9 ? t + 1.0 / 60.0 : 0.0;
    renderer.draw(composer.at(t), image);
  }
}
BENCHMARK(draw_frame)->Arg(360)->Arg(1080)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace polhode

BENCHMARK_MAIN();
