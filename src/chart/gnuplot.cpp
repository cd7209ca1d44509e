// SPDX-License-Identifier: MIT
#include "chart/gnuplot.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "base/system/child_process.h"

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
    case PlotFormat::overlay:
      return fmt::format("pngcairo enhanced transparent size {},{} font 'Inter,10'", width, height);
    case PlotFormat::pdf:
      return fmt::format("pdfcairo enhanced size {:.3f}in,{:.3f}in font '{},8'",
                         width / kPixelsPerInch,
                         height / kPixelsPerInch,
                         kFont);
  }
  return {};
}

std::string first_line(const std::string& text) {
  const std::size_t start = text.find_first_not_of(" \n\t");
  if (start == std::string::npos) return "no word why";
  return text.substr(start, text.find('\n', start) - start);
}

}  // namespace

std::string gnuplot_text(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\'') {
      safe += "\u2019";  // as printers set it
    } else if (byte < 0x20 || byte == 0x7f) {
      safe += ' ';
    } else {
      safe += std::string_view("`\\\"$%@").find(c) == std::string_view::npos ? c : '.';
    }
  }
  return safe + "' noenhanced";
}

std::string gnuplot_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : "NaN";
}

std::string gnuplot_version() {
  try {
    const ChildResult result = run_child({"gnuplot", "--version"}, "");
    return result.status == 0 ? first_line(result.out) : "";
  } catch (const Error& error) {
    if (error.fault() == Fault::interrupted) throw;
    return "";
  }
}

void require_gnuplot() {
  if (!gnuplot_version().empty()) return;
  throw environment_error(
      "gnuplot, which draws the charts, is not installed; install gnuplot-nox, or run "
      "tools/install-dependencies");
}

std::string draw_with_gnuplot(const std::string& script, PlotFormat format, int width, int height) {
  const std::string whole = "set encoding utf8\nset terminal " + terminal(format, width, height) +
                            "\n" + script + "\nunset output\n";
  const ChildResult result = run_child({"gnuplot", "--default-settings", "-"}, whole);
  // a script of ours has no errors: what is said is a missing terminal or font
  if (result.status != 0 || result.out.empty()) {
    throw environment_error("gnuplot did not draw: {}", first_line(result.err));
  }
  return result.out;
}

}  // namespace polhode
