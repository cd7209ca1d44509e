// SPDX-License-Identifier: MIT
// Runs gnuplot, which draws all charts and plots, and makes text and numbers safe for its scripts.
#pragma once

#include <string>

namespace polhode {

// Text as a quoted string of a gnuplot script, followed by the keyword `noenhanced`, so that
// gnuplot does not read _ and ^ as markup. Control characters and characters with a special meaning
// to gnuplot or its terminals are replaced, so any text is safe.
std::string gnuplot_text(const std::string& text);

// A number for gnuplot, with 17 digits; "NaN" if it is not finite.
std::string gnuplot_number(double value);

// The version of the installed gnuplot, such as "gnuplot 5.4 patchlevel 4"; empty if there is none
// or it cannot be run. Throws Error (interrupted).
std::string gnuplot_version();

// Throws Error (environment), with what to install, if gnuplot is missing, and (interrupted). Call
// it before long work whose result needs gnuplot.
void require_gnuplot();

// The picture format. `overlay` is a PNG with a transparent background, in the font of the text in
// films.
enum class PlotFormat { svg, png, pdf, overlay };

// Runs a script, which must not set terminal or output, and returns the bytes of the picture file.
// Width and height are in pixels; a PDF has 96 of them to the inch. The user's own gnuplot settings
// are not read. Thread-safe. Throws Error (environment) if gnuplot is missing or fails, and
// (interrupted).
std::string draw_with_gnuplot(const std::string& script, PlotFormat format, int width, int height);

}  // namespace polhode
