// SPDX-License-Identifier: MIT
#include "frame/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frame/lettering.h"

namespace polhode {
namespace {

// sizes of type, in units of a frame's or a panel's size (see type_size)
constexpr double kTitleSize = 0.046;
constexpr double kCaptionSize = 0.040;
constexpr double kClockSize = 0.034;
constexpr double kPlotSize = 0.030;
constexpr double kLabelSize = 0.052;
constexpr double kNameSize = 0.041;
constexpr double kFigureSize = 0.044;
constexpr double kSmallNoteSize = 0.033;
constexpr double kEdge = 0.035;
// In small panels, in units of the whole frame: what can be read in the last row of a lecture hall.
constexpr double kLeastName = 0.031;
constexpr double kLeastFigures = 0.035;
constexpr double kLeast = 0.027;
constexpr double kMostOfPanel = 0.4;  // of a panel's height, for its notes
constexpr double kTextLine = 1.45;    // of the type: a line of title or caption

constexpr double kPlotsWidth = 0.43;   // of the frame
constexpr double kPlotsHeight = 0.42;  // of an upright frame
constexpr double kMostOfBar = 0.2;     // of the frame's height

int rounded(double value) {
  return static_cast<int>(std::lround(value));
}

double whole(const FilmText& text, PictureSize size) {
  return text.size * type_size(size.width, size.height);
}

}  // namespace

FilmText film_text(const ShowSpec& show, const std::string& title, double time_scale) {
  FilmText text;
  if (show.title) text.title = title;
  text.caption = show.caption;
  text.clock = show.clock;
  text.labels = show.labels;
  text.time_scale = time_scale;
  text.size = show.text_size;
  return text;
}

TimeUnit time_unit(double time_scale) {
  for (const TimeUnit& unit : {TimeUnit{86400.0, "days"}, TimeUnit{3600.0, "hours"}}) {
    if (time_scale >= unit.seconds / 4.0) return unit;
  }
  return {};
}

std::vector<PixelBox> panel_places(PictureSize size, int count) {
  // as many columns as bring the panels nearest to a square and leave the fewest gaps
  int columns = 1;
  double best = std::numeric_limits<double>::infinity();
  for (int tried = 1; tried <= count; ++tried) {
    const int rows = (count + tried - 1) / tried;
    const double shape = static_cast<double>(size.width) / tried * rows / size.height;
    const double off = std::abs(std::log(shape)) + 0.5 * (rows * tried - count);
    if (off < best) {
      best = off;
      columns = tried;
    }
  }
  const int rows = (count + columns - 1) / columns;
  std::vector<PixelBox> places;
  for (int i = 0; i < count; ++i) {
    const int row = i / columns;
    const int in_row = row == rows - 1 ? count - row * columns : columns;
    const int column = i - row * columns;
    const int left = size.width * column / in_row;
    const int right = size.width * (column + 1) / in_row;
    const int top = size.height * row / rows;
    const int bottom = size.height * (row + 1) / rows;
    places.push_back({left, top, right - left, bottom - top});
  }
  return places;
}

FrameAreas frame_areas(const FilmText& text, PictureSize size, int panels, int charts) {
  FrameAreas areas;
  PixelBox rest{0, 0, size.width, size.height};
  if (panels > 1 || charts > 0) {
    const auto bar = [&](double type) {
      const double height = kTextLine * type + 0.6 * kEdge * type_size(size.width, size.height);
      return rounded(std::min(height, kMostOfBar * size.height));
    };
    if (!text.title.empty() || text.clock) {
      areas.title = rest;
      areas.title.height =
          bar(text.title.empty() ? clock_size(text, size) : title_size(text, size));
      rest.y += areas.title.height;
      rest.height -= areas.title.height;
    }
    if (text.captions || !text.caption.empty()) {
      areas.caption = rest;
      areas.caption.height = bar(caption_size(text, size));
      rest.height -= areas.caption.height;
      areas.caption.y = rest.bottom();
    }
  }
  if (charts > 0 && size.width > size.height) {
    areas.plots = rest;
    areas.plots.width = rounded(kPlotsWidth * size.width);
    rest.width -= areas.plots.width;
    areas.plots.x = rest.right();
  } else if (charts > 0) {
    areas.plots = rest;
    areas.plots.height = rounded(kPlotsHeight * size.height);
    rest.height -= areas.plots.height;
    areas.plots.y = rest.bottom();
  }
  for (const PixelBox& place : panel_places({rest.width, rest.height}, panels))
    areas.panels.push_back({rest.x + place.x, rest.y + place.y, place.width, place.height});
  return areas;
}

ChartPlaces chart_places(const PixelBox& room, int diagrams, int plots) {
  const double share = room.height / std::max(1.0, 2.0 * diagrams + plots);
  ChartPlaces places;
  PixelBox rest = room;
  for (int i = 0; i < diagrams; ++i) {
    PixelBox place = rest;
    place.height = rounded(2.0 * share);
    rest.y += place.height;
    rest.height -= place.height;
    places.diagrams.push_back(place);
  }
  if (plots > 0) places.plots = rest;
  return places;
}

NoteSizes note_sizes(const FilmText& text,
                     const PixelBox& panel,
                     PictureSize size,
                     const NoteRows& rows) {
  const double own = text.size * type_size(panel.width, panel.height);
  const double least = whole(text, size);
  NoteSizes sizes;
  sizes.name = rows.name ? std::max(kNameSize * own, kLeastName * least) : 0.0;
  sizes.figures = rows.figures ? std::max(kFigureSize * own, kLeastFigures * least) : 0.0;
  sizes.stamp = rows.stamp ? std::max(kSmallNoteSize * own, kLeast * least) : 0.0;
  sizes.details = rows.details > 0 ? std::max(kSmallNoteSize * own, kLeast * least) : 0.0;
  sizes.height =
      kLineHeight * (sizes.name + sizes.figures + sizes.stamp + rows.details * sizes.details);
  const double shrink = std::min(1.0, kMostOfPanel * panel.height / std::max(1.0, sizes.height));
  for (double* value : {&sizes.name, &sizes.figures, &sizes.details, &sizes.stamp, &sizes.height})
    *value *= shrink;
  return sizes;
}

double label_size(const FilmText& text, const PixelBox& panel, PictureSize size) {
  return std::max(kLabelSize * text.size * type_size(panel.width, panel.height),
                  least_text_size(text, size));
}

double title_size(const FilmText& text, PictureSize size) {
  return kTitleSize * whole(text, size);
}

double caption_size(const FilmText& text, PictureSize size) {
  return kCaptionSize * whole(text, size);
}

double clock_size(const FilmText& text, PictureSize size) {
  return kClockSize * whole(text, size);
}

double plot_text_size(const FilmText& text, PictureSize size) {
  return kPlotSize * whole(text, size);
}

double least_text_size(const FilmText& text, PictureSize size) {
  return kLeast * whole(text, size);
}

double edge_of(const PixelBox& part) {
  return kEdge * type_size(part.width, part.height);
}

FrameMargins text_margins(const FilmText& text,
                          const PixelBox& panel,
                          PictureSize size,
                          const NoteRows& rows) {
  FrameMargins margins;
  if (text.labels) {
    const double label = label_size(text, panel, size);
    margins.left = margins.right = std::max(margins.left, 1.3 * label / panel.width);
    margins.top = margins.bottom = std::max(margins.top, 1.3 * label / panel.height);
  }
  margins.top += note_sizes(text, panel, size, rows).height / panel.height;
  // over a frame that is all panel
  if (panel == PixelBox{0, 0, size.width, size.height}) {
    if (!text.title.empty()) margins.top += kTextLine * title_size(text, size) / panel.height;
    if (text.captions || !text.caption.empty())
      margins.bottom += kTextLine * caption_size(text, size) / panel.height;
  }
  return margins;
}

}  // namespace polhode
