// SPDX-License-Identifier: MIT
// What is logged while something is done.
#pragma once

#include <memory>
#include <sstream>
#include <string>

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

namespace polhode::test {

// The lines that `work` logs.
template <class Work>
std::string logged_by(const Work& work) {
  std::ostringstream text;
  const std::shared_ptr<spdlog::logger> before = spdlog::default_logger();
  spdlog::set_default_logger(std::make_shared<spdlog::logger>(
      "test", std::make_shared<spdlog::sinks::ostream_sink_st>(text)));
  work();
  spdlog::set_default_logger(before);
  return text.str();
}

}  // namespace polhode::test
