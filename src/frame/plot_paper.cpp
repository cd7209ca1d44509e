// SPDX-License-Identifier: MIT
#include "frame/plot_paper.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/utf8.h"
#include "frame/lettering.h"

namespace polhode {
namespace {

// lengths in units of the type
constexpr double kCurve = 0.125;             // width of curves
constexpr double kThin = 0.05;               // width of axes
constexpr double kBetween = 0.8;             // names of curves
constexpr double kSample = 1.6;              // width of a curve's sample, below its name
constexpr double kSmallestHeading = 0.5;     // of type in a heading, rather than a whole name
constexpr std::size_t kLeastBytes = 20;      // of a name that is shortened
constexpr double kGrid = 0.22, kAxis = 0.9;  // opacities

// the name of a curve, as markup
std::string markup_of(const std::string& name) {
  for (const char* component : {"Ωx", "Ωy", "Ωz", "Lx", "Ly", "Lz"}) {
    const std::string_view vector_and_axis = component;
    if (!name.starts_with(vector_and_axis)) continue;
    const std::size_t axis = vector_and_axis.size() - 1;
    return fmt::format("{}<sub>{}</sub>{}",
                       vector_and_axis.substr(0, axis),
                       vector_and_axis.substr(axis),
                       plain_text(name.substr(axis + 1)));
  }
  return plain_text(name);
}

// A name of more than `most` bytes with dots in place of its middle: what tells names apart is at
// their ends.
std::string shortened(const std::string& name, std::size_t most) {
  if (name.size() <= most) return name;
  std::size_t head = most / 2, tail = name.size() - most / 2;
  while (is_continuation(name, head))
    --head;
  while (is_continuation(name, tail))
    ++tail;
  return name.substr(0, head) + "…" + name.substr(tail);
}

}  // namespace

TextRoom ink_of(const TextBox& box, double x, double y) {
  return {x + box.ink_left, y + box.ink_top, x + box.ink_right, y + box.ink_bottom};
}

PlotPaper::PlotPaper(const Theme& theme, const Typesetter& typesetter, double size)
    : theme_(theme), typesetter_(typesetter), size_(size), line_(std::max(1.0, kCurve * size)) {}

int PlotPaper::thin() const {
  return std::max(1, static_cast<int>(std::lround(kThin * size_)));
}

TextStyle PlotPaper::style(const glm::vec3& color) const {
  return style_of(theme_, size_, readable(color, theme_.background));
}

TextBox PlotPaper::measure(const std::string& text) const {
  return typesetter_.measure(plain_text(text), style(theme_.position));
}

Stamp PlotPaper::text(const std::string& text, const TextStyle& style, double x, double y) const {
  return typesetter_.set(plain_text(text), style, x, y);
}

void PlotPaper::add_text(const std::string& text, const TextStyle& style, double x, double y) {
  add_markup(plain_text(text), style, x, y);
}

void PlotPaper::add_markup(const std::string& markup, const TextStyle& style, double x, double y) {
  stamps_.push_back(typesetter_.set(markup, style, x, y));
  texts_.push_back(
      {TextRole::plot, markup, style, ink_of(typesetter_.measure(markup, style), x, y)});
}

void PlotPaper::add_line(const PixelBox& box, double opacity) {
  stamps_.push_back({std::make_shared<const Sprite>(filled_sprite(
                         box.width, box.height, bytes_of(theme_.space_axes), opacity)),
                     box.x,
                     box.y});
}

// each entry above a piece of its curve
void PlotPaper::add_heading(const std::string& title,
                            std::vector<PlotEntry> entries,
                            const PixelBox& row) {
  TextStyle style = this->style(theme_.position);
  const auto width = [&](const std::string& markup) {
    return typesetter_.measure(markup, style).width;
  };
  const auto room_of = [&](const PlotEntry& entry) {
    return std::max(width(markup_of(entry.name)), kSample * style.size);
  };
  const auto width_of_all = [&] {
    double all = width(plain_text(title));
    for (const PlotEntry& entry : entries)
      all += kBetween * style.size + room_of(entry);
    return all;
  };
  const std::vector<PlotEntry> whole = entries;
  std::size_t most = kLeastBytes;
  for (const PlotEntry& entry : whole)
    most = std::max(most, entry.name.size());
  while (most > kLeastBytes && width_of_all() * kSmallestHeading > row.width) {
    --most;
    for (std::size_t i = 0; i < entries.size(); ++i)
      entries[i].name = shortened(whole[i].name, most);
  }
  const double shrink = std::min(1.0, row.width / width_of_all());
  style.size *= shrink;
  style.halo *= shrink;

  const double y = row.y + 0.5 * (row.height - typesetter_.measure("x", style).height);
  add_text(title, style, row.x, y);
  double x = row.right();
  for (std::size_t i = entries.size(); i-- > 0;) {
    const PlotEntry& entry = entries[i];
    const double room = room_of(entry);
    x -= room;
    style.color = this->style(entry.color).color;
    const std::string name = markup_of(entry.name);
    add_markup(name, style, x + 0.5 * (room - width(name)), y);
    // a piece of the curve
    Sprite sample(static_cast<int>(std::ceil(room)), static_cast<int>(std::ceil(line_)) + 2);
    const double middle = 0.5 * sample.height;
    const std::vector<double>& pattern = entry.dashes;
    Polyline line{{0.5 * line_, middle}, {room - 0.5 * line_, middle}};
    if (!pattern.empty()) {
      // a gap in the middle, and no end
      const double period = pattern[0] + pattern[1];
      const double first = 0.5 * room - pattern[0] - 0.5 * pattern[1];
      line = {{first - std::ceil(room / period) * period, middle}, {2.0 * room, middle}};
    }
    stroke(sample, dashes_of(line, pattern), line_, bytes_of(entry.color));
    stamps_.push_back({std::make_shared<const Sprite>(std::move(sample)),
                       static_cast<int>(std::lround(x)),
                       static_cast<int>(std::lround(row.bottom() - 0.1 * size_))});
    x -= kBetween * style.size;
  }
}

void PlotPaper::add_rows(const PixelBox& axes,
                         const Ticks& ticks,
                         const std::function<double(double)>& row_of) {
  const int tick = static_cast<int>(std::lround(kPlotTick * size_));
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const double at = row_of(ticks.values[i]);
    const int y = static_cast<int>(std::lround(at - 0.5 * thin()));
    add_line({axes.x, y, axes.width, thin()}, kGrid);
    add_line({axes.x - tick, y, tick, thin()}, kAxis);
    const TextBox box = measure(ticks.labels[i]);
    add_text(ticks.labels[i],
             style(theme_.position),
             axes.x - (kPlotTick + kPlotTickGap) * size_ - box.ink_right,
             at - 0.5 * (box.ink_top + box.ink_bottom));
  }
}

void PlotPaper::add_columns(const PixelBox& axes,
                            const Ticks& ticks,
                            const std::function<double(double)>& column_of,
                            const std::string& name) {
  const int tick = static_cast<int>(std::lround(kPlotTick * size_));
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const double at = column_of(ticks.values[i]);
    const int x = static_cast<int>(std::lround(at - 0.5 * thin()));
    add_line({x, axes.y, thin(), axes.height}, kGrid);
    add_line({x, axes.bottom(), thin(), tick}, kAxis);
    if (name.empty()) continue;
    const TextBox box = measure(ticks.labels[i]);
    add_text(ticks.labels[i],
             style(theme_.position),
             at - 0.5 * (box.ink_left + box.ink_right),
             axes.bottom() + (kPlotTick + kPlotColumnGap) * size_ - box.ink_top);
  }
  if (name.empty()) return;
  add_text(name,
           style(theme_.position),
           axes.x + 0.5 * (axes.width - measure(name).width),
           axes.bottom() + (kPlotColumns - 1.35) * size_);
}

void PlotPaper::add_axes(const PixelBox& axes) {
  add_line({axes.x - thin(), axes.y, thin(), axes.height + thin()}, kAxis);
  add_line({axes.x, axes.bottom(), axes.width, thin()}, kAxis);
}

Stamp PlotPaper::dot(const LinePoint& at, const glm::vec3& color) const {
  const double radius = kPlotDot * size_ + line_;  // with a rim
  const int left = static_cast<int>(std::floor(at.x - radius - 1.0));
  const int top = static_cast<int>(std::floor(at.y - radius - 1.0));
  const int side = static_cast<int>(std::ceil(2.0 * radius)) + 4;
  Sprite disc(side, side);
  const std::vector<Polyline> place{{{at.x - left, at.y - top}}};
  stroke(disc, place, 2.0 * kPlotDot * size_ + line_, bytes_of(theme_.background));
  stroke(disc, place, 2.0 * kPlotDot * size_, bytes_of(color));
  return {std::make_shared<const Sprite>(std::move(disc)), left, top};
}

}  // namespace polhode
