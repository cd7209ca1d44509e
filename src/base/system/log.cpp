// SPDX-License-Identifier: MIT
#include "base/system/log.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>

#include "base/one_line.h"

namespace polhode {
namespace {

// the message, in which names of others are
class Words final : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message,
              const std::tm&,
              spdlog::memory_buf_t& out) override {
    const std::string words = one_line({message.payload.data(), message.payload.size()});
    out.append(words.data(), words.data() + words.size());
  }
  std::unique_ptr<custom_flag_formatter> clone() const override {
    return std::make_unique<Words>();
  }
};

// where warnings_of() keeps the warnings of this thread; null: they are written
thread_local std::vector<std::string>* kept = nullptr;

class KeepingSink final : public spdlog::sinks::stderr_color_sink_mt {
 public:
  void log(const spdlog::details::log_msg& message) override {
    if (kept == nullptr || message.level != spdlog::level::warn) {
      spdlog::sinks::stderr_color_sink_mt::log(message);
      return;
    }
    std::string words(message.payload.data(), message.payload.size());
    if (std::find(kept->begin(), kept->end(), words) == kept->end())
      kept->push_back(std::move(words));
  }
};

}  // namespace

void start_log(bool verbose) {
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("polhode", std::make_shared<KeepingSink>()));
  auto form = std::make_unique<spdlog::pattern_formatter>();
  form->add_flag<Words>('w').set_pattern("polhode: %^%l%$: %w");
  spdlog::set_formatter(std::move(form));
  spdlog::set_level(verbose ? spdlog::level::info : spdlog::level::warn);
}

std::vector<std::string> warnings_of(const std::function<void()>& work) {
  std::vector<std::string> warnings;
  std::vector<std::string>* const before = std::exchange(kept, &warnings);
  try {
    work();
  } catch (...) {
    kept = before;
    for (const std::string& words : warnings)
      spdlog::warn("{}", words);
    throw;
  }
  kept = before;
  return warnings;
}

}  // namespace polhode
