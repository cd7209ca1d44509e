// SPDX-License-Identifier: MIT
// Longer than most: all that calls Pango and Cairo is one implementation, so that no other file
// sees them.
#include "text/typesetter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <mutex>
#include <unordered_map>

#include <fmt/format.h>
#include <pango/pangocairo.h>

#include "base/check.h"
#include "base/error.h"
#include "base/system/console.h"
#include "base/system/log.h"
#include "base/system/unfinished.h"

namespace polhode {
namespace {

// The wanted family first; Pango goes on to the next where one is missing or has no such letter.
struct Wanted {
  Face face;
  const char* family;
  const char* package;
  const char* families;
};
constexpr std::array<Wanted, 2> kWanted = {{
    {Face::sans, "Inter", "fonts-inter", "Inter,Open Sans,DejaVu Sans,sans-serif"},
    {Face::math, "Nimbus Roman", "fonts-urw-base35", "Nimbus Roman,STIX,DejaVu Serif,serif"},
}};

constexpr std::size_t kMostKept = 2048;              // texts
constexpr std::size_t kMostPixelsKept = 16'000'000;  // of their sprites, up to 5 bytes each
constexpr int kPartsOfPixel = 4;

// The rim of letters is one stroke over the other. It wears off outwards, so that thin letters over
// light ground stand in a shade, not between two outlines.
struct Fringe {
  double width;  // parts of the halo's
  double opacity;
};
constexpr std::array<Fringe, 4> kFringes{{{2.2, 0.25}, {1.8, 0.3}, {1.4, 0.4}, {1.0, 1.0}}};

constexpr int kBesideStrip = 2;  // columns drawn at each side of a strip and cut off

template <class T>
struct Unref {
  void operator()(T* object) const { g_object_unref(object); }
};
template <class T>
using GObjectPtr = std::unique_ptr<T, Unref<T>>;

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyCairo {
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};
struct FreeFont {
  void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
};

double pixels(int pango_units) {
  return static_cast<double>(pango_units) / PANGO_SCALE;
}

// GLib writes lines of its own, and aborts where it cannot go on: without memory or threads.
GLogWriterOutput tell_in_our_words(GLogLevelFlags level,
                                   const GLogField* fields,
                                   gsize count,
                                   void* /*data*/) {
  std::string words;
  for (gsize i = 0; i < count; ++i) {
    if (std::strcmp(fields[i].key, "MESSAGE") == 0)
      words = static_cast<const char*>(fields[i].value);
  }
  if ((level & (G_LOG_FLAG_FATAL | G_LOG_LEVEL_ERROR)) != 0) {
    print_err(fmt::format("polhode: text cannot be set: {}\n", words));
    end_at_once(static_cast<int>(Fault::environment));
  }
  spdlog::info("{}", words);
  return G_LOG_WRITER_HANDLED;
}

// all that begins with Pango begins here
GObjectPtr<PangoFontMap> make_font_map() {
  // GLib takes a writer once only
  static const bool told = [] {
    g_log_set_writer_func(tell_in_our_words, nullptr, nullptr);
    return true;
  }();
  static_cast<void>(told);
  // the one that Fontconfig and FreeType feed, whatever PANGOCAIRO_BACKEND asks for
  PangoFontMap* fonts = pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT);
  if (fonts == nullptr) throw environment_error("Pango was built without FreeType");
  return GObjectPtr<PangoFontMap>(fonts);
}

GObjectPtr<PangoContext> make_context(PangoFontMap* fonts) {
  GObjectPtr<PangoContext> context(pango_font_map_create_context(fonts));
  // the same letters on every screen and at every place: no hinting, grey edges
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options(context.get(), options);
  cairo_font_options_destroy(options);
  pango_context_set_round_glyph_positions(context.get(), FALSE);
  return context;
}

std::unique_ptr<PangoFontDescription, FreeFont> font_of(const TextStyle& style) {
  std::unique_ptr<PangoFontDescription, FreeFont> font(pango_font_description_new());
  for (const Wanted& row : kWanted) {
    if (row.face == style.face) pango_font_description_set_family_static(font.get(), row.families);
  }
  pango_font_description_set_absolute_size(font.get(), style.size * PANGO_SCALE);
  if (style.bold) pango_font_description_set_weight(font.get(), PANGO_WEIGHT_SEMIBOLD);
  return font;
}

void set_source(cairo_t* cairo, const Rgb& color, double opacity = 1.0) {
  cairo_set_source_rgba(cairo, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, opacity);
}

// A letter of a line where it is set, in units of Pango from the corner of the text.
struct Letter {
  PangoFont* font;
  PangoGlyphInfo* glyph;
  int x, baseline;
  int ink_left, ink_right;  // equal: no ink
};

// Some columns of a text. The fonts are kept so that a key that names them stays theirs.
struct Strip {
  SpritePtr sprite;
  std::vector<GObjectPtr<PangoFont>> fonts;
};

// is there more to draw of a run than its letters side by side?
bool is_decorated(const PangoGlyphItem& run) {
  if (run.y_offset != 0 || run.start_x_offset != 0 || run.end_x_offset != 0) return true;
  for (const GSList* at = run.item->analysis.extra_attrs; at; at = at->next) {
    const PangoAttrType type = static_cast<PangoAttribute*>(at->data)->klass->type;
    if (type == PANGO_ATTR_UNDERLINE || type == PANGO_ATTR_OVERLINE ||
        type == PANGO_ATTR_STRIKETHROUGH || type == PANGO_ATTR_SHAPE) {
      return true;
    }
  }
  return false;
}

// The letters of unbroken text from left to right; none where they are not all that is drawn.
std::vector<Letter> letters_of(PangoLayout* layout) {
  if (pango_layout_get_line_count(layout) != 1) return {};
  const int baseline = pango_layout_get_baseline(layout);
  std::vector<Letter> letters;
  int x = 0;
  for (const GSList* at = pango_layout_get_line_readonly(layout, 0)->runs; at; at = at->next) {
    const auto* run = static_cast<PangoGlyphItem*>(at->data);
    if (is_decorated(*run)) return {};
    PangoFont* font = run->item->analysis.font;
    for (int i = 0; i < run->glyphs->num_glyphs; ++i) {
      PangoGlyphInfo* glyph = &run->glyphs->glyphs[i];
      Letter letter{font, glyph, x, baseline, 0, 0};
      if (glyph->glyph != PANGO_GLYPH_EMPTY) {
        PangoRectangle ink;
        pango_font_get_glyph_extents(font, glyph->glyph, &ink, nullptr);
        letter.ink_left = x + glyph->geometry.x_offset + ink.x;
        letter.ink_right = letter.ink_left + ink.width;
      }
      letters.push_back(letter);
      x += glyph->geometry.width;
    }
  }
  return letters;
}

// adds the outline of a letter to the path
void add_outline(cairo_t* cairo, const Letter& letter) {
  int cluster = 0;
  PangoGlyphString alone{1, letter.glyph, &cluster, 1};
  cairo_move_to(cairo, pixels(letter.x), pixels(letter.baseline));
  pango_cairo_glyph_string_path(cairo, letter.font, &alone);
}

// how far the rim reaches from the letters, pixels
double reach_of_rim(const TextStyle& style) {
  return kFringes.front().width * style.halo + 1.0;
}

// `count` columns of one sprite to another of the same height
void copy_columns(const Sprite& from, int first, int count, Sprite& to, int at) {
  const auto place = [](const Sprite& sprite, int x, int y) {
    return static_cast<std::ptrdiff_t>(y) * sprite.width + x;
  };
  CHECK(first + count <= from.width && at + count <= to.width && from.height == to.height);
  for (int y = 0; y < from.height; ++y) {
    std::copy_n(from.pixels.begin() + 4 * place(from, first, y),
                4 * static_cast<std::size_t>(count),
                to.pixels.begin() + 4 * place(to, at, y));
    if (from.rim.coverage.empty()) continue;
    std::copy_n(from.rim.coverage.begin() + place(from, first, y),
                count,
                to.rim.coverage.begin() + place(to, at, y));
  }
}

// a set text with its place in the picture still open, up to the part of a pixel
struct Set {
  SpritePtr sprite;
  int x = 0, y = 0;  // of the sprite from the whole pixel of the text's corner
};

}  // namespace

class Typesetter::Implementation {
 public:
  int missing_letters(const std::string& markup) {
    const std::lock_guard lock(mutex_);
    return pango_layout_get_unknown_glyphs_count(layout(markup, {}).get());
  }

  TextBox measure(const std::string& markup, const TextStyle& style) {
    const std::lock_guard lock(mutex_);
    const std::string key = key_of(markup, style);
    const auto known = boxes_.find(key);
    if (known != boxes_.end()) return known->second;
    if (boxes_.size() >= kMostKept) boxes_.clear();
    return boxes_.emplace(key, box_of(layout(markup, style).get())).first->second;
  }

  Stamp set(const std::string& markup, const TextStyle& style, double x, double y) {
    const double left = std::round(x * kPartsOfPixel) / kPartsOfPixel;
    const double top = std::round(y * kPartsOfPixel) / kPartsOfPixel;
    const std::string key = fmt::format(
        "{}\n{} {}", key_of(markup, style), left - std::floor(left), top - std::floor(top));
    const std::lock_guard lock(mutex_);
    auto known = set_.find(key);
    if (known == set_.end()) {
      const Set made = draw(markup, style, left - std::floor(left), top - std::floor(top));
      make_room(set_, pixels_set_, *made.sprite);
      known = set_.emplace(key, made).first;
    }
    const Set& it = known->second;
    return {it.sprite,
            static_cast<int>(std::floor(left)) + it.x,
            static_cast<int>(std::floor(top)) + it.y};
  }

 private:
  // Forgets all that was kept if there is no room for one more.
  template <class Kept>
  static void make_room(Kept& kept, std::size_t& pixels, const Sprite& one) {
    const auto more = static_cast<std::size_t>(one.width) * static_cast<std::size_t>(one.height);
    if (kept.size() >= kMostKept || pixels + more > kMostPixelsKept) {
      kept.clear();
      pixels = 0;
    }
    pixels += more;
  }

  static std::string key_of(const std::string& markup, const TextStyle& s) {
    return fmt::format("{}\n{} {} {} {} {} {} {} {}",
                       markup,
                       static_cast<int>(s.face),
                       s.size,
                       fmt::join(s.color, ","),
                       s.bold,
                       s.halo,
                       fmt::join(s.halo_color, ","),
                       s.width,
                       s.centered);
  }

  // Pango starts threads with its first fonts, and fork() copies only the calling thread: so fonts
  // are opened with the first text, not before
  void open_fonts() {
    if (fonts_ != nullptr) return;
    fonts_ = make_font_map();
    context_ = make_context(fonts_.get());
    // sizes are in pixels
    pango_cairo_font_map_set_resolution(PANGO_CAIRO_FONT_MAP(fonts_.get()), 72.0);
  }

  GObjectPtr<PangoLayout> layout(const std::string& markup, const TextStyle& style) {
    open_fonts();
    GObjectPtr<PangoLayout> layout(pango_layout_new(context_.get()));
    pango_layout_set_font_description(layout.get(), font_of(style).get());
    if (style.width > 0.0) {
      pango_layout_set_width(layout.get(), static_cast<int>(style.width * PANGO_SCALE));
      pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
    }
    if (style.centered) pango_layout_set_alignment(layout.get(), PANGO_ALIGN_CENTER);
    // digits of equal width, so that a clock stands still
    const std::string all = style.face == Face::sans
                                ? fmt::format("<span font_features='tnum'>{}</span>", markup)
                                : markup;
    pango_layout_set_markup(layout.get(), all.c_str(), static_cast<int>(all.size()));
    return layout;
  }

  static TextBox box_of(PangoLayout* layout) {
    PangoRectangle ink;
    PangoRectangle logical;
    pango_layout_get_extents(layout, &ink, &logical);
    // centred lines start right of the corner; the box is as wide as they are allowed to be
    return {pixels(logical.x + logical.width),
            pixels(logical.height),
            pixels(ink.x),
            pixels(ink.y),
            pixels(ink.x + ink.width),
            pixels(ink.y + ink.height)};
  }

  Set draw(const std::string& markup, const TextStyle& style, double part_x, double part_y) {
    const GObjectPtr<PangoLayout> text = layout(markup, style);
    const TextBox box = box_of(text.get());
    const double rim = reach_of_rim(style);
    const int left = static_cast<int>(std::floor(box.ink_left + part_x - rim));
    const int top = static_cast<int>(std::floor(box.ink_top + part_y - rim));
    const int right = static_cast<int>(std::ceil(box.ink_right + part_x + rim));
    const int bottom = static_cast<int>(std::ceil(box.ink_bottom + part_y + rim));
    const int width = std::max(1, right - left);
    const int height = std::max(1, bottom - top);

    // what is never broken is put together from strips that are kept: of a clock, only the digits
    // that are new beside their neighbours are drawn
    if (style.width <= 0.0) {
      const std::vector<Letter> letters = letters_of(text.get());
      if (!letters.empty()) {
        return {in_strips(letters, style, part_x - left, part_y - top, width, height), left, top};
      }
    }
    const SpritePtr whole =
        painted(style, part_x - left, part_y - top, width, height, [&](cairo_t* cairo) {
          pango_cairo_layout_path(cairo, text.get());
        });
    return {whole, left, top};
  }

  // A text from one strip per letter, its corner at (x, y). Cairo looks at 15 lines in a row of
  // pixels unless nothing turns or crosses in all of it, so that edges may differ from those of a
  // text drawn whole by a 15th.
  SpritePtr in_strips(const std::vector<Letter>& letters,
                      const TextStyle& style,
                      double x,
                      double y,
                      int width,
                      int height) {
    auto sprite = std::make_shared<Sprite>(width, height);
    if (style.halo > 0.0) sprite->rim = rim_of(style, width, height);
    int first = 0;
    for (std::size_t i = 0; i < letters.size(); ++i) {
      const bool is_last = i + 1 == letters.size();
      // blanks at the end stand beyond the last ink
      const int end =
          is_last ? width : std::min(width, static_cast<int>(x + pixels(letters[i + 1].x)));
      if (end <= first) continue;
      const SpritePtr strip = strip_of(letters, style, x - first, y, end - first, height);
      if (strip) copy_columns(*strip, kBesideStrip, end - first, *sprite, first);
      first = end;
    }
    return sprite;
  }

  // The columns 0 to `width` and those beside them, with all letters that reach there; none
  // without.
  SpritePtr strip_of(const std::vector<Letter>& letters,
                     const TextStyle& style,
                     double x,
                     double y,
                     int width,
                     int height) {
    const double rim = reach_of_rim(style);
    std::vector<Letter> reach;
    std::string key = fmt::format("{} {} {} {}", key_of({}, style), y, width, height);
    for (const Letter& letter : letters) {
      const bool inside = letter.ink_left < letter.ink_right &&
                          x + pixels(letter.ink_left) - rim < width + kBesideStrip &&
                          x + pixels(letter.ink_right) + rim > -kBesideStrip;
      if (!inside) continue;
      reach.push_back(letter);
      const PangoGlyphGeometry& moved = letter.glyph->geometry;
      fmt::format_to(std::back_inserter(key),
                     "\n{} {} {} {} {} {}",
                     fmt::ptr(letter.font),
                     letter.glyph->glyph,
                     x + pixels(letter.x),
                     letter.baseline,
                     moved.x_offset,
                     moved.y_offset);
    }
    if (reach.empty()) return nullptr;
    const auto known = strips_.find(key);
    if (known != strips_.end()) return known->second.sprite;
    Strip made;
    made.sprite =
        painted(style, x + kBesideStrip, y, width + 2 * kBesideStrip, height, [&](cairo_t* cairo) {
          for (const Letter& letter : reach)
            add_outline(cairo, letter);
        });
    for (const Letter& letter : reach)
      made.fonts.emplace_back(PANGO_FONT(g_object_ref(letter.font)));
    make_room(strips_, pixels_of_strips_, *made.sprite);
    return strips_.emplace(key, std::move(made)).first->second.sprite;
  }

  // Curves as chords: Cairo leaves holes where it strokes bends that are narrower than the pen.
  static void flatten_path(cairo_t* cairo) {
    cairo_path_t* chords = cairo_copy_path_flat(cairo);
    cairo_new_path(cairo);
    cairo_append_path(cairo, chords);
    cairo_path_destroy(chords);
  }

  // Letters as filled outlines, with their rim; glyphs would be put on whole pixels.
  template <class AddPath>
  static SpritePtr painted(
      const TextStyle& style, double x, double y, int width, int height, const AddPath& add_path) {
    const std::unique_ptr<cairo_surface_t, DestroySurface> surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
    const std::unique_ptr<cairo_t, DestroyCairo> cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), x, y);
    add_path(cairo.get());
    Rim rim;
    if (style.halo > 0.0) {
      flatten_path(cairo.get());
      cairo_set_line_join(cairo.get(), CAIRO_LINE_JOIN_ROUND);
      for (const Fringe& fringe : kFringes) {
        set_source(cairo.get(), style.halo_color, fringe.opacity);
        cairo_set_line_width(cairo.get(), 2.0 * fringe.width * style.halo);
        cairo_stroke_preserve(cairo.get());
      }
      rim = rim_of(style, width, height);
      read_pixels(surface.get(), [&](std::size_t at, std::uint32_t pixel) {
        rim.coverage[at] = static_cast<std::uint8_t>(pixel >> 24);
      });
      cairo_set_operator(cairo.get(), CAIRO_OPERATOR_CLEAR);
      cairo_paint(cairo.get());
      cairo_set_operator(cairo.get(), CAIRO_OPERATOR_OVER);
    }
    set_source(cairo.get(), style.color);
    cairo_fill(cairo.get());
    if (cairo_status(cairo.get()) != CAIRO_STATUS_SUCCESS) {
      throw environment_error("text cannot be drawn: {}",
                              cairo_status_to_string(cairo_status(cairo.get())));
    }
    auto sprite = std::make_shared<Sprite>(width, height);
    read_pixels(surface.get(), [&](std::size_t at, std::uint32_t pixel) {
      std::uint8_t* to = sprite->pixels.data() + 4 * at;
      to[0] = static_cast<std::uint8_t>(pixel >> 16);
      to[1] = static_cast<std::uint8_t>(pixel >> 8);
      to[2] = static_cast<std::uint8_t>(pixel);
      to[3] = static_cast<std::uint8_t>(pixel >> 24);
    });
    sprite->rim = std::move(rim);
    return sprite;
  }

  // without coverage yet
  static Rim rim_of(const TextStyle& style, int width, int height) {
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {style.halo_color, style.color, std::vector<std::uint8_t>(pixels)};
  }

  // Calls with each pixel of the surface, counted in rows; Cairo keeps one as a 32-bit number,
  // alpha highest.
  template <class Call>
  static void read_pixels(cairo_surface_t* surface, const Call& call) {
    cairo_surface_flush(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    const auto width = static_cast<std::size_t>(cairo_image_surface_get_width(surface));
    const auto height = static_cast<std::size_t>(cairo_image_surface_get_height(surface));
    const unsigned char* data = cairo_image_surface_get_data(surface);
    for (std::size_t y = 0; y < height; ++y) {
      const auto* row = reinterpret_cast<const std::uint32_t*>(data + stride * y);
      for (std::size_t x = 0; x < width; ++x)
        call(y * width + x, row[x]);
    }
  }

  std::mutex mutex_;
  GObjectPtr<PangoFontMap> fonts_;
  GObjectPtr<PangoContext> context_;
  std::unordered_map<std::string, TextBox> boxes_;
  std::unordered_map<std::string, Set> set_;
  std::size_t pixels_set_ = 0;
  std::unordered_map<std::string, Strip> strips_;
  std::size_t pixels_of_strips_ = 0;
};

Typesetter::Typesetter() : implementation_(std::make_unique<Implementation>()) {}

Typesetter::~Typesetter() = default;

int Typesetter::missing_letters(const std::string& markup) const {
  return implementation_->missing_letters(markup);
}

TextBox Typesetter::measure(const std::string& markup, const TextStyle& style) const {
  return implementation_->measure(markup, style);
}

Stamp Typesetter::set(const std::string& markup, const TextStyle& style, double x, double y) const {
  return implementation_->set(markup, style, x, y);
}

std::string text_libraries() {
  return fmt::format("Pango {}, Cairo {}", pango_version_string(), cairo_version_string());
}

std::vector<FontFound> examine_fonts() {
  const GObjectPtr<PangoFontMap> fonts = make_font_map();
  const GObjectPtr<PangoContext> context = make_context(fonts.get());
  std::vector<FontFound> list;
  for (const Wanted& row : kWanted) {
    TextStyle style;
    style.face = row.face;
    const GObjectPtr<PangoFont> font(pango_context_load_font(context.get(), font_of(style).get()));
    FontFound found{row.family, row.package, {}, false};
    if (font) {
      const std::unique_ptr<PangoFontDescription, FreeFont> is(pango_font_describe(font.get()));
      found.found = pango_font_description_get_family(is.get());
    }
    found.there = found.found == found.wanted;
    const GObjectPtr<PangoLayout> digit(pango_layout_new(context.get()));
    pango_layout_set_font_description(digit.get(), font_of(style).get());
    pango_layout_set_text(digit.get(), "0", -1);
    found.damaged = pango_layout_get_unknown_glyphs_count(digit.get()) > 0;
    list.push_back(found);
  }
  return list;
}

}  // namespace polhode
