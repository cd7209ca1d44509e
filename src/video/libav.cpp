// SPDX-License-Identifier: MIT
#include "video/libav.h"

#include <cstdarg>
#include <cstdio>

#include "base/log.h"

namespace polhode::libav {
namespace {

void log_line(void*, int level, const char* format, va_list arguments) {
  if (level > AV_LOG_WARNING) return;
  char text[512];
  std::vsnprintf(text, sizeof text, format, arguments);
  std::string line = text;
  while (!line.empty() && line.back() == '\n')
    line.pop_back();
  if (!line.empty()) spdlog::info("ffmpeg: {}", line);
}

}  // namespace

std::string words(int code) {
  char text[AV_ERROR_MAX_STRING_SIZE] = {};
  av_strerror(code, text, sizeof text);
  return text;
}

int check(int code, const char* what) {
  if (code < 0) throw environment_error("{}: {}", what, words(code));
  return code;
}

void send_log() {
  av_log_set_callback(log_line);
}

}  // namespace polhode::libav
