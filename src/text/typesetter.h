// SPDX-License-Identifier: MIT
// Renders text to small pictures with Pango and Cairo, which only this library includes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "image/sprite.h"
#include "text/markup.h"

namespace polhode {

// Red, green and blue, sRGB-encoded.
using Rgb = std::array<std::uint8_t, 3>;

// A typeface: sans is for words and numbers (digits of equal width), math for symbols.
enum class Face { sans, math };

// Font, colour and layout of a text. Lines also break where the text contains a line break.
struct TextStyle {
  Face face = Face::sans;
  double size = 20.0;  // font size, pixels
  Rgb color{255, 255, 255};
  bool bold = false;
  double halo = 0.0;  // width of a rim around the letters, which wears off, pixels; 0: none
  Rgb halo_color{0, 0, 0};
  double width = 0.0;     // lines are wrapped at this width, pixels; 0: never
  bool centered = false;  // in `width`, or if that is 0 in the widest line; else left-aligned
};

// The extent of a text in pixels. width: from the left edge of the text to the right end of the
// line that reaches farthest (centred lines begin right of that edge). height: of all lines. Both
// include the space that the font leaves around letters. ink_* bound the letters without their
// outline, measured from the upper left corner of the text, x to the right, y down.
struct TextBox {
  double width = 0.0;
  double height = 0.0;
  double ink_left = 0.0, ink_top = 0.0, ink_right = 0.0, ink_bottom = 0.0;

  double ink_width() const { return ink_right - ink_left; }
  double ink_height() const { return ink_bottom - ink_top; }
};

// The versions of the libraries found at run time: "Pango 1.50.12, Cairo 1.16.0".
std::string text_libraries();

// Lays out and renders text, and caches the results. Thread-safe. `markup` is Pango's: <b>, <i>,
// <span …>; use plain_text() for text that is not markup. Markup that Pango cannot parse gives an
// empty text. With the same fonts, the same text, style and position always give the same pixels.
// The first text starts threads of Pango: call fork() before.
class Typesetter {
 public:
  Typesetter();
  ~Typesetter();
  Typesetter(const Typesetter&) = delete;
  Typesetter& operator=(const Typesetter&) = delete;

  // How many letters of the text no font has; boxes with their numbers stand for them.
  int missing_letters(const std::string& markup) const;
  // The extent of the text in this style.
  TextBox measure(const std::string& markup, const TextStyle& style) const;
  // The text as a stamp (image/sprite.h) with its upper left corner at (x, y) in pixels of the
  // picture, rounded to a quarter of a pixel. Throws Error (environment) if Cairo cannot render.
  Stamp set(const std::string& markup, const TextStyle& style, double x, double y) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// A font that the program uses, and whether it is installed.
struct FontFound {
  std::string wanted;    // family
  std::string package;   // Debian package that contains it
  std::string found;     // family that is used; another one if `wanted` is missing, "" if none is
  bool there = false;    // `wanted` is installed
  bool damaged = false;  // what is found has no digits: its file cannot be read
};
// All fonts that the program uses, for the command `doctor`. It opens fonts, which starts threads
// of Pango.
std::vector<FontFound> examine_fonts();

}  // namespace polhode
