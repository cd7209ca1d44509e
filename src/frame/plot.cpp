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

// lengths in units of the type
constexpr double kPad = 0.5;      // free at the sides of all plots
constexpr double kHeading = 1.6;  // height of a heading
constexpr double kOver = 0.35;    // between heading and axes
constexpr double kUnder = 0.65;   // below axes that have no times
constexpr double kTimes = 2.9;    // below the last ones
constexpr double kTick = 0.22;    // length of a tick
constexpr double kTickGap = 0.2;  // between a tick and its label
constexpr double kAside = 0.9;    // free between labels of times
constexpr double kAbove = 0.45;   // free between labels of values
constexpr double kCurve = 0.125;  // width of curves
constexpr double kThin = 0.05;    // width of axes
constexpr double kDot = 0.24;     // radius
constexpr double kBetween = 0.8;  // names of curves
constexpr double kSample = 1.6;   // width of a curve's sample, below its name
// of what there is, at most
constexpr double kMostOfHeight = 0.15, kMostOfWidth = 0.055;
// of a plot's share of the height, at most, for type that is already smaller by this factor
constexpr double kCrowded = 0.178, kLess = 0.9;
constexpr double kHighest = 0.75;                             // of a plot, of its width
constexpr double kGrid = 0.22, kAxis = 0.9, kPresent = 0.55;  // opacities

TextRoom ink_of(const TextBox& box, double x, double y) {
  return {x + box.ink_left, y + box.ink_top, x + box.ink_right, y + box.ink_bottom};
}

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

// room above and below the values; a constant gets an axis that does not magnify round-off
double room_beside(double low, double high, bool ratio) {
  const double size = std::max(std::abs(low), std::abs(high));
  return std::max({0.08 * (high - low), ratio ? 1e-16 : 1e-3 * size, 1e-300});
}

// "tilt of the axis, °"
std::string heading_of(const FilmPlot& plot, int exponent) {
  const std::string unit = scaled_unit(exponent, plot.unit);
  return unit.empty() ? plot.title : fmt::format("{}, {}", plot.title, unit);
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
    : theme_(theme), typesetter_(typesetter) {
  const auto count = static_cast<double>(plots.size());
  const double share = room.height / count;
  const double high = std::max(kMostOfHeight * share, std::min(kLess * size, kCrowded * share));
  size_ = std::min({size, high, kMostOfWidth * room.width});
  line_ = std::max(1.0, kCurve * size_);
  const double pad = kPad * size_;
  const double left = room.x + pad;
  const double right = room.right() - pad;

  // heights: each plot the same, the times under the last one
  const double below = (kTimes - kUnder) * size_;
  const double all = std::min(room.height - pad, count * kHighest * (right - left) + below);
  const double top = room.y + 0.5 * (room.height - all);
  const double each = (all - below) / count;

  // values decide how wide their labels are, and so where the axes begin and end
  const TextStyle plain = style_of(theme_, size_, theme_.position);
  const auto width = [&](const std::string& text) {
    return typesetter_.measure(plain_text(text), plain).ink_width();
  };
  const auto height = [&](const std::string& text) {
    return typesetter_.measure(plain_text(text), plain).ink_height();
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
    one.axes.y = static_cast<int>(std::lround(y + (kHeading + kOver) * size_));
    one.axes.height =
        std::max(1, static_cast<int>(std::lround(y + each - kUnder * size_)) - one.axes.y);
    one.ticks = choose_ticks(one.low, one.high, one.axes.height, height, kAbove * size_);
    for (const std::string& label : one.ticks.labels)
      widest_label = std::max(widest_label, width(label));
    for (const double value : {least, most}) {
      const std::string text = plain_text(all_zeros(value_text(one, value)));
      one.value_width = std::max(one.value_width, typesetter_.measure(text, plain).width);
    }
    widest_value = std::max(widest_value, one.value_width);
    plots_.push_back(std::move(one));
  }
  const double before = widest_label + (kTick + kTickGap) * size_;
  const double behind = widest_value + (kDot + 2.0 * kTickGap) * size_;
  const int first = static_cast<int>(std::lround(left + before));
  const int last = std::max(first + 1, static_cast<int>(std::lround(right - behind)));

  const FilmPlot& any = plots_.front().plot;
  const Ticks times = choose_ticks(
      any.begins / unit.seconds, any.ends / unit.seconds, last - first, width, kAside * size_);
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    Drawn& one = plots_[i];
    one.axes.x = first;
    one.axes.width = last - first;
    const int y = one.axes.y - static_cast<int>(std::lround((kHeading + kOver) * size_));
    add_heading(one,
                {static_cast<int>(std::lround(left)),
                 y,
                 static_cast<int>(std::lround(right - left)),
                 static_cast<int>(std::lround(kHeading * size_))});
    add_axes(one, times, unit, i + 1 == plots_.size());
    one.rim = static_cast<int>(std::ceil(line_));
    one.curves = draw_curves(one);
  }
  const int thin = std::max(1, static_cast<int>(std::lround(kThin * size_)));
  present_ = std::make_shared<const Sprite>(
      filled_sprite(thin, plots_.front().axes.height, bytes_of(theme_.position), kPresent));
}

void PlotStack::add_text(const std::string& text, const TextStyle& style, double x, double y) {
  const std::string markup = plain_text(text);
  fixed_.push_back(typesetter_.set(markup, style, x, y));
  fixed_text_.push_back(
      {TextRole::plot, markup, style, ink_of(typesetter_.measure(markup, style), x, y)});
}

void PlotStack::add_line(const PixelBox& box, double opacity) {
  fixed_.push_back({std::make_shared<const Sprite>(
                        filled_sprite(box.width, box.height, bytes_of(theme_.space_axes), opacity)),
                    box.x,
                    box.y});
}

// the title on the left and the curves' names on the right, each above a piece of its curve
void PlotStack::add_heading(const Drawn& one, const PixelBox& row) {
  const std::string title = heading_of(one.plot, one.ticks.exponent);
  TextStyle style = style_of(theme_, size_, theme_.position);
  const auto width = [&](const std::string& text) {
    return typesetter_.measure(plain_text(text), style).width;
  };
  const auto entry = [&](const PlotCurve& curve) {
    return std::max(width(curve.name), kSample * style.size);
  };
  const auto all = [&] {
    double sum = width(title);
    for (const PlotCurve& curve : one.plot.curves)
      sum += kBetween * style.size + entry(curve);
    return sum;
  };
  const double shrink = std::min(1.0, row.width / all());
  style.size *= shrink;
  style.halo *= shrink;

  const double y = row.y + 0.5 * (row.height - typesetter_.measure("x", style).height);
  add_text(title, style, row.x, y);
  double x = row.right();
  for (std::size_t i = one.plot.curves.size(); i-- > 0;) {
    const PlotCurve& curve = one.plot.curves[i];
    const double room = entry(curve);
    x -= room;
    style.color = bytes_of(color(i));
    add_text(curve.name, style, x + 0.5 * (room - width(curve.name)), y);
    // a piece of the curve
    Sprite sample(static_cast<int>(std::ceil(room)), static_cast<int>(std::ceil(line_)) + 2);
    const double middle = 0.5 * sample.height;
    const std::vector<double> pattern = dashes(i);
    Polyline line{{0.5 * line_, middle}, {room - 0.5 * line_, middle}};
    if (!pattern.empty()) {
      // a gap in the middle, and no end
      const double period = pattern[0] + pattern[1];
      const double first = 0.5 * room - pattern[0] - 0.5 * pattern[1];
      line = {{first - std::ceil(room / period) * period, middle}, {2.0 * room, middle}};
    }
    stroke(sample, dashes_of(line, pattern), line_, style.color);
    fixed_.push_back({std::make_shared<const Sprite>(std::move(sample)),
                      static_cast<int>(std::lround(x)),
                      static_cast<int>(std::lround(row.bottom() - 0.1 * size_))});
    x -= kBetween * style.size;
  }
}

void PlotStack::add_axes(const Drawn& one, const Ticks& times, const TimeUnit& unit, bool is_last) {
  const PixelBox& axes = one.axes;
  const int thin = std::max(1, static_cast<int>(std::lround(kThin * size_)));
  const int tick = static_cast<int>(std::lround(kTick * size_));
  const TextStyle style = style_of(theme_, size_, theme_.position);
  for (std::size_t i = 0; i < one.ticks.values.size(); ++i) {
    const double at = row_of(one, one.ticks.values[i]);
    const int y = static_cast<int>(std::lround(at - 0.5 * thin));
    add_line({axes.x, y, axes.width, thin}, kGrid);
    add_line({axes.x - tick, y, tick, thin}, kAxis);
    const TextBox box = typesetter_.measure(plain_text(one.ticks.labels[i]), style);
    add_text(one.ticks.labels[i],
             style,
             axes.x - (kTick + kTickGap) * size_ - box.ink_right,
             at - 0.5 * (box.ink_top + box.ink_bottom));
  }
  for (std::size_t i = 0; i < times.values.size(); ++i) {
    const double at = column_of(one, times.values[i] * unit.seconds);
    const int x = static_cast<int>(std::lround(at - 0.5 * thin));
    add_line({x, axes.y, thin, axes.height}, kGrid);
    add_line({x, axes.bottom(), thin, tick}, kAxis);
    if (!is_last) continue;
    const TextBox box = typesetter_.measure(plain_text(times.labels[i]), style);
    add_text(times.labels[i],
             style,
             at - 0.5 * (box.ink_left + box.ink_right),
             axes.bottom() + (kTick + kTickGap) * size_ - box.ink_top);
  }
  add_line({axes.x - thin, axes.y, thin, axes.height + thin}, kAxis);
  add_line({axes.x, axes.bottom(), axes.width, thin}, kAxis);
  if (!is_last) return;
  const std::string name = "time, " + scaled_unit(times.exponent, unit.name);
  const TextBox box = typesetter_.measure(plain_text(name), style);
  add_text(name,
           style,
           axes.x + 0.5 * (axes.width - box.width),
           axes.bottom() + (kTimes - 1.35) * size_);
}

Stamp PlotStack::draw_curves(const Drawn& one) const {
  Sprite sprite(one.axes.width + 2 * one.rim, one.axes.height + 2 * one.rim);
  const double left = one.axes.x - one.rim;
  const double top = one.axes.y - one.rim;
  for (std::size_t i = 0; i < one.plot.curves.size(); ++i) {
    const std::vector<double>& values = one.plot.curves[i].values;
    const double step = (one.plot.ends - one.plot.begins) / static_cast<double>(values.size() - 1);
    std::vector<Polyline> lines;
    Polyline line;
    for (std::size_t k = 0; k <= values.size(); ++k) {
      if (k < values.size() && std::isfinite(values[k])) {
        const double t = one.plot.begins + static_cast<double>(k) * step;
        line.push_back({column_of(one, t) - left, row_of(one, values[k]) - top});
        continue;
      }
      // the curve ends, or is not defined here
      if (line.empty()) continue;
      for (Polyline& dash : dashes_of(line, dashes(i)))
        lines.push_back(std::move(dash));
      line.clear();
    }
    stroke(sprite, lines, line_, bytes_of(color(i)));
  }
  return {std::make_shared<const Sprite>(std::move(sprite)),
          static_cast<int>(left),
          static_cast<int>(top)};
}

std::string PlotStack::value_text(const Drawn& one, double value) const {
  return number_text(value, one.ticks.exponent, one.ticks.decimals + 1);
}

// with round ends, which are as long as the line is wide
std::vector<double> PlotStack::dashes(std::size_t curve) const {
  const auto pattern = [&](double drawn, double free) {
    return std::vector<double>{drawn * size_ - line_, free * size_ + line_};
  };
  if (curve == 1) return pattern(1.1, 0.35);
  if (curve == 2) return pattern(0.45, 0.3);
  return {};
}

glm::vec3 PlotStack::color(std::size_t curve) const {
  const std::array<glm::vec3, 3> colors = {theme_.omega, theme_.momentum, theme_.body_axes};
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
    value.box = typesetter_.measure(plain_text(value.text), style_of(theme_, size_, color(i)));
    // digits keep their places whatever the sign
    value.x = column + (kDot + kTickGap) * size_ + std::max(0.0, one.value_width - value.box.width);
    height = std::max(height, value.box.ink_height() + 0.25 * size_);
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

void PlotStack::draw(double t, std::vector<Stamp>& stamps) const {
  stamps.insert(stamps.end(), fixed_.begin(), fixed_.end());
  for (const Drawn& one : plots_) {
    Stamp curves = one.curves;
    const double column = column_of(one, t);
    curves.columns = static_cast<int>(std::lround(column)) - curves.x;
    stamps.push_back(curves);
    stamps.push_back(
        {present_, static_cast<int>(std::lround(column - 0.5 * present_->width)), one.axes.y});
    const std::vector<Value> values = values_of(one, t);
    for (const Value& value : values) {
      const double radius = kDot * size_ + line_;  // with a rim
      const int left = static_cast<int>(std::floor(value.dot.x - radius - 1.0));
      const int top = static_cast<int>(std::floor(value.dot.y - radius - 1.0));
      const int side = static_cast<int>(std::ceil(2.0 * radius)) + 4;
      Sprite dot(side, side);
      const std::vector<Polyline> place{{{value.dot.x - left, value.dot.y - top}}};
      stroke(dot, place, 2.0 * kDot * size_ + line_, bytes_of(theme_.background));
      stroke(dot, place, 2.0 * kDot * size_, bytes_of(color(value.curve)));
      stamps.push_back({std::make_shared<const Sprite>(std::move(dot)), left, top});
    }
    for (const Value& value : values) {
      stamps.push_back(typesetter_.set(
          plain_text(value.text), style_of(theme_, size_, color(value.curve)), value.x, value.y));
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
                      style_of(theme_, size_, color(value.curve)),
                      ink_of(value.box, value.x, value.y)});
    }
  }
  return list;
}

std::vector<PlacedText> PlotStack::texts(double t) const {
  std::vector<PlacedText> list = fixed_text_;
  for (PlacedText& value : values(t))
    list.push_back(std::move(value));
  return list;
}

}  // namespace polhode
