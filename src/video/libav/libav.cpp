// SPDX-License-Identifier: MIT
#include "video/libav/libav.h"

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include "base/system/interrupt.h"
#include "base/system/log.h"

namespace polhode {
namespace {

void log_libav(void*, int level, const char* format, va_list arguments) {
  if (level > AV_LOG_WARNING) return;
  char text[512];
  std::vsnprintf(text, sizeof text, format, arguments);
  std::string line = text;
  while (!line.empty() && line.back() == '\n') {
    line.pop_back();
  }
  if (!line.empty()) spdlog::info("ffmpeg: {}", line);
}

}  // namespace

void LibavOptions::set(const char* key, const std::string& value) {
  av_dict_set(&entries_, key, value.c_str(), 0);
}

void LibavOptions::refuse_leftovers(const std::string& who) const {
  const AVDictionaryEntry* left = av_dict_get(entries_, "", nullptr, AV_DICT_IGNORE_SUFFIX);
  if (left != nullptr) throw environment_error("{} does not know the option '{}'", who, left->key);
}

std::string libav_words(int code) {
  if (code == AVERROR(EPIPE)) return "the program that reads it has ended";
  char words[AV_ERROR_MAX_STRING_SIZE] = {};
  av_strerror(code, words, sizeof words);
  return words;
}

int check_libav(int code, const std::string& what) {
  if (code >= 0) return code;
  if (code == AVERROR_EXIT) stop_if_interrupted();
  throw environment_error("{}: {}", what, libav_words(code));
}

void quieten_libav() {
  av_log_set_callback(log_libav);
}

}  // namespace polhode
