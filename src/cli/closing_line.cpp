// SPDX-License-Identifier: MIT
#include "cli/closing_line.h"

#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "base/json.h"
#include "base/one_line.h"
#include "base/system/console.h"

namespace polhode {
namespace {

// three digits that count: 0.42, 12.3, 1234
std::string short_number(double value) {
  if (value >= 100.0) return fmt::format("{:.0f}", value);
  return fmt::format("{:.{}f}", value, value >= 10.0 ? 1 : 2);
}

// made by this run
double frames_per_second(const Made& made, double seconds) {
  return seconds > 0.0 ? (made.frames - made.from_earlier) / seconds : 0.0;
}

std::string frames_of(const Made& made) {
  std::string frames = fmt::format(
      "{} {}{}", made.frames, made.is_picture ? "picture" : "frame", made.frames == 1 ? "" : "s");
  if (made.parts > 0) {
    return fmt::format("{} of {} {}", frames, made.parts, made.parts == 1 ? "part" : "parts");
  }
  if (made.from_earlier == 0) return frames;
  if (made.from_earlier == made.frames) return frames + ", all of them from earlier runs,";
  return fmt::format("{}, {} of them from earlier runs,", frames, made.from_earlier);
}

}  // namespace

std::string closing_line(const Made& made, double seconds) {
  std::string line = fmt::format("{}: {} in {} s",
                                 made.output == "-" ? "standard output" : one_line(made.output),
                                 frames_of(made),
                                 short_number(seconds));
  if (!made.is_picture && made.from_earlier < made.frames)
    line += fmt::format(" ({} frames/s)", short_number(frames_per_second(made, seconds)));
  return line;
}

std::string closing_json(const Made& made, double seconds) {
  const Json line = {{"done", made.frames},
                     {"total", made.frames},
                     {"frames_per_s", std::round(100.0 * frames_per_second(made, seconds)) / 100.0},
                     {"seconds_left", 0.0},
                     {"limit", nullptr},
                     {"output", made.output},
                     {"frames", made.frames},
                     {"seconds", std::round(1000.0 * seconds) / 1000.0}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

int make_and_tell(const ProgressOptions& options, const std::function<Made()>& make) {
  const bool as_json = progress_of(options) == ProgressKind::json;
  const auto start = std::chrono::steady_clock::now();
  const Made made = make();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (options.quiet) return 0;
  print_err(as_json ? closing_json(made, seconds) + "\n"
                    : "polhode: " + closing_line(made, seconds) + "\n");
  return 0;
}

}  // namespace polhode
