// SPDX-License-Identifier: MIT
#include "frame/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "frame/lettering.h"

namespace polhode {
namespace {

// of what there is, at most
constexpr double kMostOfHeight = 0.15, kMostOfWidth = 0.055;
// of a plot's share of the height, at most, for type that is already smaller by this factor
constexpr double kCrowded = 0.178, kLess = 0.9;
constexpr double kHighest = 0.75;   // of a plot, of its width
constexpr double kPresent = 0.55;   // opacity of the line of the present
constexpr double kPlateRim = 0.12;  // around the ink of values, in units of the type

// the text as wide as it can be, for room that does not change
std::string all_zeros(std::string text) {
  for (char& c : text) {
    if (c >= '0' && c <= '9') c = '0';
  }
  return text;
}

// the least and the greatest value; 0 and 0 without values
std::pair<double, double> values_between(const FilmPlot& plot) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const PlotCurve& curve : plot.curves) {
    for (const double value : curve.values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return low <= high ? std::pair{low, high} : std::pair{0.0, 0.0};
}

// room above and below the values; a constant gets an axis that does not magnify round-off, and 0
// one of ordinary numbers
double room_beside(double low, double high, bool ratio) {
  const double size = std::max(std::abs(low), std::abs(high));
  if (size == 0.0 && !ratio) return 1.0;
  return std::max({0.08 * (high - low), ratio ? 1e-16 : 1e-3 * size, 1e-300});
}

// Appends the part of a line, which never goes to the left, from about one column to another, with
// its columns counted from `origin`.
void add_part(
    const Polyline& line, double from, double to, double origin, std::vector<Polyline>& parts) {
  Polyline part;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const LinePoint& point = line[k];
    if (k + 1 < line.size() && line[k + 1].x < from) continue;
    if (point.x <= to) {
      part.push_back({point.x - origin, point.y});
      continue;
    }
    if (!part.empty()) {
      const LinePoint& last = line[k - 1];
      const double share = (to - last.x) / (point.x - last.x);
      part.push_back({to - origin, last.y + share * (point.y - last.y)});
    }
    break;
  }
  if (!part.empty()) parts.push_back(std::move(part));
}

// "tilt of the axis, °"
std::string heading_of(const FilmPlot& plot, int exponent) {
  const std::string unit = scaled_unit(exponent, plot.unit);
  return unit.empty() ? plot.title : fmt::format("{}, {}", plot.title, unit);
}

// the type as large as `count` plots leave it in this room
double fitting_size(double wished, const PixelBox& room, std::size_t count) {
  const double share = room.height / static_cast<double>(count);
  const double high = std::max(kMostOfHeight * share, std::min(kLess * wished, kCrowded * share));
  return std::min({wished, high, kMostOfWidth * room.width});
}

}  // namespace

std::vector<double> heights_apart(const std::vector<double>& wished,
                                  double height,
                                  double top,
                                  double bottom) {
  // curves that lie on each other keep their order, whatever rounding errors do
  constexpr double kSame = 0.5;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < wished.size(); ++i) {
    auto before = order.end();
    while (before != order.begin() && wished[i] < wished[*(before - 1)] - kSame)
      --before;
    order.insert(before, i);
  }
  // piles of labels that touch, each in the middle of what its labels wish
  struct Pile {
    double sum = 0.0;  // of wishes, each less the heights of those above it in the pile
    std::size_t count = 0;
  };
  std::vector<Pile> piles;
  const auto top_of = [&](const Pile& pile) {
    const double highest = std::max(top, bottom - static_cast<double>(pile.count) * height);
    return std::clamp(pile.sum / static_cast<double>(pile.count), top, highest);
  };
  for (const std::size_t i : order) {
    piles.push_back({wished[i], 1});
    while (piles.size() > 1) {
      const Pile last = piles.back();
      Pile& before = piles[piles.size() - 2];
      const double above = static_cast<double>(before.count) * height;
      if (top_of(before) + above <= top_of(last)) break;
      before.sum += last.sum - static_cast<double>(last.count) * above;
      before.count += last.count;
      piles.pop_back();
    }
  }
  std::vector<double> heights(wished.size());
  std::size_t next = 0;
  for (const Pile& pile : piles) {
    for (std::size_t k = 0; k < pile.count; ++k)
      heights[order[next++]] = top_of(pile) + static_cast<double>(k) * height;
  }
  return heights;
}

// Long, because each length follows from those before it.
PlotStack::PlotStack(std::vector<FilmPlot> plots,
                     const PixelBox& room,
                     double size,
                     const Theme& theme,
                     const TimeUnit& unit,
                     const Typesetter& typesetter)
    : paper_(theme, typesetter, fitting_size(size, room, plots.size())) {
  const auto count = static_cast<double>(plots.size());
  const double type = paper_.size();
  const double pad = kPlotPad * type;
  const double left = room.x + pad;
  const double right = room.right() - pad;

  // heights: each plot the same, the times under the last one
  const double below = (kPlotColumns - kPlotUnder) * type;
  const double all = std::min(room.height - pad, count * kHighest * (right - left) + below);
  const double top = room.y + 0.5 * (room.height - all);
  const double each = (all - below) / count;

  // values decide how wide their labels are, and so where the axes begin and end
  const auto width = [&](const std::string& text) {
    return paper_.ink_width(text);
  };
  const auto height = [&](const std::string& text) {
    return paper_.ink_height(text);
  };
  double widest_label = 0.0;
  double widest_value = 0.0;
  for (FilmPlot& plot : plots) {
    Drawn one;
    one.plot = std::move(plot);
    const auto [least, most] = values_between(one.plot);
    const double beside = room_beside(least, most, one.plot.unit.empty());
    one.low = least - beside;
    one.high = most + beside;
    const double y = top + static_cast<double>(plots_.size()) * each;
    one.axes.y = static_cast<int>(std::lround(y + (kPlotHeading + kPlotOver) * type));
    one.axes.height =
        std::max(1, static_cast<int>(std::lround(y + each - kPlotUnder * type)) - one.axes.y);
    one.ticks = choose_ticks(one.low, one.high, one.axes.height, height, kPlotAbove * type);
    for (const std::string& label : one.ticks.labels)
      widest_label = std::max(widest_label, width(label));
    for (const double value : {least, most}) {
      const std::string text = all_zeros(value_text(one, value));
      one.value_width = std::max(one.value_width, paper_.measure(text).width);
    }
    widest_value = std::max(widest_value, one.value_width);
    const double around = 2.0 * kPlateRim * type;
    one.plate = std::make_shared<const Sprite>(
        filled_sprite(static_cast<int>(std::lround(one.value_width + around)),
                      static_cast<int>(std::lround(height("0") + around)),
                      bytes_of(theme.background),
                      1.0));
    plots_.push_back(std::move(one));
  }
  const double before = widest_label + (kPlotTick + kPlotTickGap) * type;
  const double behind = widest_value + (kPlotDot + 2.0 * kPlotTickGap) * type;
  const int first = static_cast<int>(std::lround(left + before));
  const int last = std::max(first + 1, static_cast<int>(std::lround(right - behind)));

  const FilmPlot& any = plots_.front().plot;
  const Ticks times = choose_ticks(
      any.begins / unit.seconds, any.ends / unit.seconds, last - first, width, kPlotAside * type);
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    Drawn& one = plots_[i];
    one.axes.x = first;
    one.axes.width = last - first;
    one.rim = static_cast<int>(std::ceil(paper_.line()));
    one.curves = curves_of(one);
    const int y = one.axes.y - static_cast<int>(std::lround((kPlotHeading + kPlotOver) * type));
    add_heading(one,
                {static_cast<int>(std::lround(left)),
                 y,
                 static_cast<int>(std::lround(right - left)),
                 static_cast<int>(std::lround(kPlotHeading * type))});
    add_axes(one, times, unit, i + 1 == plots_.size());
    one.sprite = draw_curves(one);
  }
  const int thin = paper_.thin();
  present_ = std::make_shared<const Sprite>(
      filled_sprite(thin, plots_.front().axes.height, bytes_of(paper_.theme().position), kPresent));
}

void PlotStack::add_heading(const Drawn& one, const PixelBox& row) {
  std::vector<PlotEntry> entries;
  for (std::size_t i = 0; i < one.plot.curves.size(); ++i) {
    // Euler angles of an upright axis, for one, have no value at any time
    if (one.curves[i].pieces.empty()) continue;
    entries.push_back({one.plot.curves[i].name, color(i), one.curves[i].dashes});
  }
  paper_.add_heading(heading_of(one.plot, one.ticks.exponent), entries, row);
}

void PlotStack::add_axes(const Drawn& one, const Ticks& times, const TimeUnit& unit, bool is_last) {
  paper_.add_rows(one.axes, one.ticks, [&](double value) { return row_of(one, value); });
  paper_.add_columns(
      one.axes,
      times,
      [&](double time) { return column_of(one, time * unit.seconds); },
      is_last ? "time, " + scaled_unit(times.exponent, unit.name) : "");
  paper_.add_axes(one.axes);
}

std::vector<Polyline> PlotStack::lines_of(const Drawn& one, std::size_t curve) const {
  const double left = one.axes.x - one.rim;
  const double top = one.axes.y - one.rim;
  const std::vector<double>& values = one.plot.curves[curve].values;
  const double step = (one.plot.ends - one.plot.begins) / static_cast<double>(values.size() - 1);
  std::vector<Polyline> lines;
  bool goes_on = false;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::isfinite(values[k])) {
      if (!goes_on) lines.emplace_back();
      const double t = one.plot.begins + static_cast<double>(k) * step;
      lines.back().push_back({column_of(one, t) - left, row_of(one, values[k]) - top});
    }
    goes_on = std::isfinite(values[k]);
  }
  return lines;
}

std::vector<PlotStack::Curve> PlotStack::curves_of(const Drawn& one) const {
  // dashes of a curve that goes up and down all the time would look like a scribble
  constexpr double kScribble = 2.5;  // widths of the plot
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < one.plot.curves.size(); ++i) {
    const std::vector<Polyline> lines = lines_of(one, i);
    double length = 0.0;
    for (const Polyline& line : lines) {
      for (std::size_t k = 1; k < line.size(); ++k)
        length += std::hypot(line[k].x - line[k - 1].x, line[k].y - line[k - 1].y);
    }
    Curve curve;
    if (length <= kScribble * one.axes.width) curve.dashes = dashes(i);
    for (const Polyline& line : lines) {
      for (Polyline& dash : dashes_of(line, curve.dashes))
        curve.pieces.push_back(std::move(dash));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

Stamp PlotStack::draw_curves(const Drawn& one) const {
  Sprite sprite(one.axes.width + 2 * one.rim, one.axes.height + 2 * one.rim);
  for (std::size_t i = 0; i < one.curves.size(); ++i)
    stroke(sprite, one.curves[i].pieces, paper_.line(), bytes_of(color(i)));
  return {std::make_shared<const Sprite>(std::move(sprite)),
          one.axes.x - one.rim,
          one.axes.y - one.rim};
}

void PlotStack::add_curves(const Drawn& one, double column, std::vector<Stamp>& stamps) const {
  // in the last columns the sprite shows the width of what comes later, in steep curves far off
  const double end = column - one.sprite.x;
  const double reach = 0.5 * paper_.line() + 1.0;
  const int cut = std::max(0, static_cast<int>(std::floor(end - reach)));
  Stamp whole = one.sprite;
  whole.columns = cut;
  stamps.push_back(whole);
  Sprite last(static_cast<int>(std::ceil(end + reach)) - cut, one.sprite.sprite->height);
  for (std::size_t i = 0; i < one.curves.size(); ++i) {
    std::vector<Polyline> parts;
    for (const Polyline& piece : one.curves[i].pieces)
      add_part(piece, cut - reach, end, cut, parts);
    stroke(last, parts, paper_.line(), bytes_of(color(i)));
  }
  stamps.push_back(
      {std::make_shared<const Sprite>(std::move(last)), one.sprite.x + cut, one.sprite.y});
}

std::string PlotStack::value_text(const Drawn& one, double value) const {
  return number_text(value, one.ticks.exponent, one.ticks.decimals + 1);
}

// with round ends, which are as long as the line is wide
std::vector<double> PlotStack::dashes(std::size_t curve) const {
  const auto pattern = [&](double drawn, double free) {
    return std::vector<double>{drawn * paper_.size() - paper_.line(),
                               free * paper_.size() + paper_.line()};
  };
  // no two of six (the most that a plot holds) are alike, whatever their colours
  switch (curve) {
    case 1:
      return pattern(1.1, 0.35);
    case 2:
      return pattern(0.45, 0.3);
    case 3:
      return pattern(2.2, 0.35);
    case 4:
      return pattern(0.2, 0.25);
    case 5:
      return pattern(1.1, 1.0);
    default:
      return {};
  }
}

glm::vec3 PlotStack::color(std::size_t curve) const {
  const Theme& theme = paper_.theme();
  const std::array<glm::vec3, 6> colors = {
      theme.omega, theme.momentum, theme.body_axes, theme.force, theme.velocity, theme.position};
  return colors[curve % colors.size()];
}

double PlotStack::column_of(const Drawn& one, double t) const {
  const double part =
      std::clamp((t - one.plot.begins) / (one.plot.ends - one.plot.begins), 0.0, 1.0);
  return one.axes.x + part * one.axes.width;
}

double PlotStack::row_of(const Drawn& one, double value) const {
  const double part = std::clamp((value - one.low) / (one.high - one.low), 0.0, 1.0);
  return one.axes.bottom() - part * one.axes.height;
}

std::vector<PlotStack::Value> PlotStack::values_of(const Drawn& one, double t) const {
  const std::vector<double> now = one.plot.now(std::clamp(t, one.plot.begins, one.plot.ends));
  const double column = column_of(one, t);
  std::vector<Value> list;
  std::vector<double> wished;
  double height = 0.0;
  for (std::size_t i = 0; i < now.size() && i < one.plot.curves.size(); ++i) {
    if (!std::isfinite(now[i])) continue;
    Value value;
    value.curve = i;
    value.dot = {column, row_of(one, now[i])};
    value.text = value_text(one, now[i]);
    value.box = paper_.measure(value.text);
    // digits keep their places whatever the sign
    value.x = column + (kPlotDot + kPlotTickGap) * paper_.size() +
              std::max(0.0, one.value_width - value.box.width);
    height = std::max(height, value.box.ink_height() + 0.25 * paper_.size());
    wished.push_back(value.dot.y);
    list.push_back(std::move(value));
  }
  // as high as there is room, which in a low plot is less than all of them
  height = std::min(height, one.axes.height / std::max(1.0, static_cast<double>(list.size())));
  for (double& y : wished)
    y -= 0.5 * height;
  const std::vector<double> apart = heights_apart(wished, height, one.axes.y, one.axes.bottom());
  for (std::size_t k = 0; k < list.size(); ++k) {
    const TextBox& box = list[k].box;
    list[k].y = apart[k] + 0.5 * height - 0.5 * (box.ink_top + box.ink_bottom);
  }
  return list;
}

Stamp PlotStack::plate_of(const Drawn& one, const Value& value) const {
  const double around = kPlateRim * paper_.size();
  const double right = value.x + value.box.width;
  return {one.plate,
          static_cast<int>(std::lround(right + around - one.plate->width)),
          static_cast<int>(std::lround(value.y + value.box.ink_top - around))};
}

void PlotStack::draw(double t, std::vector<Stamp>& stamps) const {
  stamps.insert(stamps.end(), paper_.stamps().begin(), paper_.stamps().end());
  for (const Drawn& one : plots_) {
    const double column = column_of(one, t);
    add_curves(one, column, stamps);
    stamps.push_back(
        {present_, static_cast<int>(std::lround(column - 0.5 * present_->width)), one.axes.y});
    const std::vector<Value> values = values_of(one, t);
    for (const Value& value : values)
      stamps.push_back(paper_.dot(value.dot, color(value.curve)));
    // values stand on the lines of ticks, which would be read as strokes of digits
    for (const Value& value : values)
      stamps.push_back(plate_of(one, value));
    for (const Value& value : values) {
      stamps.push_back(paper_.text(value.text, paper_.style(color(value.curve)), value.x, value.y));
    }
  }
}

std::vector<PixelBox> PlotStack::axes() const {
  std::vector<PixelBox> list;
  for (const Drawn& one : plots_)
    list.push_back(one.axes);
  return list;
}

std::vector<PlacedText> PlotStack::values(double t) const {
  std::vector<PlacedText> list;
  for (const Drawn& one : plots_) {
    for (const Value& value : values_of(one, t)) {
      list.push_back({TextRole::plot,
                      plain_text(value.text),
                      paper_.style(color(value.curve)),
                      ink_of(value.box, value.x, value.y)});
    }
  }
  return list;
}

std::vector<PlacedText> PlotStack::texts(double t) const {
  std::vector<PlacedText> list = paper_.texts();
  for (PlacedText& value : values(t))
    list.push_back(std::move(value));
  return list;
}

}  // namespace polhode
