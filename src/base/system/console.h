// SPDX-License-Identifier: MIT
// Standard output carries data: a failed write is an error. Standard error carries messages: a
// failed write is ignored.
#pragma once

#include <string_view>

namespace polhode {

// Replaces closed standard streams by ones that fail, so that no file opened later gets their
// descriptor. main calls it once, before it opens any file.
void guard_standard_streams();

// Writes the whole text to standard output. Throws Error (environment) if that fails. A reader that
// has closed the pipe (`polhode schema | head`) is not an error.
void print_out(std::string_view text);

// Writes the text to standard error; failures are ignored.
void print_err(std::string_view text);

}  // namespace polhode
