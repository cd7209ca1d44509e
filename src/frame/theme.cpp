// SPDX-License-Identifier: MIT
#include "frame/theme.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>

#include "base/at_place.h"
#include "base/color.h"
#include "base/error.h"
#include "base/nearest.h"

namespace polhode {
namespace {

// relative luminance of a colour, and the contrast of two (WCAG 2.1)
double luminance(const glm::vec3& color) {
  return 0.2126 * linear_of_srgb(color.r) + 0.7152 * linear_of_srgb(color.g) +
         0.0722 * linear_of_srgb(color.b);
}
double contrast(const glm::vec3& a, const glm::vec3& b) {
  const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

}  // namespace

bool is_light(const glm::vec3& color) {
  return contrast(color, glm::vec3(0.0f)) > contrast(color, glm::vec3(1.0f));
}

glm::vec3 readable(const glm::vec3& color, const glm::vec3& background) {
  constexpr double kContrast = 4.55;  // and a little for the rounding to bytes
  if (contrast(color, background) >= kContrast) return color;
  const glm::vec3 end(is_light(background) ? 0.0f : 1.0f);
  float less = 0.0f, enough = 1.0f;  // of that end
  for (int i = 0; i < 12; ++i) {
    const float part = 0.5f * (less + enough);
    const bool reached = contrast(glm::mix(color, end, part), background) >= kContrast;
    (reached ? enough : less) = part;
  }
  return glm::mix(color, end, enough);
}

glm::vec3 color_from_hex(const std::string& text) {
  const std::array<std::uint8_t, 3> bytes = parse_color(text);
  return glm::vec3(bytes[0], bytes[1], bytes[2]) / 255.0f;
}

// Long, because it is one table: a row for each.
const std::vector<Theme>& themes() {
  const auto hex = color_from_hex;
  static const std::vector<Theme> table = {
      {.name = "dark",
       .background = hex("#10141c"),
       .body = hex("#e6ddcc"),
       .mark = hex("#a8323e"),
       .omega = hex("#f0a51f"),
       .momentum = hex("#64c1f7"),
       .body_axes = hex("#35a983"),
       .space_axes = hex("#8a93a3"),
       .space_cone = hex("#56b4e9"),
       .body_cone = hex("#d98bb8"),
       .precession_cone = hex("#f0e442"),
       .stand = hex("#6c7482"),
       .force = hex("#9e7aff"),
       .friction = hex("#c46eb0"),
       .velocity = hex("#e56a52"),
       .position = hex("#f2f4f8"),
       .ellipsoid = hex("#94c886"),
       .plane = hex("#c45a92"),
       .polhode = hex("#fff04d"),
       .polhodes = hex("#d9e6d4"),
       .herpolhode = hex("#ff7a5c"),
       .trail = hex("#a8f0b0"),
       .floor = hex("#2c3442"),
       .shadow = hex("#05070b")},
      {.name = "light",
       .background = hex("#f6f4ef"),
       .body = hex("#e2d2b0"),
       .mark = hex("#8f2430"),
       .omega = hex("#ee7000"),
       .momentum = hex("#0170cb"),
       .body_axes = hex("#057251"),
       .space_axes = hex("#6b7076"),
       .space_cone = hex("#3a9bd6"),
       .body_cone = hex("#c05f95"),
       .precession_cone = hex("#b89b00"),
       .stand = hex("#8b9097"),
       .force = hex("#4b35a1"),
       .friction = hex("#aa5082"),
       .velocity = hex("#8f2a19"),
       .position = hex("#22262c"),
       .ellipsoid = hex("#6fb488"),
       .plane = hex("#a03c86"),
       .polhode = hex("#b58900"),
       .polhodes = hex("#3a5c48"),
       .herpolhode = hex("#b5301c"),
       .trail = hex("#179965"),
       .floor = hex("#e9e5db"),
       .shadow = hex("#2c2a2e")},
      // for weak lamps and bright rooms: black on white, strong colours, no pale surface
      {.name = "projector",
       .background = hex("#ffffff"),
       .body = hex("#c9a878"),
       .mark = hex("#7a0f1c"),
       .omega = hex("#c64f04"),
       .momentum = hex("#005dc2"),
       .body_axes = hex("#006046"),
       .space_axes = hex("#363a40"),
       .space_cone = hex("#0072b2"),
       .body_cone = hex("#a8327c"),
       .precession_cone = hex("#8a6d00"),
       .stand = hex("#62676e"),
       .force = hex("#371f90"),
       .friction = hex("#965078"),
       .velocity = hex("#97260e"),
       .position = hex("#000000"),
       .ellipsoid = hex("#58a68c"),
       .plane = hex("#6e1f50"),
       .polhode = hex("#7a5c00"),
       .polhodes = hex("#1f4a3a"),
       .herpolhode = hex("#9e1e0a"),
       .trail = hex("#179965"),
       .floor = hex("#dedede"),
       .shadow = hex("#1c1c26")},
      // for paper: white ground, and greys that stay apart without colour
      {.name = "print",
       .background = hex("#ffffff"),
       .body = hex("#d8d8d8"),
       .mark = hex("#404040"),
       .omega = hex("#bc5600"),
       .momentum = hex("#043b69"),
       .body_axes = hex("#116f53"),
       .space_axes = hex("#7e7e7e"),
       .space_cone = hex("#5a9bc7"),
       .body_cone = hex("#b0709a"),
       .precession_cone = hex("#a89030"),
       .stand = hex("#9a9a9a"),
       .force = hex("#5f42b7"),
       .friction = hex("#a05a8c"),
       .velocity = hex("#8c3424"),
       .position = hex("#101010"),
       .ellipsoid = hex("#8fbfa0"),
       .plane = hex("#7d4a66"),
       .polhode = hex("#5c4700"),
       .polhodes = hex("#3f5a48"),
       .herpolhode = hex("#802010"),
       .trail = hex("#5c996e"),
       .floor = hex("#ececec"),
       .shadow = hex("#202020")},
  };
  return table;
}

std::vector<std::string> material_names() {
  return {"plain", "painted_wood", "brushed_metal", "ceramic"};
}

std::vector<std::string> traced_vectors() {
  return {"omega", "momentum"};
}

std::vector<std::string> hidden_names() {
  return {"dashed", "faint", "none"};
}

Finish finish_named(const std::string& material) {
  const std::vector<std::string> names = material_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == material) return static_cast<Finish>(i);
  }
  return Finish::plain;
}

std::vector<std::string> theme_names() {
  std::vector<std::string> names;
  for (const Theme& theme : themes())
    names.push_back(theme.name);
  return names;
}

const Theme& find_theme(const std::string& name) {
  for (const Theme& theme : themes()) {
    if (theme.name == name) return theme;
  }
  throw input_error("unknown theme '{}'{}", name, suggestion(name, theme_names()));
}

Theme make_theme(const ThemeSpec& spec) {
  Theme theme = at_place({{}, 0, "video.theme"}, [&] { return find_theme(spec.theme); });
  if (spec.background) theme.background = color_from_hex(*spec.background);
  return theme;
}

}  // namespace polhode
