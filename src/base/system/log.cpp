// SPDX-License-Identifier: MIT
#include "base/system/log.h"

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

}  // namespace

void start_log(bool verbose) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("polhode"));
  auto form = std::make_unique<spdlog::pattern_formatter>();
  form->add_flag<Words>('w').set_pattern("polhode: %^%l%$: %w");
  spdlog::set_formatter(std::move(form));
  spdlog::set_level(verbose ? spdlog::level::info : spdlog::level::warn);
}

}  // namespace polhode
