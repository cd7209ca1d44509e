// SPDX-License-Identifier: MIT
#include "chart/plot_picture_error.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/csv.h"
#include "chart/map_axis.h"

namespace polhode {

std::string plot_picture_error(const std::vector<PicturePanel>& panels, PlotFormat format) {
  constexpr int kWidth = 1000;
  constexpr int kHeight = 500;
  constexpr std::array<const char*, 8> kColors = {
      "#7F7F7F", "#D55E00", "#0072B2", "#009E73", "#CC79A7", "#56B4E9", "#5D3A9B", "#222222"};
  constexpr std::array<int, 8> kMarks = {7, 5, 9, 11, 13, 15, 6, 4};
  std::string script = fmt::format(
      "set multiplot layout {},1\n"
      "set grid linecolor rgb '#dddddd' linewidth 0.5\n"
      "set key outside right top vertical Left reverse noenhanced\n",
      panels.size());
  for (const PicturePanel& panel : panels) {
    script += "set title " + gnuplot_text(panel.title) + "\n";
    double least = panel.points.front().rmse_levels, most = least;
    double fastest = panel.points.front().time_ms, slowest = fastest;
    std::string plots;
    for (std::size_t i = 0; i < panel.points.size(); ++i) {
      const PicturePoint& p = panel.points[i];
      least = std::min(least, p.rmse_levels);
      most = std::max(most, p.rmse_levels);
      fastest = std::min(fastest, p.time_ms);
      slowest = std::max(slowest, p.time_ms);
      script += fmt::format("$setting{} << EOD\n{} {}\nEOD\n",
                            i,
                            gnuplot_number(std::log10(p.time_ms)),
                            gnuplot_number(std::log10(p.rmse_levels)));
      plots += fmt::format(
          "{}$setting{} using 1:2 with points pointtype {} pointsize 1.5 linecolor rgb '{}' title "
          "{}",
          plots.empty() ? "plot " : ", ",
          i,
          kMarks[i % kMarks.size()],
          kColors[i % kColors.size()],
          gnuplot_text(p.setting));
    }
    script += logarithmic_axis_script(
        "x", "time of a frame, ms", std::log10(0.5 * fastest), std::log10(2.0 * slowest));
    script += logarithmic_axis_script("y",
                                      "root mean square error, levels of 255",
                                      std::log10(std::max(0.5 * least, 1e-3)),
                                      std::log10(std::max(2.0 * most, 2e-3)));
    script += plots + "\n";
  }
  script += "unset multiplot\n";
  return draw_with_gnuplot(script, format, kWidth, kHeight * static_cast<int>(panels.size()));
}

std::string picture_error_csv(const std::vector<PicturePanel>& panels) {
  std::string text = "scene,setting,samples,supersampling,time_ms,rmse_levels,max_levels\n";
  for (const PicturePanel& panel : panels) {
    for (const PicturePoint& p : panel.points) {
      text += fmt::format("{},{},{},{},{:.6g},{:.6g},{}\n",
                          csv_field(panel.scene),
                          csv_field(p.setting),
                          p.samples,
                          p.supersampling,
                          p.time_ms,
                          p.rmse_levels,
                          p.max_levels);
    }
  }
  return text;
}

}  // namespace polhode
