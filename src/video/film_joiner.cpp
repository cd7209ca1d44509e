// SPDX-License-Identifier: MIT
#include "video/film_joiner.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "base/at_place.h"
#include "base/system/interrupt.h"
#include "video/captions.h"
#include "video/libav/film_header.h"
#include "video/libav/film_output.h"

namespace polhode {
namespace {

// One film, of which packets are read.
class PartInput {
 public:
  explicit PartInput(const std::string& file) : file_(file) {
    quieten_libav();
    refuse_unless_file(file);
    input_ = at_place({file, 0, {}}, [&] { return open_film(file); });
    packet_.reset(made(av_packet_alloc()));
  }

  // Needed before packets are copied.
  void examine() {
    if (avformat_find_stream_info(input_.get(), nullptr) < 0) refuse("its tracks are unknown");
    if (input_->nb_streams != 1 || input_->streams[0]->codecpar->codec_type != AVMEDIA_TYPE_VIDEO) {
      refuse("is no piece: it must hold one track of pictures");
    }
  }

  std::string note(const char* key) const {
    const AVDictionaryEntry* entry = av_dict_get(input_->metadata, key, nullptr, 0);
    return entry == nullptr ? "" : entry->value;
  }
  const AVStream& stream() const { return *input_->streams[0]; }

  // The next packet; null at the end.
  AVPacket* next() {
    av_packet_unref(packet_.get());
    stop_if_interrupted();
    const int read = av_read_frame(input_.get(), packet_.get());
    if (read == AVERROR_EOF) return nullptr;
    if (read < 0) throw film_error(read, "is damaged").at({file_, 0, {}});
    return packet_.get();
  }

  [[noreturn]] void refuse(const std::string& words) const {
    throw input_error("{}", words).at({file_, 0, {}});
  }

 private:
  std::string file_;
  LibavInput input_;
  Owned<AVPacket> packet_;
};

// Which frame each packet of a film holds, in the order of the packets. Time stamps may be rounded,
// their order is exact.
std::vector<int> frames_of_packets(PartInput& input) {
  std::vector<std::int64_t> stamps;
  while (const AVPacket* packet = input.next()) {
    if (packet->pts == AV_NOPTS_VALUE) input.refuse("has frames without a time");
    stamps.push_back(packet->pts);
  }
  std::vector<std::int64_t> sorted = stamps;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
    input.refuse("has two frames at one time");
  }
  std::vector<int> frames;
  frames.reserve(stamps.size());
  for (const std::int64_t stamp : stamps) {
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), stamp);
    frames.push_back(static_cast<int>(place - sorted.begin()));
  }
  return frames;
}

void refuse_other_encoding(const PartInput& input, const AVCodecParameters& first) {
  const AVCodecParameters& one = *input.stream().codecpar;
  const bool same_head =
      one.extradata_size == first.extradata_size &&
      (one.extradata_size == 0 ||
       std::memcmp(one.extradata, first.extradata, static_cast<std::size_t>(one.extradata_size)) ==
           0);
  if (one.codec_id == first.codec_id && one.width == first.width && one.height == first.height &&
      same_head) {
    return;
  }
  input.refuse("was encoded otherwise than the first piece; make both with the same FFmpeg");
}

}  // namespace

class FilmJoiner::Implementation {
 public:
  explicit Implementation(const std::string& output)
      : name_(output), format_(format_of(output)), output_(output) {}

  void join(const std::vector<Part>& parts,
            const FrameRate& fps,
            const std::string& title,
            const std::string& comment,
            const FilmMetadata& metadata) {
    CaptionFile captions(name_, false);
    captions.write(metadata.captions, fps);
    const std::vector<std::vector<int>> frames = read_order(parts);
    fps_ = fps;
    int first = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      PartInput input(parts[i].file);
      input.examine();
      if (i == 0) {
        begin(input, title, comment, metadata);
      } else {
        refuse_other_encoding(input, *stream_->codecpar);
      }
      copy(input, frames[i], first);
      first += parts[i].frames;
    }
    at_place({name_, 0, {}}, [&] {
      check_libav(av_write_trailer(muxer_.get()), "cannot finish the film");
      output_.finish();
    });
    captions.commit();
  }

 private:
  static const FilmFormat& format_of(const std::string& output) {
    const FilmFormat* format = find_film_format(output);
    if (format != nullptr && format->keeps_metadata) return *format;
    throw input_error("pieces become a .mp4, .webm or .mov").at({output, 0, {}});
  }

  std::vector<std::vector<int>> read_order(const std::vector<Part>& parts) {
    std::vector<std::vector<int>> all;
    for (const Part& part : parts) {
      PartInput input(part.file);
      input.examine();
      all.push_back(frames_of_packets(input));
      const auto count = static_cast<int>(all.back().size());
      if (count != part.frames) {
        input.refuse(fmt::format("holds {} frames instead of {}", count, part.frames));
      }
      for (int i = 0; i < count; ++i) {
        delay_ = std::max(delay_, i - all.back()[static_cast<std::size_t>(i)]);
      }
    }
    return all;
  }

  void begin(const PartInput& input,
             const std::string& title,
             const std::string& comment,
             const FilmMetadata& metadata) {
    const AVStream& from = input.stream();
    at_place({name_, 0, {}}, [&] {
      muxer_ = open_container(format_, output_);
      stream_ = made(avformat_new_stream(muxer_.get(), nullptr));
      check_libav(avcodec_parameters_copy(stream_->codecpar, from.codecpar), "no memory");
      stream_->time_base = {fps_.denominator, fps_.numerator};
      stream_->avg_frame_rate = {fps_.numerator, fps_.denominator};
      // FFmpeg's own decoder of VP9 sees no alpha, the muxer says so by the pixels
      if (av_dict_get(from.metadata, "alpha_mode", nullptr, 0) != nullptr) {
        stream_->codecpar->format = AV_PIX_FMT_YUVA420P;
      }
      add_notes(*muxer_,
                {{"title", title}, {"comment", comment}, {"encoder", input.note("encoder")}});
      add_chapters(*muxer_, metadata, fps_);
      begin_film(*muxer_, format_);
    });
  }

  // decoding times go on by one step a packet, early enough for frames that are stored before
  // those that are shown before them
  void copy(PartInput& input, const std::vector<int>& frames, int first) {
    const AVRational step = {fps_.denominator, fps_.numerator};
    int count = 0;
    while (AVPacket* packet = input.next()) {
      packet->pts = first + frames[static_cast<std::size_t>(count)];
      packet->dts = first + count - delay_;
      packet->duration = 1;
      packet->pos = -1;
      packet->stream_index = 0;
      av_packet_rescale_ts(packet, step, stream_->time_base);
      at_place({name_, 0, {}}, [&] {
        check_libav(av_interleaved_write_frame(muxer_.get(), packet), "cannot write the film");
      });
      ++count;
    }
  }

  std::string name_;
  const FilmFormat& format_;
  FilmOutput output_;
  Owned<AVFormatContext> muxer_;
  AVStream* stream_ = nullptr;  // owned by the muxer
  FrameRate fps_;
  int delay_ = 0;  // frames by which decoding goes before showing
};

FilmJoiner::FilmJoiner(const std::string& output)
    : implementation_(std::make_unique<Implementation>(output)) {}
FilmJoiner::~FilmJoiner() = default;

void FilmJoiner::join(const std::vector<Part>& parts,
                      const FrameRate& fps,
                      const std::string& title,
                      const std::string& comment,
                      const FilmMetadata& metadata) {
  implementation_->join(parts, fps, title, comment, metadata);
}

std::string comment_of_film(const std::string& file) {
  return PartInput(file).note("comment");
}

}  // namespace polhode
