// SPDX-License-Identifier: MIT
// Reads a film back through libav, as a player would.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/image.h"

namespace polhode::test {

struct DecodedFilm {
  AVRational time_base{};
  AVRational avg_frame_rate{};
  AVRational r_frame_rate{};
  std::int64_t start_time = 0;
  std::int64_t duration = 0;  // in time_base
  int profile = 0;
  int pixel_format = 0;
  int range = 0;
  int matrix = 0;
  int primaries = 0;
  int transfer = 0;
  int chroma_location = 0;
  int codec = 0;
  unsigned tag = 0;
  int width = 0;
  int height = 0;
  std::string title;
  std::string comment;
  std::string encoder;
  std::string alpha_mode;  // of the stream
  struct Chapter {
    double start_s = 0.0;
    double end_s = 0.0;
    std::string title;
  };
  std::vector<Chapter> chapters;
  std::vector<std::int64_t> pts;        // in time_base, in order of display
  std::vector<std::int64_t> durations;  // of each, in time_base
  std::vector<bool> key;
  std::vector<Image> frames;                      // full-range RGBA through BT.709
  std::vector<std::vector<int>> blue_difference;  // of each frame, the middle row of Cb as stored

  struct Packet {
    std::int64_t pts = 0;  // in time_base
    bool key = false;      // as the container says
    bool idr = false;      // as the stream says
  };
  std::vector<Packet> packets;  // in order of the file
};

// does an H.264 packet (units with a length of four bytes in front) hold an IDR slice?
inline bool holds_idr(const AVPacket& packet) {
  for (std::int64_t at = 0; at + 5 <= packet.size;) {
    const std::uint8_t* unit = packet.data + at;
    if ((unit[4] & 31) == 5) return true;
    at += 4 + (std::int64_t{unit[0]} << 24 | unit[1] << 16 | unit[2] << 8 | unit[3]);
  }
  return false;
}

inline std::vector<int> middle_row_of_cb(const AVFrame& frame) {
  if (frame.format != AV_PIX_FMT_YUV420P) return {};
  const std::uint8_t* row = frame.data[1] + frame.height / 4 * frame.linesize[1];
  return {row, row + frame.width / 2};
}

inline Image to_rgba(const AVFrame& frame) {
  SwsContext* sws = sws_getContext(frame.width,
                                   frame.height,
                                   static_cast<AVPixelFormat>(frame.format),
                                   frame.width,
                                   frame.height,
                                   AV_PIX_FMT_RGBA,
                                   SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT | SWS_BILINEAR,
                                   nullptr,
                                   nullptr,
                                   nullptr);
  const AVPixFmtDescriptor* kind = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
  if ((kind->flags & AV_PIX_FMT_FLAG_RGB) == 0) {
    const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(sws, bt709, 0, bt709, 1, 0, 1 << 16, 1 << 16);
  }
  Image image(frame.width, frame.height);
  std::uint8_t* rows[] = {image.pixels.data()};
  const int strides[] = {4 * frame.width};
  sws_scale(sws, frame.data, frame.linesize, 0, frame.height, rows, strides);
  sws_freeContext(sws);
  return image;
}

inline std::string entry(const AVDictionary* entries, const char* key) {
  const AVDictionaryEntry* found = av_dict_get(entries, key, nullptr, 0);
  return found == nullptr ? "" : found->value;
}

// `by` names the decoder; empty: FFmpeg's own choice, which for VP9 drops the alpha
inline DecodedFilm decode(const std::string& file, const std::string& by = "") {
  DecodedFilm film;
  AVFormatContext* format = nullptr;
  // the protocol is named: a name may hold a colon
  EXPECT_EQ(avformat_open_input(&format, ("file:" + file).c_str(), nullptr, nullptr), 0) << file;
  if (format == nullptr) return film;
  avformat_find_stream_info(format, nullptr);
  const AVStream* stream = format->streams[0];
  film.time_base = stream->time_base;
  film.avg_frame_rate = stream->avg_frame_rate;
  film.r_frame_rate = stream->r_frame_rate;
  film.start_time = stream->start_time;
  film.duration = stream->duration;
  film.profile = stream->codecpar->profile;
  film.pixel_format = stream->codecpar->format;
  film.range = stream->codecpar->color_range;
  film.matrix = stream->codecpar->color_space;
  film.primaries = stream->codecpar->color_primaries;
  film.transfer = stream->codecpar->color_trc;
  film.chroma_location = stream->codecpar->chroma_location;
  film.codec = stream->codecpar->codec_id;
  film.tag = stream->codecpar->codec_tag;
  film.width = stream->codecpar->width;
  film.height = stream->codecpar->height;
  film.title = entry(format->metadata, "title");
  film.comment = entry(format->metadata, "comment");
  film.encoder = entry(format->metadata, "encoder");
  film.alpha_mode = entry(stream->metadata, "alpha_mode");
  for (unsigned i = 0; i < format->nb_chapters; ++i) {
    const AVChapter& chapter = *format->chapters[i];
    const double unit = av_q2d(chapter.time_base);
    film.chapters.push_back({unit * static_cast<double>(chapter.start),
                             unit * static_cast<double>(chapter.end),
                             entry(chapter.metadata, "title")});
  }

  const AVCodec* codec = by.empty() ? avcodec_find_decoder(stream->codecpar->codec_id)
                                    : avcodec_find_decoder_by_name(by.c_str());
  AVCodecContext* decoder = avcodec_alloc_context3(codec);
  avcodec_parameters_to_context(decoder, stream->codecpar);
  avcodec_open2(decoder, nullptr, nullptr);
  AVPacket* packet = av_packet_alloc();
  AVFrame* frame = av_frame_alloc();
  bool more = true;
  while (more) {
    more = av_read_frame(format, packet) == 0;
    // chapters of an .mp4 are a stream of text
    if (more && packet->stream_index != 0) {
      av_packet_unref(packet);
      continue;
    }
    if (more) {
      film.packets.push_back(
          {packet->pts, (packet->flags & AV_PKT_FLAG_KEY) != 0, holds_idr(*packet)});
    }
    avcodec_send_packet(decoder, more ? packet : nullptr);
    av_packet_unref(packet);
    while (avcodec_receive_frame(decoder, frame) == 0) {
      film.pts.push_back(frame->pts);
#if LIBAVUTIL_VERSION_MAJOR >= 59  // FFmpeg 7
      film.durations.push_back(frame->duration);
      film.key.push_back((frame->flags & AV_FRAME_FLAG_KEY) != 0);
#else
      film.durations.push_back(frame->pkt_duration);
      film.key.push_back(frame->key_frame != 0);
#endif
      film.frames.push_back(to_rgba(*frame));
      film.blue_difference.push_back(middle_row_of_cb(*frame));
    }
  }
  av_frame_free(&frame);
  av_packet_free(&packet);
  avcodec_free_context(&decoder);
  avformat_close_input(&format);
  return film;
}

}  // namespace polhode::test
