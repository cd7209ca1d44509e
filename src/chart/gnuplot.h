// SPDX-License-Identifier: MIT
// Runs gnuplot, which draws all charts and plots.
#pragma once

#include <string>

namespace polhode {

// Text as a quoted string of a gnuplot script, without gnuplot's markup for superscripts. Control
// characters and characters with a special meaning to gnuplot or its terminals are replaced, so any
// text is safe.
std::string gnuplot_text(const std::string& text);

// A number for gnuplot, with 17 digits; "NaN" if it is not finite.
std::string gnuplot_number(double value);

// "gnuplot 5.4 patchlevel 4"; empty if gnuplot is not installed.
std::string gnuplot_version();

// Throws Error (environment), with what to install, if gnuplot is missing. To be called before long
// work.
void require_gnuplot();

// overlay: a PNG with a transparent background, in the font of the text in films.
enum class PlotFormat { svg, png, pdf, overlay };

// Runs a script and returns the picture file as bytes; width and height in pixels. The user's own
// gnuplot settings are not read. Throws Error (environment) if gnuplot is missing or fails.
std::string draw_with_gnuplot(const std::string& script, PlotFormat format, int width, int height);

}  // namespace polhode
