// SPDX-License-Identifier: MIT
// What plots and diagrams are drawn on: headings, axes, ticks and dots in one size of type.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frame/placed_text.h"
#include "frame/theme.h"
#include "frame/ticks.h"
#include "image/pixel_box.h"
#include "image/sprite.h"
#include "image/stroke.h"
#include "text/typesetter.h"

namespace polhode {

// The name of a curve in a heading, with a piece of it.
struct PlotEntry {
  std::string name;                 // plain text; the axis of a component, as in Ωx, is set lower
  glm::vec3 color;                  // sRGB-encoded, 0..1
  std::vector<double> dashes = {};  // px: pattern for dashes_of() (image/stroke.h)
};

// Collects the stamps of plots that keep their place. Lengths are in pixels of the frame; texts are
// plain.
class PlotPaper {
 public:
  // size: of the type. The typesetter must outlive the paper.
  PlotPaper(const Theme& theme, const Typesetter& typesetter, double size);

  double size() const { return size_; }
  // width of curves
  double line() const { return line_; }
  // width of axes
  int thin() const;
  const Theme& theme() const { return theme_; }
  TextStyle style(const glm::vec3& color) const;
  // of text in the colour of the axes
  TextBox measure(const std::string& text) const;
  double ink_width(const std::string& text) const { return measure(text).ink_width(); }
  double ink_height(const std::string& text) const { return measure(text).ink_height(); }

  void add_text(const std::string& text, const TextStyle& style, double x, double y);
  // The title on the left and the entries on the right of a row, smaller where there is too little
  // room; where it is far too little, long names have dots in their middle.
  void add_heading(const std::string& title, std::vector<PlotEntry> entries, const PixelBox& row);
  // Lines across the axes at the ticks of the vertical axis, labels on its left. row_of: from a
  // value to pixels.
  void add_rows(const PixelBox& axes,
                const Ticks& ticks,
                const std::function<double(double)>& row_of);
  // Lines upwards at the ticks of the horizontal axis; with a name, labels and the name below it.
  void add_columns(const PixelBox& axes,
                   const Ticks& ticks,
                   const std::function<double(double)>& column_of,
                   const std::string& name);
  // The axes themselves.
  void add_axes(const PixelBox& axes);
  // A disc with a rim of the background.
  Stamp dot(const LinePoint& at, const glm::vec3& color) const;
  // A text that is not kept.
  Stamp text(const std::string& text, const TextStyle& style, double x, double y) const;

  const std::vector<Stamp>& stamps() const { return stamps_; }
  const std::vector<PlacedText>& texts() const { return texts_; }

 private:
  void add_line(const PixelBox& box, double opacity);
  void add_markup(const std::string& markup, const TextStyle& style, double x, double y);

  Theme theme_;
  const Typesetter& typesetter_;
  double size_;
  double line_;
  std::vector<Stamp> stamps_;
  std::vector<PlacedText> texts_;
};

// The rectangle of the ink of a text whose corner is at (x, y).
TextRoom ink_of(const TextBox& box, double x, double y);

// Lengths that plots and diagrams share, in units of the type.
inline constexpr double kPlotPad = 0.5;      // free at the sides
inline constexpr double kPlotHeading = 1.6;  // height of a heading
inline constexpr double kPlotOver = 0.35;    // between heading and axes
inline constexpr double kPlotUnder = 0.65;   // below axes without labels
inline constexpr double kPlotColumns = 3.1;  // below axes with labels and a name
inline constexpr double kPlotTick = 0.22;    // length of a tick
inline constexpr double kPlotTickGap = 0.2;  // between a tick and its label
// the same below axes: the lowest label beside them is above the first one below
inline constexpr double kPlotColumnGap = 0.4;
inline constexpr double kPlotAside = 0.9;   // free between labels side by side
inline constexpr double kPlotAbove = 0.45;  // free between labels one above the other
inline constexpr double kPlotDot = 0.24;    // radius of a dot

}  // namespace polhode
