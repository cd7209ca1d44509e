// SPDX-License-Identifier: MIT
#include "base/system/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>

namespace polhode {

void start_log(bool verbose) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("polhode"));
  spdlog::set_pattern("polhode: %^%l%$: %v");
  spdlog::set_level(verbose ? spdlog::level::info : spdlog::level::warn);
}

}  // namespace polhode
