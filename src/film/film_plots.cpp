// SPDX-License-Identifier: MIT
#include "film/film_plots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "chart/gnuplot.h"
#include "image/png.h"
#include "motion/recorded.h"

namespace polhode {
namespace {

constexpr double kWidth = 0.36;  // of the frame
constexpr double kTop = 0.12;    // free above and below, of the frame's height: title and clock
constexpr double kBottom = 0.10;
// of a plot, where its axes are
constexpr double kLeft = 0.19, kRight = 0.96;
constexpr int kPoints = 800;

std::string hex(const glm::vec3& color) {
  const auto byte = [](float value) {
    return static_cast<int>(std::lround(255.0f * value));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b));
}

// the values of all curves over the motion, a block for gnuplot
struct Table {
  std::string rows;
  double low = 0.0, high = 0.0;
};

Table table_of(const Recorded& quantity, const Motion& motion) {
  Table table;
  table.low = std::numeric_limits<double>::infinity();
  table.high = -table.low;
  for (int i = 0; i <= kPoints; ++i) {
    const Sample now = motion.at(motion.duration() * i / kPoints);
    table.rows.append(gnuplot_number(now.t));
    for (const double value : quantity.values(motion, now)) {
      table.rows.append(" ").append(gnuplot_number(value));
      if (!std::isfinite(value)) continue;
      table.low = std::min(table.low, value);
      table.high = std::max(table.high, value);
    }
    table.rows += "\n";
  }
  // room above and below; a constant gets an axis that does not magnify round-off
  if (!(table.low <= table.high)) table.low = table.high = 0.0;
  const double size = std::max(std::abs(table.low), std::abs(table.high));
  const double room = std::max(
      {0.08 * (table.high - table.low), quantity.unit.empty() ? 1e-16 : 1e-3 * size, 1e-300});
  table.low -= room;
  table.high += room;
  return table;
}

// Sizes of type and lines in a plot of this height.
struct PlotType {
  double font = 0.0;         // gnuplot's points: 1/72 inch of 96 pixels each
  double line_height = 0.0;  // in parts of the plot
  double line = 1.0;         // width of curves, pixels
};

PlotType type_of(const PixelBox& place, double text_size) {
  PlotType type;
  type.font = 0.75 * text_size * 0.058 * std::min<double>(place.height * 1.3, place.width);
  type.line_height = type.font / 0.75 / place.height;
  type.line = std::max(1.0, place.height / 100.0);
  return type;
}

// what the axes and the curves have in common: data, and their place in the picture
std::string frame_script(const Table& table, const PlotType& type, double duration) {
  return fmt::format(
      "$data << EOD\n{}EOD\n"
      "set lmargin at screen {}\nset rmargin at screen {}\n"
      "set bmargin at screen {}\nset tmargin at screen {}\n"
      "set xrange [0:{}]\nset yrange [{}:{}]\n",
      table.rows,
      kLeft,
      kRight,
      2.0 * type.line_height,
      1.0 - 1.7 * type.line_height,
      gnuplot_number(duration),
      gnuplot_number(table.low),
      gnuplot_number(table.high));
}

// axes with the names of curves
std::string axes_script(const Recorded& quantity, const Theme& theme, const PlotType& type) {
  const std::string unit = quantity.unit.empty() ? "" : fmt::format(", {}", quantity.unit);
  std::string script = fmt::format(
      "set border 3 linecolor rgb '{0}' linewidth {1}\n"
      "set tics nomirror out font ',{2}' textcolor rgb '{0}'\n"
      "set xtics autofreq\nset format y '%.4g'\nset ytics autofreq\nset mxtics 1\n"
      "set key at screen {3},screen 0.995 right top horizontal samplen 1 "
      "font ',{2}' textcolor rgb '{0}'\n"
      "set label 1 {4} at screen 0.03,screen {6} left "
      "font ',{2}' textcolor rgb '{5}'\n",
      hex(theme.space_axes),
      0.45 * type.line,
      type.font,
      kRight,
      gnuplot_text(fmt::format("{}{}", quantity.title, unit)),
      hex(theme.position),
      1.0 - 0.75 * type.line_height);
  if (quantity.curves.size() == 1) script += "unset key\n";
  return script;
}

// the command that draws all curves; without data their names alone are in the key
std::string plot_command(const Recorded& quantity,
                         const Theme& theme,
                         const PlotType& type,
                         bool with_data) {
  const std::array<glm::vec3, 3> colors = {theme.omega, theme.momentum, theme.body_axes};
  std::string command;
  for (std::size_t i = 0; i < quantity.curves.size(); ++i) {
    command += fmt::format("{}{} with lines linewidth {} dashtype {} linecolor rgb '{}'",
                           i == 0 ? "plot " : ", ",
                           with_data ? fmt::format("$data using 1:{}", i + 2) : "NaN",
                           type.line,
                           i + 1,
                           hex(colors[i % colors.size()]));
    if (!with_data) command += fmt::format(" title {}", gnuplot_text(quantity.curves[i]));
  }
  return command + "\n";
}

FilmPlot draw(const Recorded& quantity,
              const Motion& motion,
              const Theme& theme,
              double text_size,
              const PixelBox& place) {
  const PlotType type = type_of(place, text_size);
  const std::string frame = frame_script(table_of(quantity, motion), type, motion.duration());
  const auto picture = [&](const std::string& script) {
    const std::string bytes =
        draw_with_gnuplot(frame + script, PlotFormat::overlay, place.width, place.height);
    return std::make_shared<const Sprite>(sprite_of(decode_png(bytes, "plot")));
  };
  return {
      place,
      picture(axes_script(quantity, theme, type) + plot_command(quantity, theme, type, false)),
      picture("unset border\nunset tics\nunset key\n" + plot_command(quantity, theme, type, true)),
      static_cast<int>(std::lround(kLeft * place.width)),
      static_cast<int>(std::lround(kRight * place.width)),
      0.0,
      motion.duration()};
}

}  // namespace

double width_of_plots(const ShowSpec& show) {
  return show.plots.empty() ? 0.0 : kWidth;
}

std::vector<FilmPlot> make_plots(const Solved& solved) {
  const Scene& scene = solved.scene;
  std::vector<FilmPlot> plots;
  if (scene.show.plots.empty()) return plots;
  require_gnuplot();
  const PictureSize size = scene.video.size;
  const int count = static_cast<int>(scene.show.plots.size());
  const int top = static_cast<int>(std::lround(kTop * size.height));
  const int all = size.height - top - static_cast<int>(std::lround(kBottom * size.height));
  // no plot is higher than it is wide
  const int width = static_cast<int>(std::lround(0.97 * kWidth * size.width));
  const int height = std::min(all / count, width * 3 / 4);
  const int first = top + (all - height * count) / 2;
  for (int i = 0; i < count; ++i) {
    for (const Recorded& quantity : recorded_quantities()) {
      if (quantity.name != scene.show.plots[static_cast<std::size_t>(i)]) continue;
      const PixelBox place{
          size.width - width - size.width / 100, first + i * height, width, height};
      plots.push_back(draw(quantity,
                           solved.simulation.motion,
                           make_theme(scene.theme),
                           scene.show.text_size,
                           place));
    }
  }
  return plots;
}

}  // namespace polhode
