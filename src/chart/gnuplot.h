// SPDX-License-Identifier: MIT
// Runs gnuplot, which draws all charts, and makes text and numbers safe for its scripts.
#pragma once

#include <string>

#include "base/system/child_process.h"

namespace polhode {

// Text as a quoted string of a gnuplot script, followed by the keyword `noenhanced`, so that
// gnuplot does not read _ and ^ as markup: in single quotes nothing else has a meaning. Apostrophes
// are those of printers, control characters blanks, so any text is safe.
std::string gnuplot_text(const std::string& text);

// A number for gnuplot, with 17 digits; "NaN" if it is not finite.
std::string gnuplot_number(double value);

// The gnuplot of this machine, with a version such as "gnuplot 5.4 patchlevel 4". Throws Error
// (interrupted).
ProgramFound find_gnuplot();

// Throws Error (environment), with the reason and what to install, if gnuplot does not run, and
// (interrupted). Call it before long work whose result needs gnuplot.
void require_gnuplot();

// The picture format.
enum class PlotFormat { svg, png, pdf };

// Runs a script, which must not set terminal or output, and returns the bytes of the picture file.
// Width and height are in pixels; a PDF has 96 of them to the inch. The user's own gnuplot settings
// are not read. Thread-safe. Throws Error (environment) if gnuplot is missing, fails or writes
// something else, and (interrupted).
std::string draw_with_gnuplot(const std::string& script, PlotFormat format, int width, int height);

}  // namespace polhode
