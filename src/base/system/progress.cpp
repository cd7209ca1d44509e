// SPDX-License-Identifier: MIT
#include "base/system/progress.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest.h"
#include "base/system/console.h"
#include "base/utf8.h"

namespace polhode {
namespace {

// a bar is for people at a terminal
ProgressKind settled(ProgressKind kind) {
  if (kind != ProgressKind::automatic) return kind;
  return isatty(STDERR_FILENO) != 0 ? ProgressKind::bar : ProgressKind::none;
}

constexpr std::chrono::milliseconds kBetweenLines{100};
constexpr std::chrono::seconds kAWhile{1};  // that nobody minds waiting

std::string doing(const std::string& words) {
  return fmt::format("{{\"doing\":\"{}\"}}\n", words);
}

// of a terminal, so many columns from its beginning on
void clear_line(std::size_t columns) {
  print_err(fmt::format("\r{: <{}}\r", "", columns));
}

// Draws a line of a terminal, cut to its width: the next one could not take the place of two.
// drawn: how many columns the line has that is there, and then this one.
void draw_line(std::string line, std::size_t& drawn) {
  if (const std::size_t width = terminal_columns(); width > 0 && line.size() >= width) {
    std::size_t end = width - 1;
    while (is_continuation(line, end))
      --end;
    line.resize(end);
  }
  print_err(fmt::format("\r{: <{}}", line, drawn));
  drawn = line.size();
}

// "[====    ] ", as wide as there is room before `words`; "" if there is next to none
std::string bar(int done, int total, const std::string& words) {
  constexpr std::size_t kMost = 30, kLeast = 5, kFrame = 4;  // cells; brackets and blanks
  std::size_t cells = kMost;
  if (const std::size_t width = terminal_columns(); width > 0) {
    const std::size_t taken = words.size() + kFrame;
    cells = std::min(cells, width - std::min(width, taken));
  }
  if (cells < kLeast) return "";
  const double part = total > 0 ? std::clamp(static_cast<double>(done) / total, 0.0, 1.0) : 1.0;
  const auto full = static_cast<std::size_t>(part * static_cast<double>(cells));
  return fmt::format("[{:=<{}}{: <{}}] ", "", full, "", cells - full);
}

}  // namespace

const std::vector<std::string>& progress_names() {
  static const std::vector<std::string> names = {"auto", "bar", "json", "none"};
  return names;
}

ProgressKind parse_progress(const std::string& text) {
  if (text == "auto") return ProgressKind::automatic;
  if (text == "bar") return ProgressKind::bar;
  if (text == "json") return ProgressKind::json;
  if (text == "none") return ProgressKind::none;
  throw input_error("unknown kind of progress '{}'{}", text, suggestion(text, progress_names()))
      .at({{}, 0, "--progress"});
}

Progress::Progress(ProgressKind kind, int total, std::string things, int there)
    : kind_(settled(kind)),
      total_(total),
      things_(std::move(things)),
      there_(there),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
  // leave the terminal on a line of its own
  if (drawn_ > 0) print_err("\n");
}

void Progress::show(int done, const std::string& limit) {
  if (kind_ == ProgressKind::none) return;
  const Clock::time_point now = Clock::now();
  if (done + there_ < total_ && now - last_ < kBetweenLines) return;
  last_ = now;
  print(done, std::chrono::duration<double>(now - start_).count(), limit);
}

void Progress::print(int done_now, double seconds, const std::string& limit) {
  const double rate = seconds > 0.0 ? done_now / seconds : 0.0;
  const int done = done_now + there_;
  const double left = rate > 0.0 ? (total_ - done) / rate : 0.0;
  if (kind_ == ProgressKind::json) {
    print_err(fmt::format(
        "{{\"done\":{},\"total\":{},\"{}_per_s\":{:.2f},\"seconds_left\":{:.1f},\"limit\":{}}}\n",
        done,
        total_,
        things_,
        rate,
        left,
        limit.empty() ? "null" : fmt::format("\"{}\"", limit)));
    return;
  }
  const std::string words = fmt::format("{}/{} {}, {:.0f} {}/s, {:.0f} s left{}",
                                        done,
                                        total_,
                                        things_,
                                        rate,
                                        things_,
                                        left,
                                        limit.empty() ? "" : fmt::format(", {} limits", limit));
  draw_line(bar(done, total_, words) + words, drawn_);
}

Waiting::Waiting(ProgressKind kind) : kind_(settled(kind)), next_(Clock::now() + kAWhile) {}

Waiting::~Waiting() {
  if (drawn_ > 0) clear_line(drawn_);
}

void Waiting::show(const std::string& words) {
  if (kind_ == ProgressKind::none || Clock::now() < next_) return;
  next_ = Clock::now() + kBetweenLines;
  if (kind_ == ProgressKind::json) {
    print_err(doing(words));
    return;
  }
  draw_line(words, drawn_);
}

Busy::Busy(ProgressKind kind, std::string words) : kind_(settled(kind)), words_(std::move(words)) {
  if (kind_ == ProgressKind::none) return;
  thread_ = std::jthread([this](const std::stop_token& ended) { tell_after_a_while(ended); });
}

Busy::~Busy() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
  if (drawn_ > 0) clear_line(drawn_);
}

void Busy::tell_after_a_while(const std::stop_token& ended) {
  std::unique_lock lock(mutex_);
  is_ended_.wait_for(lock, ended, kAWhile, [] { return false; });
  if (ended.stop_requested()) return;
  if (kind_ == ProgressKind::bar) {
    draw_line(words_, drawn_);
  } else {
    print_err(doing(words_));
  }
}

}  // namespace polhode
