// SPDX-License-Identifier: MIT
#include "frame/film.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "frame/chevron.h"
#include "frame/lettering.h"

namespace polhode {
namespace {

constexpr double kSeamWidth = 0.0022;
constexpr double kLeaderWidth = 0.05;  // of the type
constexpr double kChevron = 0.7;       // its size, in that of names of vectors
// s of film between the moments for which places of labels are chosen, at least; how many there
// are, at most
constexpr double kMoment = 0.05;
constexpr double kMostMoments = 6000.0;
const Rgb kAlarm{196, 60, 18};

TextRoom room_of(const PixelBox& box) {
  return {static_cast<double>(box.x),
          static_cast<double>(box.y),
          static_cast<double>(box.right()),
          static_cast<double>(box.bottom())};
}

TextRoom moved(const TextRoom& room, const Vec2& by) {
  return {room.left + by.x(), room.top + by.y(), room.right + by.x(), room.bottom + by.y()};
}

// s of film
double step_between_moments(double duration) {
  return std::max(kMoment, duration / kMostMoments);
}

// The end of a vector as far as it lies in the room; nothing if it begins outside.
std::optional<Vec2> visible_end(const TextShaft& shaft, const TextRoom& room) {
  if (distance(room, shaft.from) > 0.0) return std::nullopt;
  const Vec2 way = shaft.tip - shaft.from;
  double part = 1.0;
  const auto clip = [&part](double from, double by, double low, double high) {
    if (by < 0.0) part = std::min(part, (low - from) / by);
    if (by > 0.0) part = std::min(part, (high - from) / by);
  };
  clip(shaft.from.x(), way.x(), room.left, room.right);
  clip(shaft.from.y(), way.y(), room.top, room.bottom);
  if (part >= 1.0) return shaft.tip;
  return shaft.from + part * way;
}

// The end of a vector as far as it can be told from others: before the head of another one that
// covers its own. Heads are rectangles around them.
Vec2 own_end(const TextShaft& shaft, const std::vector<TextRoom>& heads) {
  const double length = (shaft.tip - shaft.from).norm();
  for (double back = 0.0; back < length; back += 1.0) {
    Vec2 point = shaft.tip + (back / length) * (shaft.from - shaft.tip);
    const auto over = std::count_if(heads.begin(), heads.end(), [&](const TextRoom& head) {
      return distance(head, point) == 0.0;
    });
    if (over <= 1) return point;
  }
  return shaft.tip;
}

// Between the moments for which places are chosen, things move a little: the few pixels that a
// label then has to go to be off text and other labels.
Vec2 clear_center(const LabelWish& wish,
                  const Vec2& center,
                  const std::vector<TextRoom>& text,
                  const std::vector<TextRoom>& labels,
                  const TextRoom& frame) {
  const TextRoom room = room_at(center, wish.width, wish.height);
  for (const std::vector<TextRoom>* others : {&text, &labels}) {
    for (const TextRoom& other : *others)
      if (overlap(room, other)) return settled_at(wish, center, {text, {}}, labels, frame, 0.5);
  }
  return center;
}

// px
double capital_height(const Typesetter& typesetter, const TextStyle& style) {
  return typesetter.measure("L", style).ink_height();
}

// the line from a name to its tip, with half the rim that the letters have
Stamp leader_stamp(const PlacedText& text) {
  const Leader& leader = *text.leader;
  const double width = std::max(1.0, kLeaderWidth * text.style.size);
  const double rim = 0.5 * width + text.style.halo + 1.0;
  const int left = static_cast<int>(std::floor(std::min(leader.from.x(), leader.to.x()) - rim));
  const int top = static_cast<int>(std::floor(std::min(leader.from.y(), leader.to.y()) - rim));
  const double right = std::max(leader.from.x(), leader.to.x()) + rim;
  const double bottom = std::max(leader.from.y(), leader.to.y()) + rim;
  Sprite line(static_cast<int>(std::ceil(right)) - left, static_cast<int>(std::ceil(bottom)) - top);
  const std::vector<Polyline> way = {{{leader.from.x() - left, leader.from.y() - top},
                                      {leader.to.x() - left, leader.to.y() - top}}};
  stroke(line, way, width + text.style.halo, text.style.halo_color);
  stroke(line, way, width, text.style.color);
  return {
      std::make_shared<const Sprite>(std::move(line)), left, top, text.opacity * leader.opacity};
}

// Lines between the parts of a frame with several panels; of one panel, to its plots and its
// caption, as a floor may reach there.
std::vector<Stamp> make_seams(const std::vector<FilmPanel>& panels,
                              const FrameAreas& areas,
                              PictureSize size) {
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
  const bool several = panels.size() > 1;
  if (several && !title.empty()) line({0, title.bottom() - seam / 2, size.width, seam});
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

// "4", "16.7", "1500"
std::string factor_text(double factor) {
  return factor < 100.0 ? fmt::format("{:.3g}", factor) : fmt::format("{:.0f}", factor);
}

// "t = 3.25 s", and how much slower than life; for planets in hours or days. In a second of film at
// least five of the last digit pass.
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
  constexpr double kFine = 0.05, kAsInLife = 0.005;
  const double times_finer = std::clamp(kFine / time_scale, 1.0, 1e12);
  const int more = static_cast<int>(std::ceil(std::log10(times_finer)));
  std::string text = fmt::format("<i>t</i> = {:.{}f} s", now, 2 + more);
  if (time_scale < 1.0 - kAsInLife) {
    text += fmt::format("   {}× slower", factor_text(1.0 / time_scale));
  } else if (time_scale > 1.0 + kAsInLife) {
    text += fmt::format("   {}× faster", factor_text(time_scale));
  }
  return text;
}

}  // namespace

// a picture while text is added to it
struct Film::Page {
  Picture picture;
  std::vector<Stamp> leaders;
  PlacedPage placed;
  double title_ends = 0.0;  // px from the top
};

// labels of a panel before they are placed
struct Film::Layout {
  double size = 0.0;  // of the type, px
  TextRoom frame;     // where labels may stand
  LabelMoment moment;
  std::vector<TextStyle> styles;

  double gap() const { return 0.2 * size; }
};

struct Film::WithFonts {
  FilmCharts asked;
  std::once_flag once;
  std::vector<std::vector<std::unique_ptr<const DiagramPicture>>> diagrams;  // as asked
  std::unique_ptr<const PlotStack> plots;                                    // null: none
  std::vector<LabelTracks> tracks;  // of each panel; none without labels
};

Film::Film(std::vector<FilmPanel> panels,
           const FilmText& text,
           PictureSize size,
           FilmCharts charts,
           std::optional<Timeline> in_turn)
    : panels_(std::move(panels)),
      in_turn_(std::move(in_turn)),
      text_(text),
      size_(size),
      areas_(
          frame_areas(text, size, in_turn_ ? 1 : static_cast<int>(panels_.size()), charts.count())),
      seams_(is_divided() ? make_seams(panels_, areas_, size) : std::vector<Stamp>()),
      typesetter_(std::make_unique<Typesetter>()),
      with_fonts_(std::make_unique<WithFonts>()) {
  with_fonts_->asked = std::move(charts);
}

Film::Film(Film&&) noexcept = default;
Film::~Film() = default;

const Film::WithFonts& Film::with_fonts() const {
  std::call_once(with_fonts_->once, [&] {
    if (text_.labels) {
      for (std::size_t i = 0; i < panels_.size(); ++i)
        with_fonts_->tracks.push_back(tracks_of(i));
    }
    const FilmCharts& asked = with_fonts_->asked;
    const Theme& theme = panels_.front().composer->scenery().theme;
    const double type = plot_text_size(text_, size_);
    const ChartPlaces places = chart_places(areas_.plots,
                                            static_cast<int>(asked.diagrams.size()),
                                            static_cast<int>(asked.plots.size()));
    // those above one another begin at one place, so that points can be followed up and down
    std::map<int, int> left;  // of axes, by the left side of their room
    const auto picture = [&](std::size_t i, const Diagram& diagram, int begins) {
      return std::make_unique<const DiagramPicture>(
          diagram, places.diagrams[i], type, theme, *typesetter_, begins);
    };
    for (std::size_t i = 0; i < asked.diagrams.size(); ++i) {
      auto& pictures = with_fonts_->diagrams.emplace_back();
      for (const Diagram& diagram : asked.diagrams[i]) {
        pictures.push_back(picture(i, diagram, 0));
        int& most = left[places.diagrams[i].x];
        most = std::max(most, pictures.back()->axes().x);
      }
    }
    for (std::size_t i = 0; i < asked.diagrams.size(); ++i) {
      const int begins = left[places.diagrams[i].x];
      for (std::size_t k = 0; k < asked.diagrams[i].size(); ++k) {
        auto& made = with_fonts_->diagrams[i][k];
        if (made->axes().x < begins) made = picture(i, asked.diagrams[i][k], begins);
      }
    }
    if (asked.plots.empty()) return;
    with_fonts_->plots = std::make_unique<const PlotStack>(
        asked.plots, places.plots, type, theme, time_unit(text_.time_scale), *typesetter_);
  });
  return *with_fonts_;
}

const Timeline& Film::timeline() const {
  return in_turn_ ? *in_turn_ : panels_.front().composer->timeline();
}

double Film::turn() const {
  return panels_.front().composer->timeline().film_duration();
}

bool Film::is_divided() const {
  return (panels_.size() > 1 && !in_turn_) || !areas_.plots.empty();
}

std::vector<Film::Shown> Film::shown_at(double film) const {
  std::vector<Shown> shown;
  if (in_turn_) {
    // a frame time may be a rounding before the end of a turn
    const double last = static_cast<double>(panels_.size() - 1);
    const double now = std::clamp(std::floor((film + kFilmRounding) / turn()), 0.0, last);
    shown.push_back({static_cast<std::size_t>(now), std::max(0.0, film - now * turn())});
    return shown;
  }
  for (std::size_t i = 0; i < panels_.size(); ++i)
    shown.push_back({i, film});
  return shown;
}

double Film::next_cut(double film) const {
  double cut = std::numeric_limits<double>::infinity();
  for (const Shown& shown : shown_at(film)) {
    const double begins = film - shown.film;
    cut = std::min(cut, begins + panels_[shown.panel].composer->next_cut(shown.film));
    if (in_turn_ && shown.panel + 1 < panels_.size()) cut = std::min(cut, begins + turn());
  }
  return cut;
}

std::string Film::caption_at(double film) const {
  // each panel in turn tells the story from its beginning
  const Shown shown = shown_at(film).front();
  return panels_[shown.panel].composer->timeline().caption(shown.film).value_or(text_.caption);
}

Film::Page Film::page_at(double film) const {
  Page page;
  // the text that keeps its place comes first: labels give way to it
  add_charts(film, page);
  page.picture.stamps.insert(page.picture.stamps.end(), seams_.begin(), seams_.end());
  if (is_divided()) {
    add_bars(film, page);
  } else {
    add_frame_text(film, page);
  }
  for (const Shown& shown : shown_at(film)) {
    const FilmPanel& panel = panels_[shown.panel];
    const double own_t = panel.composer->timeline().motion_time(shown.film);
    const double notes_end = add_notes(panel, own_t, page);
    CameraView view = panel.composer->camera_view(shown.film, panel.end);
    if (view.way_to_body) add_way_to_body(panel, *view.way_to_body, notes_end, page);
    if (text_.labels) {
      const LabelTracks& tracks = with_fonts().tracks[shown.panel];
      add_labels(panel, tracks, view.names, shown.film, notes_end, page);
    }
    page.picture.panels.push_back({panel.place, std::move(view.list)});
  }
  // under all text
  std::vector<Stamp>& stamps = page.picture.stamps;
  stamps.insert(stamps.begin(), page.leaders.begin(), page.leaders.end());
  return page;
}

Picture Film::at(double film) const {
  return page_at(film).picture;
}

Picture Film::bare_at(double film) const {
  Picture picture;
  for (const Shown& shown : shown_at(film)) {
    const FilmPanel& panel = panels_[shown.panel];
    picture.panels.push_back(
        {panel.place, panel.composer->camera_view(shown.film, panel.end).list});
  }
  return picture;
}

PlacedPage Film::placed(double film) const {
  return page_at(film).placed;
}

TextRoom Film::add_text(TextRole role,
                        const std::string& markup,
                        const TextStyle& style,
                        double x,
                        double y,
                        Page& page) const {
  const TextBox box = typesetter_->measure(markup, style);
  const TextRoom ink{x + box.ink_left, y + box.ink_top, x + box.ink_right, y + box.ink_bottom};
  page.picture.stamps.push_back(typesetter_->set(markup, style, x, y));
  page.placed.texts.push_back({role, markup, style, ink});
  return ink;
}

void Film::add_charts(double film, Page& page) const {
  if (areas_.plots.empty()) return;
  const WithFonts& charts = with_fonts();
  page.placed.rooms.push_back(room_of(areas_.plots));
  // of the panel whose turn it is
  const Shown shown = shown_at(film).front();
  const double own_t = panels_[shown.panel].composer->timeline().motion_time(shown.film);
  for (const auto& of_panels : charts.diagrams) {
    const DiagramPicture& diagram = *of_panels[std::min(shown.panel, of_panels.size() - 1)];
    diagram.draw(own_t, page.picture.stamps);
    const std::vector<PlacedText>& texts = diagram.texts();
    page.placed.texts.insert(page.placed.texts.end(), texts.begin(), texts.end());
  }
  if (charts.plots == nullptr) return;
  const double t = timeline().motion_time(film);
  charts.plots->draw(t, page.picture.stamps);
  for (PlacedText& text : charts.plots->texts(t))
    page.placed.texts.push_back(std::move(text));
}

// title and clock in the bar above, the caption in that below
void Film::add_bars(double film, Page& page) const {
  const Timeline& timeline = this->timeline();
  const Theme& theme = panels_.front().composer->scenery().theme;
  const double edge = edge_of({0, 0, size_.width, size_.height});
  const auto add = [&](TextRole role,
                       const std::string& markup,
                       const TextStyle& style,
                       double x,
                       double middle) {
    const double y = middle - 0.5 * typesetter_->measure(markup, style).height;
    page.placed.rooms.push_back(add_text(role, markup, style, x, y, page));
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
    const double x = free_to - typesetter_->measure(markup, style).width;
    add(TextRole::clock, markup, style, x, middle);
    free_to -= typesetter_->measure(last, style).width + edge;
  }
  if (!text_.title.empty()) {
    TextStyle style = style_of(theme, title_size(text_, size_), theme.position);
    style.bold = true;
    const std::string markup = plain_text(text_.title);
    style = fitted(*typesetter_, markup, style, free_to - edge, above.height);
    add(TextRole::title, markup, style, edge, middle);
  }
  const std::string caption = caption_at(film);
  if (!caption.empty() && !areas_.caption.empty()) {
    const PixelBox& below = areas_.caption;
    const TextStyle style = style_of(theme, caption_size(text_, size_), theme.position);
    const std::string markup = plain_text(caption);
    add(TextRole::caption,
        markup,
        fitted(*typesetter_, markup, style, size_.width - 2.0 * edge, below.height),
        edge,
        below.y + 0.5 * below.height);
  }
}

void Film::add_frame_text(double film, Page& page) const {
  const Timeline& timeline = this->timeline();
  const double t = timeline.motion_time(film);
  const std::string caption = caption_at(film);
  const double edge = edge_of({0, 0, size_.width, size_.height});
  const Theme& theme = panels_.front().composer->scenery().theme;
  const auto add =
      [&](TextRole role, const std::string& markup, const TextStyle& style, double x, double y) {
        page.placed.rooms.push_back(add_text(role, markup, style, x, y, page));
      };

  if (!text_.title.empty()) {
    TextStyle style = style_of(theme, title_size(text_, size_), theme.position);
    style.bold = true;
    style.width = size_.width - 2.0 * edge;
    const std::string markup = plain_text(text_.title);
    page.title_ends = 0.6 * edge + typesetter_->measure(markup, style).height;
    add(TextRole::title, markup, style, edge, 0.6 * edge);
  }
  double bottom = size_.height - 0.6 * edge;
  if (!caption.empty()) {
    TextStyle style = style_of(theme, caption_size(text_, size_), theme.position);
    style.width = 0.72 * size_.width;
    const std::string markup = plain_text(caption);
    bottom -= typesetter_->measure(markup, style).height;
    add(TextRole::caption, markup, style, edge, bottom);
    bottom = size_.height - 0.6 * edge;
  }
  if (text_.clock) {
    const TextStyle style =
        style_of(theme, clock_size(text_, size_), readable(theme.space_axes, theme.background));
    const std::string markup = clock_text(t, text_.time_scale);
    const TextBox box = typesetter_->measure(markup, style);
    add(TextRole::clock, markup, style, size_.width - edge - box.width, bottom - box.height);
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
    add_text(TextRole::note, markup, style, place.x + edge, y, page);
    page.placed.rooms.push_back({place.x + edge, y, place.x + edge + box.width, y + box.height});
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
  const double middle = badge.y + 0.5 * (badge.height - box.height);
  add_text(TextRole::note, markup, style, badge.x + pad, middle, page);
  page.placed.rooms.push_back(room_of(badge));
  return badge.bottom();
}

void Film::add_way_to_body(const FilmPanel& panel, const Vec2& way, double top, Page& page) const {
  const Theme& theme = panel.composer->scenery().theme;
  const double size = least_text_size(text_, size_);
  const TextStyle style = style_of(theme, size, theme.position);
  TextRoom frame = room_of(panel.place);
  frame.top = std::max(frame.top, top);
  frame = grown(frame, -0.3 * size, -0.3 * size);
  Chevron chevron = chevron_in(frame, way, kChevron * label_size(text_, panel.place, size_));
  // before text that stands at the edge
  const std::vector<TextRoom>& text = page.placed.rooms;
  const auto is_covered = [&] {
    const TextRoom room = chevron.room();
    return std::any_of(
        text.begin(), text.end(), [&](const TextRoom& other) { return overlap(room, other); });
  };
  while (is_covered() && (chevron.tip - frame.center()).dot(way) > 0.0)
    chevron.tip -= way;
  page.picture.stamps.push_back(stamp_of(chevron, style));
  page.placed.rooms.push_back(chevron.room());

  if (!panel.notes) return;
  const std::string markup = plain_text("the body is out of the picture");
  const TextBox box = typesetter_->measure(markup, style);
  const LabelWish wish{chevron.tip, -way, box.ink_width(), box.ink_height()};
  const Vec2 center = settled_at(wish, chevron.room().center(), {text, {}}, {}, frame, 0.3 * size);
  const TextRoom room = room_at(center, wish.width, wish.height);
  const Vec2 corner(room.left - box.ink_left, room.top - box.ink_top);
  page.placed.rooms.push_back(
      add_text(TextRole::note, markup, style, corner.x(), corner.y(), page));
}

Film::Layout Film::layout_of(const FilmPanel& panel,
                             const LabelView& view,
                             double top,
                             const std::vector<TextRoom>& text) const {
  const PixelBox& place = panel.place;
  const Theme& theme = panel.composer->scenery().theme;
  const Vec2 corner(place.x, place.y);
  Layout layout;
  layout.size = label_size(text_, place, size_);
  layout.moment.obstacles.text = text;
  std::vector<TextRoom>& marks = layout.moment.obstacles.marks;
  for (const TextRoom& mark : view.marks)
    marks.push_back(moved(mark, corner));
  for (const TextShaft& piece : view.curves)
    layout.moment.curves.push_back({corner + piece.from, corner + piece.tip});
  for (const Vec2& point : view.body)
    layout.moment.body.push_back(corner + point);
  std::map<std::string, int> count;
  for (const SeenLabel& label : view.labels) {
    const double size = std::max(label.size * layout.size, least_text_size(text_, size_));
    TextStyle style = style_of(theme, size, label.color);
    style.face = Face::math;
    style.halo /= label.size;  // that of small names is as wide
    const TextBox box = typesetter_->measure(label.markup, style);
    layout.moment.names.push_back(fmt::format("{} {}", label.markup, ++count[label.markup]));
    TextShaft shaft{corner + label.at, corner + label.at};
    if (label.of_arrow) {
      shaft.from = corner + label.from;
      shaft.tip = own_end(shaft, marks);
    }
    LabelWish wish{
        shaft.tip, label.away, box.ink_width(), box.ink_height(), corner + label.at - shaft.tip};
    if (label.circle) {
      wish.at = corner + label.circle->center;
      wish.to_tip = Vec2::Zero();
      wish.half_a = label.circle->half_a;
      wish.half_b = label.circle->half_b;
    }
    layout.moment.wishes.push_back(wish);
    layout.moment.shafts.push_back(shaft);
    layout.styles.push_back(style);
  }
  const double inset = 0.25 * layout.size;
  const TextRoom all = room_of(place);
  layout.frame = {
      all.left + inset, std::max(all.top, top) + inset, all.right - inset, all.bottom - inset};
  return layout;
}

LabelTracks Film::tracks_of(std::size_t index) const {
  const FilmPanel& panel = panels_[index];
  const Timeline& timeline = panel.composer->timeline();
  // when the panel begins, s of film
  const double begins = in_turn_ ? static_cast<double>(index) * turn() : 0.0;
  const double duration = timeline.film_duration();
  const double step = step_between_moments(duration);
  // text that keeps its place as long as the caption and the stamp are the same
  struct Text {
    std::vector<TextRoom> rooms;
    double top = 0.0;
  };
  std::map<std::string, Text> texts;
  const auto text_at = [&](double time) -> const Text& {
    const double t = timeline.motion_time(time);
    const std::string key = timeline.caption(time).value_or(text_.caption) + '\n' +
                            (panel.notes ? panel.notes(t).stamp : "");
    const auto [found, is_new] = texts.try_emplace(key);
    if (!is_new) return found->second;
    Page page;
    if (is_divided()) {
      add_bars(begins + time, page);
    } else {
      add_frame_text(begins + time, page);
    }
    found->second.top = add_notes(panel, t, page);
    found->second.rooms = page.placed.rooms;
    return found->second;
  };
  std::vector<LabelMoment> moments;
  Layout layout;
  for (double time = 0.0; time < duration + step; time += step) {
    const double now = std::min(time, duration);
    const Text& text = text_at(now);
    layout = layout_of(panel, panel.composer->label_view(now, panel.end), text.top, text.rooms);
    moments.push_back(layout.moment);
  }
  return {moments, layout.frame, layout.gap()};
}

void Film::add_labels(const FilmPanel& panel,
                      const LabelTracks& tracks,
                      const LabelView& view,
                      double film,
                      double top,
                      Page& page) const {
  const Layout layout = layout_of(panel, view, top, page.placed.rooms);
  const LabelMoment& moment = layout.moment;
  const double at = film / step_between_moments(panel.composer->timeline().film_duration());
  const std::vector<TextRoom>& marks = moment.obstacles.marks;
  page.placed.marks.insert(page.placed.marks.end(), marks.begin(), marks.end());

  std::vector<PlacedText> texts;
  std::vector<TextRoom> rooms;
  for (std::size_t i = 0; i < moment.wishes.size(); ++i) {
    const SeenLabel& label = view.labels[i];
    const LabelWish& wish = moment.wishes[i];
    const LabelPlace place = tracks.place(moment.names[i], wish, at);
    const Vec2 center =
        clear_center(wish, place.center, moment.obstacles.text, rooms, layout.frame);
    const TextRoom room = room_at(center, wish.width, wish.height);
    rooms.push_back(room);
    // what has to go farther is not seen there
    const double aside = (center - place.center).norm() / wish.height;
    const double seen_aside = std::clamp(1.5 - 3.0 * aside, 0.0, 1.0);
    PlacedText text{TextRole::label,
                    label.markup,
                    layout.styles[i],
                    room,
                    label.fade * std::min(place.opacity, seen_aside)};
    if (label.of_arrow) {
      text.whole_tip = wish.tip();
      const TextRoom all = room_of(panel.place);
      text.tip = visible_end(moment.shafts[i], all);
      // a name that still stands beside the tip, where another head comes over it, needs no line
      const bool by_tip = text.tip && distance(all, *text.whole_tip) == 0.0 &&
                          distance(room, *text.whole_tip) < distance(room, *text.tip);
      if (by_tip) text.tip = text.whole_tip;
      const double letter = capital_height(*typesetter_, layout.styles[i]);
      if (text.tip) text.leader = leader_to(*text.tip, room, letter);
    }
    if (text.leader) page.leaders.push_back(leader_stamp(text));
    texts.push_back(std::move(text));
  }
  for (PlacedText& text : texts) {
    const TextBox box = typesetter_->measure(text.markup, text.style);
    Stamp stamp = typesetter_->set(
        text.markup, text.style, text.room.left - box.ink_left, text.room.top - box.ink_top);
    stamp.opacity = text.opacity;
    page.picture.stamps.push_back(stamp);
    page.placed.rooms.push_back(text.room);
    page.placed.texts.push_back(std::move(text));
  }
}

}  // namespace polhode
