// SPDX-License-Identifier: MIT
#include "app/version_text.h"

#include <fmt/format.h>

#include "base/version.h"
#include "text/typesetter.h"
#include "video/film_sink.h"

namespace polhode {

std::string version_text(const std::string& commit) {
  return fmt::format(
      "polhode {}{}\n"
      "compiled by GCC {} with {}\n"
      "running with FFmpeg {} ({}), {}\n"
      "OpenGL is opened when it is needed: `polhode doctor` names it.",
      program_version(),
      commit.empty() ? "" : fmt::format(" (commit {})", commit),
      __VERSION__,
      POLHODE_HEADERS,
      libav_version(),
      libav_parts(),
      text_libraries());
}

}  // namespace polhode
