// SPDX-License-Identifier: MIT
#include "video/libav/libav.h"

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <vector>

#include "base/system/interrupt.h"
#include "base/system/log.h"
#include "base/system/system_error.h"

namespace polhode {
namespace {

// If `who` is a decoder that is watched, it has told of an error. Decoders with several threads
// have copies of their context.
void note_error(void* who) {
  if (who == nullptr || *static_cast<const AVClass* const*>(who) != avcodec_get_class()) return;
  void* told = static_cast<AVCodecContext*>(who)->opaque;
  if (told != nullptr) *static_cast<std::atomic<bool>*>(told) = true;
}

// libav calls this where no exception may pass, also when memory lacks.
void log_libav(void* who, int level, const char* format, va_list arguments) {
  if (level > AV_LOG_WARNING) return;
  if (level <= AV_LOG_ERROR) note_error(who);
  char text[512];
  std::vsnprintf(text, sizeof text, format, arguments);
  std::string_view line = text;
  while (line.ends_with('\n'))
    line.remove_suffix(1);
  if (!line.empty()) spdlog::info("ffmpeg: {}", line);
}

bool can_be_read(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<char> block(1U << 20U);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size()))) {
  }
  return in.eof() && !in.bad();
}

}  // namespace

void LibavOptions::set(const char* key, const std::string& value) {
  av_dict_set(&entries_, key, value.c_str(), 0);
}

void LibavOptions::refuse_leftovers(const std::string& who) const {
  const AVDictionaryEntry* left = av_dict_get(entries_, "", nullptr, AV_DICT_IGNORE_SUFFIX);
  if (left != nullptr) throw environment_error("{} does not know the option '{}'", who, left->key);
}

LibavInput open_film(const std::string& file) {
  LibavOptions options;
  // the names of libav's demuxers for has_film_ending() in video/film_reader.h
  options.set("format_whitelist", "mov,matroska,gif,avi,apng");
  AVFormatContext* input = nullptr;
  // the protocol is named, or libav would find one in a name such as "take:1.mp4"
  const int opened = avformat_open_input(&input, ("file:" + file).c_str(), nullptr, options.pass());
  // so libav says that a format is not on the list
  if (opened == AVERROR(EINVAL)) {
    throw input_error(
        "is not a readable film: it is no MP4, MOV, Matroska, WebM, GIF, AVI or APNG file");
  }
  // and so that a file ends in its header
  const bool is_short = opened == AVERROR(EIO) && can_be_read(file);
  if (opened < 0)
    throw film_error(is_short ? AVERROR_INVALIDDATA : opened, "is not a readable film");
  return LibavInput(input);
}

std::string libav_words(int code) {
  if (code == AVERROR(EPIPE)) return "the program that reads it has ended";
  char words[AV_ERROR_MAX_STRING_SIZE] = {};
  av_strerror(code, words, sizeof words);
  return words;
}

Error film_error(int code, const std::string& what) {
  const Fault fault = fault_of(AVUNERROR(code));
  const bool lacks = fault == Fault::environment;
  return {fault, fmt::format("{}: {}", lacks ? "cannot be read" : what, libav_words(code))};
}

int check_libav(int code, const std::string& what) {
  if (code >= 0) return code;
  if (code == AVERROR_EXIT) stop_if_interrupted();
  throw environment_error("{}: {}", what, libav_words(code));
}

Owned<AVFrame> new_frame(int width, int height, AVPixelFormat format) {
  Owned<AVFrame> frame(made(av_frame_alloc()));
  frame->format = format;
  frame->width = width;
  frame->height = height;
  check_libav(av_frame_get_buffer(frame.get(), 0), "no memory for a frame");
  return frame;
}

void quieten_libav() {
  av_log_set_callback(log_libav);
}

void watch(AVCodecContext& decoder, std::atomic<bool>& told) {
  decoder.opaque = &told;
}

}  // namespace polhode
