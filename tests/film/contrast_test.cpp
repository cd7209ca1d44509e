// SPDX-License-Identifier: MIT
// Whether text stands out from the picture around it: contrast by WCAG 2.1, read from rendered
// frames.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include "film/local_renderer.h"
#include "film/small_films.h"
#include "frame/theme.h"
#include "scene/scene_file.h"
#include "support/scenes.h"

namespace polhode {
namespace {

using test::scene_names;
using test::scene_path;

constexpr double kLeastContrast = 4.5;  // WCAG 2.1, success criterion 1.4.3

double contrast(const Rgb& a, const Rgb& b) {
  const auto luminance = [](const Rgb& color) {
    const auto linear = [](double c) {
      return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color[0] / 255.0) + 0.7152 * linear(color[1] / 255.0) +
           0.0722 * linear(color[2] / 255.0);
  };
  const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

// The least contrast of a text with the pixels that touch its letters. A rim around the letters is
// part of what is around them.
double least_contrast(const Typesetter& typesetter, const PlacedText& text, const Image& image) {
  const TextBox box = typesetter.measure(text.markup, text.style);
  TextStyle bare = text.style;
  bare.halo = 0.0;
  const Stamp stamp =
      typesetter.set(text.markup, bare, text.room.left - box.ink_left, text.room.top - box.ink_top);
  const Sprite& letters = *stamp.sprite;
  const auto is_inked = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= letters.width || y >= letters.height) return false;
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(letters.width) +
                    static_cast<std::size_t>(x);
    return letters.pixels[4 * at + 3] != 0;
  };
  const auto touches = [&](int x, int y) {
    return is_inked(x - 1, y) || is_inked(x + 1, y) || is_inked(x, y - 1) || is_inked(x, y + 1);
  };
  double least = std::numeric_limits<double>::infinity();
  for (int y = -1; y <= letters.height; ++y) {
    for (int x = -1; x <= letters.width; ++x) {
      const int column = stamp.x + x, row = stamp.y + y;
      if (column < 0 || row < 0 || column >= image.width || row >= image.height) continue;
      if (is_inked(x, y) || !touches(x, y)) continue;
      const std::uint8_t* pixel = image.at(column, row);
      least = std::min(least, contrast(text.style.color, {pixel[0], pixel[1], pixel[2]}));
    }
  }
  return least;
}

// `looks` frames of a film in a theme, spread evenly
void expect_contrast(const std::string& name, const std::string& theme, int looks) {
  RenderPlan plan = test::plan_of(load_scene(scene_path(name)));
  plan.text = true;
  plan.scene.theme.theme = theme;
  plan.scene.video.size = {1920, 1080};
  const PreparedFilm prepared(plan);
  const std::unique_ptr<FrameRenderer> renderer = open_local_renderer(prepared, {});
  const Typesetter typesetter;
  Image image;
  for (int look = 0; look < looks; ++look) {
    const int index = (2 * look + 1) * prepared.frames().count / (2 * looks);
    renderer->render(index, image);
    for (const PlacedText& text :
         prepared.film().placed(prepared.frames().film_time(index)).texts) {
      if (text.opacity < 1.0) continue;
      const double found = least_contrast(typesetter, text, image);
      EXPECT_GE(found, kLeastContrast)
          << name << ", " << theme << ", frame " << index << ": " << text.markup;
    }
  }
}

// the slow tier sets POLHODE_THOROUGHLY: all films
TEST(Contrast, TextStandsOutFromThePictureInEveryTheme) {
  const bool all = std::getenv("POLHODE_THOROUGHLY") != nullptr;
  const std::vector<std::string> some = {"compare_euler", "nutation_plots", "poinsot", "two_views"};
  for (const std::string& name : all ? scene_names() : some) {
    for (const Theme& theme : themes())
      expect_contrast(name, theme.name, all ? 4 : 1);
  }
}

}  // namespace
}  // namespace polhode
