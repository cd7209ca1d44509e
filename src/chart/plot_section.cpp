// SPDX-License-Identifier: MIT
#include "chart/plot_section.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"

namespace polhode {
namespace {

constexpr int kSectionWidth = 1000, kSectionHeight = 700;

// neighbours in the list are told apart; grey and orange have a meaning of their own
constexpr std::array<const char*, 8> kOrbitColors = {
    "#0072B2", "#009E73", "#CC79A7", "#56B4E9", "#5D3A9B", "#1B7837", "#8C2D04", "#2166AC"};

std::string look_of(const SectionOrbit& orbit, std::size_t index) {
  if (index == 0) return "pointtype 7 pointsize 0.35 linecolor rgb '#E69F00'";
  const char* color = kOrbitColors[index % kOrbitColors.size()];
  if (orbit.verdict == SectionVerdict::chaotic) color = "#A0A0A0";
  if (orbit.verdict == SectionVerdict::undecided) color = "#000000";
  return fmt::format("pointtype 7 pointsize 0.2 linecolor rgb '{}'", color);
}

// Of points that fall on one pixel of the picture, one: gnuplot takes 0.1 ms for each. least, most:
// of the axes.
std::vector<Vec2> one_on_each_pixel(const std::vector<Vec2>& points,
                                    const Vec2& least,
                                    const Vec2& most) {
  const Vec2 pixel = (most - least).cwiseQuotient(Vec2(kSectionWidth, kSectionHeight));
  std::set<std::pair<int, int>> taken;
  std::vector<Vec2> kept;
  for (const Vec2& point : points) {
    const Vec2 at = (point - least).cwiseQuotient(pixel.cwiseMax(1e-300));
    if (taken.emplace(static_cast<int>(at.x()), static_cast<int>(at.y())).second)
      kept.push_back(point);
  }
  return kept;
}

// as they are, if there are few
std::vector<std::vector<Vec2>> drawn_points(const SectionChart& chart) {
  constexpr std::size_t kFew = 100'000;
  std::vector<std::vector<Vec2>> all;
  Vec2 least = Vec2::Constant(std::numeric_limits<double>::infinity()), most = -least;
  std::size_t count = 0;
  for (const SectionOrbit& orbit : chart.orbits) {
    count += orbit.points.size();
    for (const Vec2& point : orbit.points) {
      least = least.cwiseMin(point);
      most = most.cwiseMax(point);
    }
    all.push_back(orbit.points);
  }
  if (count <= kFew) return all;
  for (std::vector<Vec2>& points : all)
    points = one_on_each_pixel(points, least, most);
  return all;
}

}  // namespace

std::vector<std::vector<Vec2>> borders_of(const SectionSurface& surface) {
  constexpr int kPieces = 2000;
  std::vector<std::vector<Vec2>> borders;
  std::vector<Vec2> border, back;
  const auto close = [&] {
    if (border.empty()) return;
    border.insert(border.end(), back.rbegin(), back.rend());
    border.push_back(border.front());
    borders.push_back(std::move(border));
    border.clear();
    back.clear();
  };
  for (int i = 0; i <= kPieces; ++i) {
    const double theta = kPi * i / kPieces;
    const std::optional<SectionSurface::Allowed> allowed = surface.allowed_at(theta);
    if (!allowed) {
      close();
      continue;
    }
    border.emplace_back(theta, allowed->greatest);
    back.emplace_back(theta, allowed->least);
  }
  close();
  return borders;
}

std::string plot_section(const SectionChart& chart, PlotFormat format) {
  std::string script = fmt::format(
      "set title {}\n"
      "set xlabel 'tilt, °'\n"
      "set ylabel 'momentum of the tilt, kg m²/s'\n"
      "set key outside right top vertical Left reverse noenhanced\n$border << EOD\n",
      gnuplot_text(chart.title));
  const double degree = 1.0 / kDegree;
  for (const std::vector<Vec2>& border : chart.borders) {
    for (const Vec2& point : border) {
      script +=
          fmt::format("{} {}\n", gnuplot_number(degree * point.x()), gnuplot_number(point.y()));
    }
    script += "\n";
  }
  script += "EOD\n";
  // where the energy hardly allows anything but the start there may be nothing to draw
  const std::vector<std::vector<Vec2>> drawn = drawn_points(chart);
  const bool any_point = std::any_of(
      drawn.begin(), drawn.end(), [](const std::vector<Vec2>& points) { return !points.empty(); });
  if (chart.borders.empty() && !any_point) script += "set xrange [0:180]\nset yrange [-1:1]\n";
  std::string plots =
      "plot $border using 1:2 with lines linewidth 1 linecolor rgb '#C0C0C0' notitle";
  // chaos first, so that it covers nothing
  for (const bool chaotic : {true, false}) {
    for (std::size_t i = chart.orbits.size(); i-- > 0;) {
      const SectionOrbit& orbit = chart.orbits[i];
      if (orbit.points.empty() || (orbit.verdict == SectionVerdict::chaotic && i > 0) != chaotic)
        continue;
      script += fmt::format("$orbit{} << EOD\n", i);
      for (const Vec2& point : drawn[i])
        script += fmt::format("{:.8g} {:.8g}\n", degree * point.x(), point.y());
      script += "EOD\n";
      plots += fmt::format(", $orbit{} using 1:2 with points {} notitle", i, look_of(orbit, i));
    }
  }
  plots +=
      ", NaN with points pointtype 7 linecolor rgb '#E69F00' title 'the scene'"
      ", NaN with points pointtype 7 linecolor rgb '#0072B2' title 'regular, in colours'"
      ", NaN with points pointtype 7 linecolor rgb '#A0A0A0' title 'chaotic'"
      ", NaN with points pointtype 7 linecolor rgb '#000000' title 'undecided'";
  return draw_with_gnuplot(script + plots + "\n", format, kSectionWidth, kSectionHeight);
}

std::string section_csv(const SectionChart& chart) {
  std::string text = "orbit,verdict,exponent_per_s,tilt_rad,momentum_kg_m2_per_s\n";
  for (std::size_t i = 0; i < chart.orbits.size(); ++i) {
    const SectionOrbit& orbit = chart.orbits[i];
    for (const Vec2& point : orbit.points) {
      fmt::format_to(std::back_inserter(text),
                     "{},{},{:.17g},{:.17g},{:.17g}\n",
                     i,
                     name_of(orbit.verdict),
                     orbit.exponent() + 0.0,
                     point.x(),
                     point.y() + 0.0);
    }
  }
  return text;
}

}  // namespace polhode
