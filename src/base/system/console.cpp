// SPDX-License-Identifier: MIT
#include "base/system/console.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include <sys/ioctl.h>

#include "base/error.h"

namespace polhode {
namespace {

// whether all of it is written, and flushed
bool goes_out(std::string_view bytes) {
  return std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() &&
         std::fflush(stdout) == 0;
}

}  // namespace

void guard_standard_streams() {
  // open() takes the lowest free number, which is the closed stream's own; opened for the wrong
  // direction, so that its use fails as it would have
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

void write_out(std::string_view bytes) {
  if (errno = 0; goes_out(bytes)) return;
  const int why = errno;
  throw environment_error(
      "cannot write to standard output ({})",
      why == EPIPE ? "the program that reads it has ended" : std::strerror(why));
}

void print_out(std::string_view text) {
  if (errno = 0; goes_out(text) || errno == EPIPE) return;
  throw environment_error("cannot write to standard output ({})", std::strerror(errno));
}

void print_err(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

std::size_t terminal_columns() {
  winsize size = {};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace polhode
