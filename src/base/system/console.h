// SPDX-License-Identifier: MIT
// Standard output carries data and must not lose any; standard error carries words and never stops
// the work.
#pragma once

#include <string_view>

namespace polhode {

// Fills closed standard streams with streams that refuse, so that no file opened later is mistaken
// for one of them. Called once, by main, before anything is opened.
void guard_standard_streams();

// Writes all of it. Throws Error (environment) when that fails, except that a reader who has closed
// the pipe (`polhode schema | head`) wants no more, which is no error.
void print_out(std::string_view text);

// Writes it if it can.
void print_err(std::string_view text);

}  // namespace polhode
