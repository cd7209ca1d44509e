// SPDX-License-Identifier: MIT
// Text as small pictures, through Pango and Cairo, which only this library includes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "image/sprite.h"

namespace polhode {

using Rgb = std::array<std::uint8_t, 3>;

// Sans is for words and numbers (digits of equal width), math for symbols.
enum class Face { sans, math };

struct TextStyle {
  Face face = Face::sans;
  double size = 20.0;  // of the font, pixels
  Rgb color{255, 255, 255};
  bool bold = false;
  double halo = 0.0;  // width of a rim around the letters, pixels; 0: none
  Rgb halo_color{0, 0, 0};
  double width = 0.0;  // lines are broken at this width, pixels; 0: never
  bool centered = false;
};

// Sizes of a set text, pixels. The ink is where the letters are, rim not counted, from the upper
// left corner of the text.
struct TextBox {
  double width = 0.0;
  double height = 0.0;
  double ink_left = 0.0, ink_top = 0.0, ink_right = 0.0, ink_bottom = 0.0;

  double ink_width() const { return ink_right - ink_left; }
  double ink_height() const { return ink_bottom - ink_top; }
};

// The libraries that set text, as found at run time: "Pango 1.50.12, Cairo 1.16.0".
std::string text_libraries();

// Plain text as markup: nothing in it is taken for a tag.
std::string plain_text(std::string_view text);

// Sets text. May be used from any thread; keeps what it has set. Markup is Pango's: <b>, <i>,
// <span …>. The same text, style and place give the same pixels with the same fonts, whatever was
// set before.
class Typesetter {
 public:
  Typesetter();
  ~Typesetter();
  Typesetter(const Typesetter&) = delete;
  Typesetter& operator=(const Typesetter&) = delete;

  TextBox measure(const std::string& markup, const TextStyle& style) const;
  // The text with its upper left corner at (x, y) of the picture, to a quarter of a pixel.
  Stamp set(const std::string& markup, const TextStyle& style, double x, double y) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// A font that is wanted, and whether it is there.
struct FontFound {
  std::string wanted;   // family
  std::string package;  // Debian's
  std::string found;    // the family that serves instead when it differs from the wanted one
  bool there = false;
};
std::vector<FontFound> examine_fonts();

}  // namespace polhode
