// SPDX-License-Identifier: MIT
#include "chart/gnuplot.h"

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"

namespace polhode {
namespace {

constexpr const char* kFont = "DejaVu Sans";

std::string terminal(PlotFormat format, int width, int height) {
  constexpr double kPixelsPerInch = 96.0;
  switch (format) {
    case PlotFormat::svg:
      return fmt::format(
          "svg enhanced size {},{} font '{},12' background rgb 'white'", width, height, kFont);
    case PlotFormat::png:
      return fmt::format("pngcairo enhanced size {},{} font '{},10'", width, height, kFont);
    case PlotFormat::pdf:
      return fmt::format("pdfcairo enhanced size {:.3f}in,{:.3f}in font '{},8'",
                         width / kPixelsPerInch,
                         height / kPixelsPerInch,
                         kFont);
  }
  return {};
}

// what files of the format begin with; of text, what they hold
bool is_picture(const std::string& bytes, PlotFormat format) {
  switch (format) {
    case PlotFormat::svg:
      return bytes.find("<svg") != std::string::npos;
    case PlotFormat::png:
      return bytes.starts_with("\x89PNG\r\n\x1a\n");
    case PlotFormat::pdf:
      return bytes.starts_with("%PDF-");
  }
  return false;
}

// Maps are pictures of a pixel for each cell, between which readers of SVG would make colours up.
std::string with_sharp_cells(std::string svg) {
  constexpr std::string_view kImage = "<image ", kSharp = "image-rendering='pixelated' ";
  for (std::size_t at = 0; (at = svg.find(kImage, at)) != std::string::npos;) {
    at += kImage.size();
    svg.insert(at, kSharp);
  }
  return svg;
}

}  // namespace

std::string gnuplot_text(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\'') {
      safe += "\u2019";  // as printers set it
    } else {
      safe += byte < 0x20 || byte == 0x7f ? ' ' : c;
    }
  }
  return safe + "' noenhanced";
}

std::string gnuplot_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : "NaN";
}

ProgramFound find_gnuplot() {
  return find_program("gnuplot");
}

void require_gnuplot() {
  require_program("gnuplot",
                  "the charts cannot be drawn",
                  "install gnuplot-nox, or run tools/install-dependencies");
}

std::string draw_with_gnuplot(const std::string& script, PlotFormat format, int width, int height) {
  // into a pipe: gnuplot does not say when a disk is full; not standard output: libraries may say
  // something there
  constexpr const char* kCommand = "exec gnuplot --default-settings - 3>&1 1>&2";
  const std::string whole = "set encoding utf8\nset terminal " + terminal(format, width, height) +
                            "\nset output '/dev/fd/3'\n" + script + "\nunset output\n";
  // GNUTERM is the terminal that it would open first, a window perhaps; PANGOCAIRO_BACKEND may ask
  // for one that has no letters
  const std::vector<std::string> words = {
      "env", "-u", "GNUTERM", "-u", "PANGOCAIRO_BACKEND", "sh", "-c", kCommand};
  ChildResult result = run_child(words, whole);
  // a script of ours has no errors: what is said is a missing terminal or font
  if (!ended_well(result)) {
    throw environment_error("the chart cannot be drawn: gnuplot {}", how_it_ended(result));
  }
  if (!is_picture(result.out, format))
    throw environment_error("the chart cannot be drawn: gnuplot wrote no picture");
  return format == PlotFormat::svg ? with_sharp_cells(std::move(result.out))
                                   : std::move(result.out);
}

}  // namespace polhode
