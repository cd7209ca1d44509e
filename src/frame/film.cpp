// SPDX-License-Identifier: MIT
#include "frame/film.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "frame/lettering.h"

namespace polhode {
namespace {

constexpr double kSeamWidth = 0.0022;
const Rgb kAlarm{196, 60, 18};

TextRoom room_of(const PixelBox& box) {
  return {static_cast<double>(box.x),
          static_cast<double>(box.y),
          static_cast<double>(box.right()),
          static_cast<double>(box.bottom())};
}

// lines between the parts of a frame with several panels
std::vector<Stamp> make_seams(const std::vector<FilmPanel>& panels,
                              const FrameAreas& areas,
                              PictureSize size) {
  if (panels.size() < 2) return {};
  const int seam = std::max(1, static_cast<int>(std::lround(kSeamWidth * size.height)));
  const Rgb grey = bytes_of(panels.front().composer->scenery().theme.space_axes);
  std::vector<Stamp> seams;
  const auto line = [&](const PixelBox& box) {
    seams.push_back(
        {std::make_shared<const Sprite>(filled_sprite(box.width, box.height, grey, 0.6)),
         box.x,
         box.y});
  };
  const PixelBox& title = areas.title;
  const PixelBox& caption = areas.caption;
  const PixelBox& plots = areas.plots;
  if (!title.empty()) line({0, title.bottom() - seam / 2, size.width, seam});
  if (!caption.empty()) line({0, caption.y - seam / 2, size.width, seam});
  if (plots.x > 0) line({plots.x - seam / 2, plots.y, seam, plots.height});
  if (!plots.empty() && plots.x == 0) line({0, plots.y - seam / 2, size.width, seam});
  const int top = panels.front().place.y;
  for (const FilmPanel& panel : panels) {
    const PixelBox& place = panel.place;
    if (place.x > 0) line({place.x - seam / 2, place.y, seam, place.height});
    if (place.y > top) line({place.x, place.y - seam / 2, place.width, seam});
  }
  return seams;
}

// "t = 3.25 s", and how much slower than life; for planets in hours or days
std::string clock_text(double t, double time_scale) {
  const double now = t == 0.0 ? 0.0 : t;
  const TimeUnit unit = time_unit(time_scale);
  if (unit.seconds > 1.0) {
    return fmt::format("<i>t</i> = {:.2f} {}   {:.3g} {} a second",
                       now / unit.seconds,
                       unit.name,
                       time_scale / unit.seconds,
                       unit.name);
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

struct Film::WithFonts {
  std::vector<FilmPlot> asked;
  std::once_flag once;
  std::unique_ptr<const PlotStack> plots;  // null: none
};

Film::Film(std::vector<FilmPanel> panels,
           const FilmText& text,
           PictureSize size,
           std::vector<FilmPlot> plots)
    : panels_(std::move(panels)),
      text_(text),
      size_(size),
      areas_(frame_areas(
          text, size, static_cast<int>(panels_.size()), static_cast<int>(plots.size()))),
      seams_(make_seams(panels_, areas_, size)),
      typesetter_(std::make_unique<Typesetter>()),
      with_fonts_(std::make_unique<WithFonts>()) {
  with_fonts_->asked = std::move(plots);
}

Film::Film(Film&&) noexcept = default;
Film::~Film() = default;

const Film::WithFonts& Film::with_fonts() const {
  std::call_once(with_fonts_->once, [&] {
    if (with_fonts_->asked.empty()) return;
    with_fonts_->plots =
        std::make_unique<const PlotStack>(with_fonts_->asked,
                                          areas_.plots,
                                          plot_text_size(text_, size_),
                                          panels_.front().composer->scenery().theme,
                                          time_unit(text_.time_scale),
                                          *typesetter_);
  });
  return *with_fonts_;
}

Film::Page Film::page_at(double film) const {
  const double t = panels_.front().composer->timeline().motion_time(film);
  Page page;
  // the text that keeps its place comes first: labels give way to it
  add_plots(t, page);
  page.picture.stamps.insert(page.picture.stamps.end(), seams_.begin(), seams_.end());
  if (panels_.size() > 1 || !areas_.plots.empty()) {
    add_bars(film, page);
  } else {
    add_frame_text(film, page);
  }
  for (const FilmPanel& panel : panels_) {
    const double notes_end = add_notes(panel, t, page);
    CameraView view = panel.composer->camera_view(film, panel.end);
    if (text_.labels) add_labels(panel, view.labels, notes_end, page);
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
  if (areas_.plots.empty()) return;
  with_fonts().plots->draw(t, page.picture.stamps);
  page.taken.push_back(room_of(areas_.plots));
}

// title and clock in the bar above, the caption in that below
void Film::add_bars(double film, Page& page) const {
  const Timeline& timeline = panels_.front().composer->timeline();
  const Theme& theme = panels_.front().composer->scenery().theme;
  const double edge = edge_of({0, 0, size_.width, size_.height});
  const auto add = [&](const std::string& markup, const TextStyle& style, double x, double middle) {
    const TextBox box = typesetter_->measure(markup, style);
    const double y = middle - 0.5 * box.height;
    page.picture.stamps.push_back(typesetter_->set(markup, style, x, y));
    page.taken.push_back(
        {x + box.ink_left, y + box.ink_top, x + box.ink_right, y + box.ink_bottom});
  };

  const PixelBox& above = areas_.title;
  const double middle = above.y + 0.5 * above.height;
  double free_to = size_.width - edge;
  if (text_.clock) {
    // as wide as at the end of the film, so that nothing beside it moves
    TextStyle style = style_of(theme, clock_size(text_, size_), theme.position);
    const double end = timeline.motion_time(timeline.film_duration());
    const std::string last = clock_text(end, text_.time_scale);
    const double most = text_.title.empty() ? free_to - edge : 0.4 * size_.width;
    const double shrink = std::min(1.0, most / typesetter_->measure(last, style).width);
    style.size *= shrink;
    style.halo *= shrink;
    const std::string markup = clock_text(timeline.motion_time(film), text_.time_scale);
    add(markup, style, free_to - typesetter_->measure(markup, style).width, middle);
    free_to -= typesetter_->measure(last, style).width + edge;
  }
  if (!text_.title.empty()) {
    TextStyle style = style_of(theme, title_size(text_, size_), theme.position);
    style.bold = true;
    const std::string markup = plain_text(text_.title);
    add(markup, fitted(*typesetter_, markup, style, free_to - edge, above.height), edge, middle);
  }
  const std::string caption = timeline.caption(film).value_or(text_.caption);
  if (!caption.empty() && !areas_.caption.empty()) {
    const PixelBox& below = areas_.caption;
    const TextStyle style = style_of(theme, caption_size(text_, size_), theme.position);
    const std::string markup = plain_text(caption);
    add(markup,
        fitted(*typesetter_, markup, style, size_.width - 2.0 * edge, below.height),
        edge,
        below.y + 0.5 * below.height);
  }
}

void Film::add_frame_text(double film, Page& page) const {
  const Timeline& timeline = panels_.front().composer->timeline();
  const double t = timeline.motion_time(film);
  const std::string caption = timeline.caption(film).value_or(text_.caption);
  const double edge = edge_of({0, 0, size_.width, size_.height});
  const Theme& theme = panels_.front().composer->scenery().theme;
  const auto add = [&](const std::string& markup, const TextStyle& style, double x, double y) {
    const TextBox box = typesetter_->measure(markup, style);
    page.picture.stamps.push_back(typesetter_->set(markup, style, x, y));
    page.taken.push_back(
        {x + box.ink_left, y + box.ink_top, x + box.ink_right, y + box.ink_bottom});
  };

  if (!text_.title.empty()) {
    TextStyle style = style_of(theme, title_size(text_, size_), theme.position);
    style.bold = true;
    style.width = size_.width - 2.0 * edge;
    const std::string markup = plain_text(text_.title);
    page.title_ends = 0.6 * edge + typesetter_->measure(markup, style).height;
    add(markup, style, edge, 0.6 * edge);
  }
  double bottom = size_.height - 0.6 * edge;
  if (!caption.empty()) {
    TextStyle style = style_of(theme, caption_size(text_, size_), theme.position);
    style.width = 0.72 * size_.width;
    const std::string markup = plain_text(caption);
    bottom -= typesetter_->measure(markup, style).height;
    add(markup, style, edge, bottom);
    bottom = size_.height - 0.6 * edge;
  }
  if (text_.clock) {
    const TextStyle style = style_of(theme, clock_size(text_, size_), theme.space_axes);
    const std::string markup = clock_text(t, text_.time_scale);
    const TextBox box = typesetter_->measure(markup, style);
    add(markup, style, size_.width - edge - box.width, bottom - box.height);
  }
}

double Film::add_notes(const FilmPanel& panel, double t, Page& page) const {
  if (!panel.notes) return panel.place.y;
  const PanelNotes notes = panel.notes(t);
  const PixelBox& place = panel.place;
  const NoteSizes sizes = note_sizes(text_, place, size_, panel.rows);
  const double edge = edge_of(place);
  const double pad = 0.35 * sizes.stamp;
  const double width = place.width - 2.0 * edge;
  const Theme& theme = panel.composer->scenery().theme;

  // rows from the top, each no wider than the panel
  double y = std::max(place.y + 0.35 * edge, page.title_ends);
  const auto add = [&](const std::string& line, double size, bool bold) {
    const double height = kLineHeight * size;
    TextStyle style = style_of(theme, size, theme.position);
    style.bold = bold;
    const std::string markup = plain_text(line);
    style = fitted(*typesetter_, markup, style, width, height);
    const TextBox box = typesetter_->measure(markup, style);
    page.picture.stamps.push_back(typesetter_->set(markup, style, place.x + edge, y));
    page.taken.push_back({place.x + edge, y, place.x + edge + box.width, y + box.height});
    y += height;
  };
  if (!notes.name.empty()) add(notes.name, sizes.name, true);
  if (!notes.figures.empty()) add(notes.figures, sizes.figures, false);
  for (const std::string& line : notes.details)
    add(line, sizes.details, false);

  // a badge under them
  if (notes.stamp.empty()) return y;
  const double height = kLineHeight * sizes.stamp;
  TextStyle style = style_of(theme, sizes.stamp, glm::vec3(1.0f));
  style.halo = 0.0;
  style.bold = true;
  const std::string markup = plain_text(notes.stamp);
  style = fitted(*typesetter_, markup, style, width - pad, height);
  const TextBox box = typesetter_->measure(markup, style);
  const PixelBox badge{static_cast<int>(std::lround(place.x + edge - pad)),
                       static_cast<int>(std::lround(y)),
                       static_cast<int>(std::lround(box.width + 2.0 * pad)),
                       static_cast<int>(std::lround(height))};
  page.picture.stamps.push_back(
      {std::make_shared<Sprite>(filled_sprite(badge.width, badge.height, kAlarm, 0.92)),
       badge.x,
       badge.y});
  page.picture.stamps.push_back(
      typesetter_->set(markup, style, badge.x + pad, badge.y + 0.5 * (badge.height - box.height)));
  page.taken.push_back(room_of(badge));
  return badge.bottom();
}

void Film::add_labels(const FilmPanel& panel,
                      const std::vector<SeenLabel>& labels,
                      double top,
                      Page& page) const {
  const PixelBox& place = panel.place;
  const Theme& theme = panel.composer->scenery().theme;
  const double size = label_size(text_, place, size_);
  std::vector<LabelWish> wishes;
  std::vector<TextShaft> shafts;
  std::vector<TextStyle> styles;
  const Vec2 corner(place.x, place.y);
  for (const SeenLabel& label : labels) {
    TextStyle style = style_of(theme, size, label.color);
    style.face = Face::math;
    const TextBox box = typesetter_->measure(label.markup, style);
    wishes.push_back({corner + label.at, label.away, box.ink_width(), box.ink_height()});
    shafts.push_back(
        {corner + label.from, corner + label.at, corner + label.neck, label.head_radius});
    styles.push_back(style);
  }
  const double inset = 0.25 * size;
  TextRoom frame = room_of(place);
  frame = {frame.left + inset,
           std::max(frame.top, top) + inset,
           frame.right - inset,
           frame.bottom - inset};
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
