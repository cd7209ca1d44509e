// SPDX-License-Identifier: MIT
// What comparing two pictures costs: 1920x1080, a drawn scene against itself with small
// differences.
#include <benchmark/benchmark.h>

#include "image/compare.h"
#include "image/flip.h"
#include "image/ssim.h"

namespace polhode {
namespace {

// smooth, with edges; the other with a level of noise everywhere, the worst case for every shortcut
Image picture(int noise) {
  Image image(1920, 1080);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::uint8_t* pixel = image.at(x, y);
      const int disc = (x - 900) * (x - 900) + (y - 500) * (y - 500) < 90'000 ? 80 : 0;
      for (int c = 0; c < 3; ++c) {
        const int value = 20 + x / 24 + y / 12 * c / 3 + disc + (x * 7 + y * 13) % (noise + 1);
        pixel[c] = static_cast<std::uint8_t>(value);
      }
      pixel[3] = 255;
    }
  }
  return image;
}

void values(benchmark::State& state, int noise) {
  const Image a = picture(0), b = picture(noise);
  for (auto _ : state)
    benchmark::DoNotOptimize(compare(a, b, 3).rms);
}
void structural_similarity(benchmark::State& state) {
  const Image a = picture(0), b = picture(1);
  for (auto _ : state)
    benchmark::DoNotOptimize(ssim(a, b, static_cast<int>(state.range(0))));
}
void flip_map(benchmark::State& state) {
  const Image a = picture(0), b = picture(1);
  for (auto _ : state)
    benchmark::DoNotOptimize(flip(a, b, kPixelsPerDegree, static_cast<int>(state.range(0))).mean);
}

BENCHMARK_CAPTURE(values, equal, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(values, a_level_apart, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(values, over_threshold, 9)->Unit(benchmark::kMillisecond);
BENCHMARK(structural_similarity)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(flip_map)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace polhode

BENCHMARK_MAIN();
