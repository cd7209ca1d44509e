// SPDX-License-Identifier: MIT
// Writes to the standard streams. Standard output carries data: a failed write is an error.
// Standard error carries messages: a failed write is ignored.
#pragma once

#include <cstddef>
#include <string_view>

namespace polhode {

// If the program was started with a standard stream closed, opens /dev/null in its place so that
// its use still fails. Otherwise a file opened later would get descriptor 0, 1 or 2 and receive
// messages. main() calls it once, before it opens any file.
void guard_standard_streams();

// Writes the whole text to standard output and flushes it. Throws Error (environment) if that
// fails. If the program that reads the pipe has exited (`polhode schema | head`), the rest of the
// text is dropped without an error.
void print_out(std::string_view text);

// The same for what is of no use if its end is missing, such as a film or a model: also throws if
// the program that reads the pipe has exited.
void write_out(std::string_view bytes);

// Writes the text to standard error and flushes it; failures are ignored.
void print_err(std::string_view text);

// How many columns the terminal has to which standard error is written; 0 if there is none or it
// does not tell.
std::size_t terminal_columns();

}  // namespace polhode
