// SPDX-License-Identifier: MIT
// Runs gnuplot, which draws all charts.
#pragma once

#include <string>

namespace polhode {

// Text as a string of a gnuplot script, without its marks for superscripts and the like. Whatever
// it is, it stays text: control characters and what gnuplot or its terminals read as more than a
// character are replaced.
std::string gnuplot_text(const std::string& text);

// A number as gnuplot reads it, 17 digits; NaN for what is not known.
std::string gnuplot_number(double value);

// "gnuplot 5.4 patchlevel 4"; empty when there is none.
std::string gnuplot_version();

// Throws Error (environment) when there is none: before work, not after it.
void require_gnuplot();

// overlay: a PNG without ground, in the font of the text in pictures
enum class PlotFormat { svg, png, pdf, overlay };

// The picture that a script draws, as the bytes of a file; `width` and `height` in pixels. Nothing
// of the user's own settings is read. Throws Error (environment) when gnuplot is missing or fails.
std::string draw_with_gnuplot(const std::string& script, PlotFormat format, int width, int height);

}  // namespace polhode
