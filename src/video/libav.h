// SPDX-License-Identifier: MIT
// What every use of libav needs: objects that free themselves, and failures as errors. For the
// sources of video/ only.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <memory>
#include <string>

#include "base/error.h"

namespace polhode::libav {

struct Free {
  void operator()(AVCodecContext* p) const { avcodec_free_context(&p); }
  void operator()(AVFrame* p) const { av_frame_free(&p); }
  void operator()(AVPacket* p) const { av_packet_free(&p); }
  void operator()(SwsContext* p) const { sws_freeContext(p); }
  // one that writes; one that reads is closed otherwise
  void operator()(AVFormatContext* p) const {
    if (p->pb != nullptr) avio_closep(&p->pb);
    avformat_free_context(p);
  }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

// options for a libav call; entries that are left over were not understood
class Options {
 public:
  Options() = default;
  ~Options() { av_dict_free(&entries_); }
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;

  void set(const char* key, const std::string& value) {
    av_dict_set(&entries_, key, value.c_str(), 0);
  }
  AVDictionary** pass() { return &entries_; }
  void refuse_leftovers(const char* who) const {
    const AVDictionaryEntry* left = av_dict_get(entries_, "", nullptr, AV_DICT_IGNORE_SUFFIX);
    if (left != nullptr)
      throw environment_error("{} does not know the option '{}'", who, left->key);
  }

 private:
  AVDictionary* entries_ = nullptr;
};

// libav's own text for an error code
std::string words(int code);

// every libav call that can fail through no fault of the user goes through here
int check(int code, const char* what);

// libav's warnings and errors go to the log from now on; its chatter does not
void send_log();

// libav's way to say that there was no memory
template <class T>
T* made(T* object) {
  if (object == nullptr) throw environment_error("no memory for the film");
  return object;
}

}  // namespace polhode::libav
