// SPDX-License-Identifier: MIT
#include "text/typesetter.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <unordered_map>

#include <fmt/format.h>
#include <pango/pangocairo.h>

#include "base/error.h"

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

constexpr std::size_t kMostKept = 2048;
constexpr int kPartsOfPixel = 4;

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

void set_source(cairo_t* cairo, const Rgb& color) {
  cairo_set_source_rgb(cairo, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
}

// a set text with its place in the picture still open, up to the part of a pixel
struct Set {
  SpritePtr sprite;
  int x = 0, y = 0;  // of the sprite from the whole pixel of the text's corner
};

}  // namespace

class Typesetter::Implementation {
 public:
  Implementation() : fonts_(pango_cairo_font_map_new()), context_(make_context(fonts_.get())) {
    // sizes are in pixels
    pango_cairo_font_map_set_resolution(PANGO_CAIRO_FONT_MAP(fonts_.get()), 72.0);
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
      if (set_.size() >= kMostKept) set_.clear();
      const Set made = draw(markup, style, left - std::floor(left), top - std::floor(top));
      known = set_.emplace(key, made).first;
    }
    const Set& it = known->second;
    return {it.sprite,
            static_cast<int>(std::floor(left)) + it.x,
            static_cast<int>(std::floor(top)) + it.y};
  }

 private:
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

  GObjectPtr<PangoLayout> layout(const std::string& markup, const TextStyle& style) {
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
    const double rim = style.halo + 1.0;
    const int left = static_cast<int>(std::floor(box.ink_left + part_x - rim));
    const int top = static_cast<int>(std::floor(box.ink_top + part_y - rim));
    const int right = static_cast<int>(std::ceil(box.ink_right + part_x + rim));
    const int bottom = static_cast<int>(std::ceil(box.ink_bottom + part_y + rim));
    const int width = std::max(1, right - left);
    const int height = std::max(1, bottom - top);

    const std::unique_ptr<cairo_surface_t, DestroySurface> surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
    const std::unique_ptr<cairo_t, DestroyCairo> cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), part_x - left, part_y - top);
    // letters as filled outlines: glyphs would be put on whole pixels
    pango_cairo_layout_path(cairo.get(), text.get());
    if (style.halo > 0.0) {
      set_source(cairo.get(), style.halo_color);
      cairo_set_line_width(cairo.get(), 2.0 * style.halo);
      cairo_set_line_join(cairo.get(), CAIRO_LINE_JOIN_ROUND);
      cairo_stroke_preserve(cairo.get());
    }
    set_source(cairo.get(), style.color);
    cairo_fill(cairo.get());
    if (cairo_status(cairo.get()) != CAIRO_STATUS_SUCCESS) {
      throw environment_error("text cannot be drawn: {}",
                              cairo_status_to_string(cairo_status(cairo.get())));
    }
    cairo_surface_flush(surface.get());
    return {copy_of(surface.get()), left, top};
  }

  // Cairo keeps a pixel as one 32-bit number, alpha highest
  static SpritePtr copy_of(cairo_surface_t* surface) {
    auto sprite = std::make_shared<Sprite>(cairo_image_surface_get_width(surface),
                                           cairo_image_surface_get_height(surface));
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    const unsigned char* data = cairo_image_surface_get_data(surface);
    std::uint8_t* to = sprite->pixels.data();
    for (int y = 0; y < sprite->height; ++y) {
      const auto* row =
          reinterpret_cast<const std::uint32_t*>(data + stride * static_cast<std::size_t>(y));
      for (int x = 0; x < sprite->width; ++x, to += 4) {
        to[0] = static_cast<std::uint8_t>(row[x] >> 16);
        to[1] = static_cast<std::uint8_t>(row[x] >> 8);
        to[2] = static_cast<std::uint8_t>(row[x]);
        to[3] = static_cast<std::uint8_t>(row[x] >> 24);
      }
    }
    return sprite;
  }

  std::mutex mutex_;
  GObjectPtr<PangoFontMap> fonts_;
  GObjectPtr<PangoContext> context_;
  std::unordered_map<std::string, TextBox> boxes_;
  std::unordered_map<std::string, Set> set_;
};

Typesetter::Typesetter() : implementation_(std::make_unique<Implementation>()) {}

Typesetter::~Typesetter() = default;

TextBox Typesetter::measure(const std::string& markup, const TextStyle& style) const {
  return implementation_->measure(markup, style);
}

Stamp Typesetter::set(const std::string& markup, const TextStyle& style, double x, double y) const {
  return implementation_->set(markup, style, x, y);
}

std::string plain_text(std::string_view text) {
  const std::unique_ptr<gchar, decltype(&g_free)> escaped(
      g_markup_escape_text(text.data(), static_cast<gssize>(text.size())), &g_free);
  return escaped.get();
}

std::vector<FontFound> examine_fonts() {
  const GObjectPtr<PangoFontMap> fonts(pango_cairo_font_map_new());
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
    list.push_back(found);
  }
  return list;
}

}  // namespace polhode
