// SPDX-License-Identifier: MIT
// Which planted defects the rules of other projects and ours catch: the table of
// docs/diff.md.
//   cmake --build --preset release --target diff_rules && build/release/tests/diff_rules
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <fmt/format.h>

#include "app/commands/render.h"
#include "base/system/atomic_file.h"
#include "base/system/scratch_folder.h"
#include "image/png.h"
#include "image/ssim.h"
#include "image/verdict.h"

namespace polhode {
namespace {

constexpr const char* kScene = R"(format = 1
title = "A top"
[body]
solid = { kind = "ellipsoid", semi_axes = [0.1, 0.1, 0.2], mass = 1.0 }
[motion]
duration = 2
attitude = { zxz_deg = [0, 48, 0] }
spin = { rates_deg_per_s = [72, 0, 72] }
[video]
size = "960x540"
[camera]
eye = [0.9, 0.5, 0.38]
target = [0, 0, 0.03]
[show]
)";

Image drawn(const std::string& show, double time = 1.0, bool transparent = false) {
  const ScratchFolder scratch;
  write_file(scratch / "scene.toml", kScene + show);
  RenderJob job;
  job.scene = scratch / "scene.toml";
  job.output = scratch / "picture.png";
  job.still = time;
  job.transparent = transparent;
  job.progress = ProgressKind::none;
  render_film(job);
  return read_png(job.output);
}

std::uint8_t level(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

// `change(value, x, y, channel)` of every value of colour
template <class Change>
Image changed(const Image& image, const Change& change) {
  Image out = image;
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      for (int c = 0; c < 3; ++c)
        out.at(x, y)[c] = level(change(image.at(x, y)[c], x, y, c));
    }
  }
  return out;
}

Image noisy(const Image& image, int most) {
  std::mt19937 random(1);
  return changed(image, [&](int value, int, int, int) {
    return value + static_cast<int>(random() % static_cast<unsigned>(2 * most + 1)) - most;
  });
}

// what lies at a place between pixels
double between(const Image& image, double x, double y, int c) {
  const double cx = std::clamp(x, 0.0, image.width - 1.001),
               cy = std::clamp(y, 0.0, image.height - 1.001);
  const int i = static_cast<int>(cx), j = static_cast<int>(cy);
  const double u = cx - i, v = cy - j;
  return (1 - v) * ((1 - u) * image.at(i, j)[c] + u * image.at(i + 1, j)[c]) +
         v * ((1 - u) * image.at(i, j + 1)[c] + u * image.at(i + 1, j + 1)[c]);
}

Image rotated(const Image& image, double degrees) {
  const double a = degrees * 3.14159265358979 / 180.0;
  return changed(image, [&](int, int x, int y, int c) {
    const double dx = x - 0.5 * image.width, dy = y - 0.5 * image.height;
    return between(image,
                   0.5 * image.width + std::cos(a) * dx - std::sin(a) * dy,
                   0.5 * image.height + std::sin(a) * dx + std::cos(a) * dy,
                   c);
  });
}

Image blurred(const Image& image) {
  return changed(image, [&](int, int x, int y, int c) {
    double sum = 0.0;
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        sum += image.at(std::clamp(x + i, 0, image.width - 1),
                        std::clamp(y + j, 0, image.height - 1))[c];
      }
    }
    return sum / 9.0;
  });
}

// `share` of the pixels, strewn about, by this many levels
Image strewn(const Image& image, double share, int levels) {
  std::mt19937 random(2);
  Image out = image;
  const auto count = static_cast<long>(share * image.width * image.height);
  for (long i = 0; i < count; ++i) {
    std::uint8_t* pixel =
        out.pixels.data() + 4 * (random() % static_cast<unsigned>(image.width * image.height));
    for (int c = 0; c < 3; ++c)
      pixel[c] = level(pixel[c] < 128 ? pixel[c] + levels : pixel[c] - levels);
  }
  return out;
}

// pixels with some value over the threshold, as a share; idiff's failpercent
double share_over(const Image& a, const Image& b, int threshold) {
  return compare(a, b, threshold).fraction_over;
}

// values over the threshold, as a share of all values
double values_over(const Image& a, const Image& b, double threshold) {
  long over = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    over += std::abs(a.pixels[i] - b.pixels[i]) > threshold ? 1 : 0;
  return static_cast<double>(over) / static_cast<double>(a.pixels.size());
}

// vtkImageDifference as PyVista sets it: no shift, averages of 3x3 also count, threshold 1; sum
// over pixels, where 1 is a pixel that turned from black to white
double pyvista_error(const Image& a, const Image& b) {
  const Image mean_a = blurred(a), mean_b = blurred(b);
  double total = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
    int direct = 0, averaged = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
      direct += std::abs(a.pixels[c] - b.pixels[c]);
      averaged += std::abs(mean_a.pixels[c] - mean_b.pixels[c]);
    }
    total += std::max(0, std::min(direct, averaged) - 1) / (3.0 * 255.0);
  }
  return total;
}

// VTK compares colours alone
Image without_alpha(Image image) {
  for (std::size_t i = 3; i < image.pixels.size(); i += 4)
    image.pixels[i] = 255;
  return image;
}

struct Rule {
  const char* name;
  std::function<bool(const Image&, const Image&)> fails;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> table = {
      {"VTK",
       [](const Image& a, const Image& b) {
         return 1.0 - ssim(without_alpha(a), without_alpha(b)) > 0.05;
       }},
      {"Blender",
       [](const Image& a, const Image& b) {
         return share_over(a, b, 4) > 0.01;
       }},
      {"Manim",
       [](const Image& a, const Image& b) {
         return values_over(a, b, 1.01) > 1e-5;
       }},
      {"pygfx",
       [](const Image& a, const Image& b) {
         return compare(a, b, 0).largest > 3;
       }},
      {"PyVista",
       [](const Image& a, const Image& b) {
         return pyvista_error(a, b) > 500.0;
       }},
      {"Polhode",
       [](const Image& a, const Image& b) {
         return !judge(a, b, {}).same();
       }},
  };
  return table;
}

struct Case {
  const char* name;
  bool defect;  // false: a difference between machines, which must pass
  Image reference, picture;
};

std::vector<Case> planted() {
  const Image base = drawn("");
  const Image clear = drawn("", 1.0, true);
  Image dot = base;
  std::fill_n(dot.at(300, 100), 3, std::uint8_t{255});
  const auto shifted =
      changed(base, [&](int, int x, int y, int c) { return base.at(std::max(0, x - 1), y)[c]; });
  const auto tinted = [&](int by) {
    return changed(base, [by](int value, int, int, int c) { return value + (c == 0 ? by : 0); });
  };
  const auto gamma = changed(
      base, [](int value, int, int, int) { return 255.0 * std::pow(value / 255.0, 1.0 / 1.05); });
  return {{"nothing changed", false, base, base},
          {"noise of ±1 level", false, base, noisy(base, 1)},
          {"noise of ±3 levels", false, base, noisy(base, 3)},
          {"0.03 % of the pixels off by 60 (edge samples)", false, base, strewn(base, 3e-4, 60)},
          {"0.1 % of the pixels off by 10 (another driver)", false, base, strewn(base, 1e-3, 10)},
          {"shift by 1 pixel", true, base, shifted},
          {"rotated by 0.5°", true, base, rotated(base, 0.5)},
          {"a frame later (1/60 s)", true, base, drawn("", 1.0 + 1.0 / 60.0)},
          {"red up by 4 levels", true, base, tinted(4)},
          {"red up by 16 levels", true, base, tinted(16)},
          {"gamma 1.05", true, base, gamma},
          {"blur, 3×3", true, base, blurred(base)},
          {"arrow of Ω missing", true, base, drawn("omega = false\n")},
          {"thin axes missing", true, base, drawn("space_axes = false\n")},
          {"labels missing", true, base, drawn("labels = false\n")},
          {"clock missing", true, base, drawn("clock = false\n")},
          {"one pixel white", true, base, dot},
          {"1 % of the pixels off by 100", true, base, strewn(base, 0.01, 100)},
          {"alpha lost", true, clear, without_alpha(clear)}};
}

void print_table() {
  fmt::print("| difference |");
  for (const Rule& rule : rules())
    fmt::print(" {} |", rule.name);
  fmt::print(" largest | over 3 | RMSE | SSIM | FLIP |\n|---|");
  for (std::size_t i = 0; i < rules().size() + 5; ++i)
    fmt::print("---|");
  fmt::print("\n");
  std::vector<int> right(rules().size());
  const std::vector<Case> cases = planted();
  for (const Case& one : cases) {
    fmt::print("| {} |", one.name);
    for (std::size_t i = 0; i < rules().size(); ++i) {
      const bool fails = rules()[i].fails(one.reference, one.picture);
      right[i] += fails == one.defect ? 1 : 0;
      fmt::print(" {} |",
                 fails ? (one.defect ? "caught" : "**false alarm**")
                       : (one.defect ? "**missed**" : "passes"));
    }
    const Difference d = compare(one.reference, one.picture, 3);
    fmt::print(" {} | {} | {:.2f} | {:.4f} | {:.4f} |\n",
               d.largest,
               percent(d.fraction_over),
               d.rms,
               ssim(one.reference, one.picture),
               flip(one.reference, one.picture).mean);
  }
  fmt::print("| **right, of {}** |", cases.size());
  for (const int count : right)
    fmt::print(" {} |", count);
  fmt::print(" | | | | |\n");
}

}  // namespace
}  // namespace polhode

int main() {
  try {
    polhode::print_table();
    return 0;
  } catch (const polhode::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.fault());
  }
}
