// SPDX-License-Identifier: MIT
#include "chart/plot_picture_error.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/csv.h"

namespace polhode {

std::string plot_picture_error(const std::vector<PicturePanel>& panels, PlotFormat format) {
  constexpr int kWidth = 1000;
  constexpr int kHeight = 550;
  std::string script = fmt::format(
      "set multiplot layout {},1\n"
      "set logscale xy\nset grid linecolor rgb '#dddddd' linewidth 0.5\nunset key\n"
      "set offsets graph 0.05, graph 0.4, graph 0.1, graph 0.1\n"
      "set xlabel 'time of a frame, ms'\n"
      "set ylabel 'root mean square error, levels of 255'\n",
      panels.size());
  for (const PicturePanel& panel : panels) {
    script += "unset label\nset title " + gnuplot_text(panel.title) + "\n$points << EOD\n";
    for (const PicturePoint& p : panel.points)
      script += fmt::format("{} {}\n", gnuplot_number(p.time_ms), gnuplot_number(p.rmse_levels));
    script += "EOD\n";
    // names above and below in turn, from the fastest on, so that neighbours do not meet
    std::vector<PicturePoint> sorted = panel.points;
    std::sort(sorted.begin(), sorted.end(), [](const PicturePoint& a, const PicturePoint& b) {
      return a.time_ms < b.time_ms;
    });
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      script += fmt::format("set label {} at {},{} left offset 0.7,{}\n",
                            gnuplot_text(sorted[i].setting),
                            gnuplot_number(sorted[i].time_ms),
                            gnuplot_number(sorted[i].rmse_levels),
                            i % 2 == 0 ? 0.7 : -0.7);
    }
    script += "plot $points using 1:2 with points pointtype 7 linecolor rgb '#0072B2'\n";
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
                          p.setting,
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
