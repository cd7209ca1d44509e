// SPDX-License-Identifier: MIT
#include "frame/theme.h"

#include <array>

#include "base/color.h"
#include "base/error.h"
#include "base/nearest.h"

namespace polhode {

glm::vec3 color_from_hex(const std::string& text) {
  const std::array<std::uint8_t, 3> bytes = parse_color(text);
  return glm::vec3(bytes[0], bytes[1], bytes[2]) / 255.0f;
}

const std::vector<Theme>& themes() {
  const auto hex = color_from_hex;
  static const std::vector<Theme> table = {
      {.name = "dark",
       .background = hex("#10141c"),
       .body = hex("#e6ddcc"),
       .mark = hex("#a8323e"),
       .omega = hex("#f0a51e"),
       .momentum = hex("#5cb8ee"),
       .body_axes = hex("#2fbf94"),
       .space_axes = hex("#8a93a3"),
       .space_cone = hex("#56b4e9"),
       .body_cone = hex("#d98bb8"),
       .precession_cone = hex("#f0e442"),
       .stand = hex("#6c7482"),
       .force = hex("#b9a3ff"),
       .velocity = hex("#e8705a"),
       .position = hex("#f2f4f8")},
      {.name = "light",
       .background = hex("#f6f4ef"),
       .body = hex("#cdbb9c"),
       .mark = hex("#8f2430"),
       .omega = hex("#d55e00"),
       .momentum = hex("#0072b2"),
       .body_axes = hex("#007a5a"),
       .space_axes = hex("#6b7076"),
       .space_cone = hex("#3a9bd6"),
       .body_cone = hex("#c05f95"),
       .precession_cone = hex("#b89b00"),
       .stand = hex("#8b9097"),
       .force = hex("#5b3fb0"),
       .velocity = hex("#b5402c"),
       .position = hex("#22262c")},
  };
  return table;
}

std::vector<std::string> theme_names() {
  std::vector<std::string> names;
  for (const Theme& theme : themes())
    names.push_back(theme.name);
  return names;
}

Theme make_theme(const ThemeSpec& spec) {
  for (const Theme& row : themes()) {
    if (row.name != spec.theme) continue;
    Theme theme = row;
    if (spec.background) theme.background = color_from_hex(*spec.background);
    return theme;
  }
  throw input_error("no theme is called '{}'{}", spec.theme, suggestion(spec.theme, theme_names()))
      .at({{}, 0, "video.theme"});
}

}  // namespace polhode
