// SPDX-License-Identifier: MIT
#include "base/system/progress.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest.h"
#include "base/system/console.h"

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
  if (drawn_ && kind_ == ProgressKind::bar) print_err("\n");
}

void Progress::show(int done, const std::string& limit) {
  if (kind_ == ProgressKind::none) return;
  const Clock::time_point now = Clock::now();
  if (done + there_ < total_ && now - last_ < kBetweenLines) return;
  last_ = now;
  drawn_ = true;
  print(done, std::chrono::duration<double>(now - start_).count(), limit);
}

void Progress::print(int done_now, double seconds, const std::string& limit) const {
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
  constexpr int kCells = 30;
  const int full = total_ > 0 ? kCells * done / total_ : kCells;
  print_err(fmt::format("\r[{:=<{}}{: <{}}] {}/{} {}, {:.0f} {}/s, {:.0f} s left{}   ",
                        "",
                        full,
                        "",
                        kCells - full,
                        done,
                        total_,
                        things_,
                        rate,
                        things_,
                        left,
                        limit.empty() ? "" : fmt::format(", {} limits", limit)));
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
  print_err(fmt::format("\r{: <{}}", words, drawn_));
  drawn_ = std::max(drawn_, words.size());
}

Busy::Busy(ProgressKind kind, std::string words) : kind_(settled(kind)), words_(std::move(words)) {
  if (kind_ == ProgressKind::none) return;
  thread_ = std::jthread([this](const std::stop_token& ended) { tell_after_a_while(ended); });
}

Busy::~Busy() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
  if (drawn_) clear_line(words_.size());
}

void Busy::tell_after_a_while(const std::stop_token& ended) {
  std::unique_lock lock(mutex_);
  is_ended_.wait_for(lock, ended, kAWhile, [] { return false; });
  if (ended.stop_requested()) return;
  drawn_ = kind_ == ProgressKind::bar;
  print_err(drawn_ ? "\r" + words_ : doing(words_));
}

}  // namespace polhode
