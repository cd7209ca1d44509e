// SPDX-License-Identifier: MIT
#include "frame/film.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace polhode {
namespace {

// sizes of fonts, in units of a panel's size (see type_size)
constexpr double kTitleSize = 0.046;
constexpr double kCaptionSize = 0.040;
constexpr double kClockSize = 0.034;
constexpr double kLabelSize = 0.052;
constexpr double kNoteSize = 0.038;
constexpr double kLineHeight = 1.45;  // of the font
constexpr double kEdge = 0.035;       // free at the sides of the frame
constexpr double kHalo = 0.075;       // of the font
constexpr double kSeamWidth = 0.0022;
const Rgb kAlarm{196, 60, 18};

Rgb bytes(const glm::vec3& color) {
  const auto byte = [](float value) {
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
  };
  return {byte(color.r), byte(color.g), byte(color.b)};
}

// what fonts are measured in: the height of a 16:9 frame of this area, so that narrow panels keep
// theirs legible
double type_size(double width, double height) {
  return std::min(height, std::sqrt(width * height * 9.0 / 16.0));
}

TextStyle style_of(const Theme& theme, double size, const glm::vec3& color) {
  TextStyle style;
  style.size = size;
  style.color = bytes(color);
  style.halo = kHalo * size;
  style.halo_color = bytes(theme.background);
  return style;
}

TextRoom room_of(const PixelBox& box) {
  return {static_cast<double>(box.x),
          static_cast<double>(box.y),
          static_cast<double>(box.right()),
          static_cast<double>(box.bottom())};
}

std::vector<Stamp> make_seams(const std::vector<FilmPanel>& panels, PictureSize size) {
  const int seam = std::max(1, static_cast<int>(std::lround(kSeamWidth * size.height)));
  const Rgb grey = bytes(panels.front().composer->scenery().theme.space_axes);
  const auto line = [&](int width, int height) {
    return std::make_shared<const Sprite>(filled_sprite(width, height, grey, 0.6));
  };
  std::vector<Stamp> seams;
  for (const FilmPanel& panel : panels) {
    const PixelBox& place = panel.place;
    if (place.x > 0) seams.push_back({line(seam, place.height), place.x - seam / 2, place.y});
    if (place.y > 0) seams.push_back({line(place.width, seam), place.x, place.y - seam / 2});
  }
  return seams;
}

// "t = 3.25 s", and how much slower than life; for planets in hours or days
std::string clock_text(double t, double time_scale) {
  const double now = t == 0.0 ? 0.0 : t;
  for (const auto& [unit, name] : {std::pair{86400.0, "days"}, {3600.0, "hours"}}) {
    if (time_scale < unit / 4.0) continue;
    return fmt::format(
        "<i>t</i> = {:.2f} {}   {:.3g} {} a second", now / unit, name, time_scale / unit, name);
  }
  std::string text = fmt::format("<i>t</i> = {:.2f} s", now);
  if (time_scale < 1.0) text += fmt::format("   {:.3g}× slower", 1.0 / time_scale);
  if (time_scale > 1.0) text += fmt::format("   {:.3g}× faster", time_scale);
  return text;
}

}  // namespace

// a picture while text is added to it
struct Film::Page {
  Picture picture;
  std::vector<TextRoom> taken;
  double title_ends = 0.0;  // px from the top
};

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

FrameMargins text_margins(const FilmText& text,
                          const PixelBox& panel,
                          PictureSize size,
                          int note_lines) {
  FrameMargins margins;
  const double own = text.size * type_size(panel.width, panel.height);
  const double whole = text.size * type_size(size.width, size.height);
  if (text.labels) {
    margins.left = margins.right = std::max(margins.left, 1.3 * kLabelSize * own / panel.width);
    margins.top = margins.bottom = std::max(margins.top, 1.3 * kLabelSize * own / panel.height);
  }
  double above = note_lines * kLineHeight * kNoteSize * own;
  double below = 0.0;
  if (panel.y == 0 && !text.title.empty()) above += kLineHeight * kTitleSize * whole;
  const bool at_bottom = panel.bottom() == size.height;
  if (at_bottom && (text.captions || !text.caption.empty()))
    below += kLineHeight * kCaptionSize * whole;
  margins.top += above / panel.height;
  margins.bottom += below / panel.height;
  return margins;
}

Film::Film(std::vector<FilmPanel> panels,
           const FilmText& text,
           PictureSize size,
           std::vector<FilmPlot> plots)
    : panels_(std::move(panels)),
      text_(text),
      size_(size),
      plots_(std::move(plots)),
      seams_(make_seams(panels_, size)),
      typesetter_(std::make_unique<Typesetter>()) {}

Film::Page Film::page_at(double film) const {
  const double t = panels_.front().composer->timeline().motion_time(film);
  Page page;
  // the text that keeps its place comes first: labels give way to it
  add_plots(t, page);
  add_frame_text(film, page);
  for (const FilmPanel& panel : panels_)
    add_notes(panel, t, page);
  for (const FilmPanel& panel : panels_) {
    CameraView view = panel.composer->camera_view(film, panel.end);
    if (text_.labels) add_labels(panel, view.labels, page);
    page.picture.panels.push_back({panel.place, std::move(view.list)});
  }
  return page;
}

Picture Film::at(double film) const {
  return page_at(film).picture;
}

Picture Film::bare_at(double film) const {
  Picture picture;
  for (const FilmPanel& panel : panels_)
    picture.panels.push_back({panel.place, panel.composer->camera_view(film, panel.end).list});
  return picture;
}

std::vector<TextRoom> Film::text_rooms(double film) const {
  return page_at(film).taken;
}

void Film::add_plots(double t, Page& page) const {
  for (const FilmPlot& plot : plots_) {
    const double part = std::clamp((t - plot.begins) / (plot.ends - plot.begins), 0.0, 1.0);
    const int now = plot.first + static_cast<int>(std::lround(part * (plot.last - plot.first)));
    page.picture.stamps.push_back({plot.axes, plot.place.x, plot.place.y});
    page.picture.stamps.push_back({plot.curves, plot.place.x, plot.place.y, 1.0, now + 1});
    page.taken.push_back(room_of(plot.place));
  }
}

void Film::add_frame_text(double film, Page& page) const {
  const Timeline& timeline = panels_.front().composer->timeline();
  const double t = timeline.motion_time(film);
  const std::string caption = timeline.caption(film).value_or(text_.caption);
  const double unit = text_.size * type_size(size_.width, size_.height);
  const double edge = kEdge * type_size(size_.width, size_.height);
  const Theme& theme = panels_.front().composer->scenery().theme;
  const auto add = [&](const std::string& markup, const TextStyle& style, double x, double y) {
    const TextBox box = typesetter_->measure(markup, style);
    page.picture.stamps.push_back(typesetter_->set(markup, style, x, y));
    page.taken.push_back(
        {x + box.ink_left, y + box.ink_top, x + box.ink_right, y + box.ink_bottom});
  };

  page.picture.stamps.insert(page.picture.stamps.end(), seams_.begin(), seams_.end());
  if (!text_.title.empty()) {
    TextStyle style = style_of(theme, kTitleSize * unit, theme.position);
    style.bold = true;
    style.width = size_.width - 2.0 * edge;
    const std::string markup = plain_text(text_.title);
    page.title_ends = 0.6 * edge + typesetter_->measure(markup, style).height;
    add(markup, style, edge, 0.6 * edge);
  }
  double bottom = size_.height - 0.6 * edge;
  if (!caption.empty()) {
    TextStyle style = style_of(theme, kCaptionSize * unit, theme.position);
    style.width = 0.72 * size_.width;
    const std::string markup = plain_text(caption);
    bottom -= typesetter_->measure(markup, style).height;
    add(markup, style, edge, bottom);
    bottom = size_.height - 0.6 * edge;
  }
  if (text_.clock) {
    const TextStyle style = style_of(theme, kClockSize * unit, theme.space_axes);
    const std::string markup = clock_text(t, text_.time_scale);
    const TextBox box = typesetter_->measure(markup, style);
    add(markup, style, size_.width - edge - box.width, bottom - box.height);
  }
}

void Film::add_notes(const FilmPanel& panel, double t, Page& page) const {
  if (!panel.notes) return;
  const PanelNotes notes = panel.notes(t);
  const PixelBox& place = panel.place;
  const double unit = text_.size * type_size(place.width, place.height);
  const double edge = kEdge * type_size(place.width, place.height);
  const Theme& theme = panel.composer->scenery().theme;
  const bool under_title = place.y == 0 && !text_.title.empty();

  // lines from the top, the first as a heading
  double y = under_title ? page.title_ends : place.y + 0.6 * edge;
  for (std::size_t i = 0; i < notes.lines.size(); ++i) {
    TextStyle style = style_of(theme, kNoteSize * unit, i == 0 ? theme.position : theme.space_axes);
    style.bold = i == 0;
    const std::string markup = plain_text(notes.lines[i]);
    const TextBox box = typesetter_->measure(markup, style);
    page.picture.stamps.push_back(typesetter_->set(markup, style, place.x + edge, y));
    page.taken.push_back({place.x + edge, y, place.x + edge + box.width, y + box.height});
    y += kLineHeight * kNoteSize * unit;
  }

  // a badge under them
  if (notes.stamp.empty()) return;
  TextStyle style = style_of(theme, kNoteSize * unit, glm::vec3(1.0f));
  style.halo = 0.0;
  style.bold = true;
  const std::string markup = plain_text(notes.stamp);
  const TextBox box = typesetter_->measure(markup, style);
  const auto pad = static_cast<int>(std::lround(0.35 * style.size));
  const PixelBox badge{place.x + static_cast<int>(std::lround(edge)) - pad,
                       static_cast<int>(std::lround(y)),
                       static_cast<int>(std::lround(box.width)) + 2 * pad,
                       static_cast<int>(std::lround(box.height))};
  page.picture.stamps.push_back(
      {std::make_shared<Sprite>(filled_sprite(badge.width, badge.height, kAlarm, 0.92)),
       badge.x,
       badge.y});
  page.picture.stamps.push_back(typesetter_->set(markup, style, badge.x + pad, badge.y));
  page.taken.push_back(room_of(badge));
}

void Film::add_labels(const FilmPanel& panel,
                      const std::vector<SeenLabel>& labels,
                      Page& page) const {
  const PixelBox& place = panel.place;
  const Theme& theme = panel.composer->scenery().theme;
  const double size = kLabelSize * text_.size * type_size(place.width, place.height);
  std::vector<LabelWish> wishes;
  std::vector<TextShaft> shafts;
  std::vector<TextStyle> styles;
  const Vec2 corner(place.x, place.y);
  for (const SeenLabel& label : labels) {
    TextStyle style = style_of(theme, size, label.color);
    style.face = Face::math;
    const TextBox box = typesetter_->measure(label.markup, style);
    wishes.push_back({corner + label.at, label.away, box.ink_width(), box.ink_height()});
    shafts.push_back({corner + label.from, corner + label.at});
    styles.push_back(style);
  }
  const double inset = 0.25 * size;
  TextRoom frame = room_of(place);
  frame = {frame.left + inset, frame.top + inset, frame.right - inset, frame.bottom - inset};
  const std::vector<TextRoom> rooms = place_labels(wishes, page.taken, shafts, frame, 0.2 * size);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const TextBox box = typesetter_->measure(labels[i].markup, styles[i]);
    Stamp stamp = typesetter_->set(
        labels[i].markup, styles[i], rooms[i].left - box.ink_left, rooms[i].top - box.ink_top);
    stamp.opacity = labels[i].fade;
    page.picture.stamps.push_back(stamp);
    page.taken.push_back(rooms[i]);
  }
}

}  // namespace polhode
