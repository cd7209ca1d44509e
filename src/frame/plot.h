// SPDX-License-Identifier: MIT
// Plots of quantities over time, drawn once and revealed as time passes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frame/layout.h"
#include "frame/plot_paper.h"
#include "text/typesetter.h"

namespace polhode {

// A curve of a plot. Plain text.
struct PlotCurve {
  std::string name;
  std::vector<double> values;  // at equal steps from `begins` to `ends`; NaN where undefined
};

// What a plot shows. Plain text.
struct FilmPlot {
  std::string title;
  std::string unit;  // of the values; empty: none
  std::vector<PlotCurve> curves;
  double begins = 0.0, ends = 1.0;  // s of motion
  // The value of each curve at a time between them; called from any thread.
  std::function<std::vector<double>(double t)> now;
};

// Heights (pixels, y down, from `top` to `bottom`) for labels of one height that should stand at
// `wished`, in its order: as near as possible without overlap, in the order of the wishes; those
// that differ by less than half a pixel are in the order of the list.
std::vector<double> heights_apart(const std::vector<double>& wished,
                                  double height,
                                  double top,
                                  double bottom);

// Plots one below the other, which share a time axis. Immutable.
class PlotStack {
 public:
  // `room` (pixels of the frame) is where they stand; `size` is that of their type, pixels, which
  // is smaller where there is too little room. There is at least one plot with at least one curve;
  // the typesetter must outlive the stack. Throws Error as Typesetter does.
  PlotStack(std::vector<FilmPlot> plots,
            const PixelBox& room,
            double size,
            const Theme& theme,
            const TimeUnit& unit,
            const Typesetter& typesetter);

  // Appends the stamps of the time t, s of motion: curves up to it, with a dot and its value at
  // their ends. All but dots, values and the line of the present are the same for any time. Throws
  // Error as FilmPlot::now and Typesetter do.
  void draw(double t, std::vector<Stamp>& stamps) const;

  // For tests, pixels of the frame. Where the curves of each plot are:
  std::vector<PixelBox> axes() const;
  // All text that keeps its place, the values at a time, and both.
  const std::vector<PlacedText>& fixed_text() const { return paper_.texts(); }
  std::vector<PlacedText> values(double t) const;
  std::vector<PlacedText> texts(double t) const;

 private:
  // A curve on the sprite of draw_curves(): the pattern of its dashes, and these.
  struct Curve {
    std::vector<double> dashes;
    std::vector<Polyline> pieces;
  };
  // A plot with its place and scale.
  struct Drawn {
    FilmPlot plot;
    PixelBox axes;
    double low = 0.0, high = 1.0;  // values at the lower and upper end of `axes`
    double value_width = 0.0;      // px: of the widest value
    SpritePtr plate;               // of the background, under each value
    Ticks ticks;
    int rim = 0;  // px that `sprite` has around the axes
    std::vector<Curve> curves;
    Stamp sprite;  // of all curves
  };
  // A value beside its dot.
  struct Value {
    std::size_t curve = 0;
    LinePoint dot;
    std::string text;
    double x = 0.0, y = 0.0;  // of the text's corner
    TextBox box;
  };
  std::vector<Curve> curves_of(const Drawn& one) const;
  void add_heading(const Drawn& one, const PixelBox& row);
  void add_axes(const Drawn& one, const Ticks& times, const TimeUnit& unit, bool is_last);
  Stamp draw_curves(const Drawn& one) const;
  // The curves up to a column of the frame: all but the last columns are those of the sprite.
  void add_curves(const Drawn& one, double column, std::vector<Stamp>& stamps) const;
  Stamp plate_of(const Drawn& one, const Value& value) const;
  std::vector<Value> values_of(const Drawn& one, double t) const;
  std::string value_text(const Drawn& one, double value) const;
  std::vector<Polyline> lines_of(const Drawn& one, std::size_t curve) const;
  std::vector<double> dashes(std::size_t curve) const;
  glm::vec3 color(std::size_t curve) const;
  double column_of(const Drawn& one, double t) const;
  double row_of(const Drawn& one, double value) const;

  PlotPaper paper_;
  std::vector<Drawn> plots_;
  SpritePtr present_;  // the line of the present
};

}  // namespace polhode
