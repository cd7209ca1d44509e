// SPDX-License-Identifier: MIT
#include "video/film_sink.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/error.h"
#include "video/libav.h"

namespace polhode {
namespace {

using libav::check;
using libav::made;
using libav::Options;
using libav::Owned;

class FilmSink final : public FrameSink {
 public:
  explicit FilmSink(const SinkJob& job) : job_(job), file_(job.output) {
    // 0 would be lossless, in a profile that few players know
    CHECK(job.encoder.crf >= 1 && job.encoder.crf <= 51 && job.encoder.threads >= 1);
    libav::send_log();
    with_name([&] {
      open_muxer();
      open_encoder();
      open_converter();
      write_header();
    });
  }

  void push(const Image& frame) override {
    CHECK(frame.width == job_.width && frame.height == job_.height);
    with_name([&] {
      {
        const StageTimer timer(times_.convert);
        convert(frame);
      }
      const StageTimer timer(times_.encode);
      yuv_->pts = next_++;
      encode(yuv_.get());
    });
  }

  void finish() override {
    with_name([&] {
      const StageTimer timer(times_.encode);
      encode(nullptr);
      // x264's own threads end with the encoder: read their clocks before
      times_.encode.cpu_s += cpu_seconds_of(encoder_threads_);
      check(av_write_trailer(muxer_.get()), "cannot finish the film");
      check(muxer_->pb->error, "cannot write the film");
      check(avio_closep(&muxer_->pb), "cannot close the film");
      file_.commit();
    });
  }

  SinkTimes times() const override { return times_; }

 private:
  // errors of this sink name the film
  template <class Work>
  void with_name(const Work& work) const {
    try {
      work();
    } catch (const Error& error) {
      throw error.at({job_.output, 0, {}});
    }
  }

  void open_muxer() {
    // the protocol is named, or libav would find one in a name such as "take:1.mp4"
    const std::string url = "file:" + file_.part().string();
    AVFormatContext* muxer = nullptr;
    check(avformat_alloc_output_context2(&muxer, nullptr, "mp4", url.c_str()),
          "no MP4 muxer in this FFmpeg");
    muxer_.reset(muxer);
    check(avio_open(&muxer_->pb, url.c_str(), AVIO_FLAG_WRITE), "cannot open the film");
    for (const auto& [key, text] : {std::pair{"title", &job_.title}, {"comment", &job_.comment}}) {
      if (!text->empty()) check(av_dict_set(&muxer_->metadata, key, text->c_str(), 0), key);
    }
  }

  void open_encoder() {
    const AVCodec* codec = avcodec_find_encoder_by_name("libx264");
    if (codec == nullptr) {
      throw environment_error(
          "this FFmpeg has no libx264; install one that has (Debian: libavcodec59)");
    }
    encoder_.reset(made(avcodec_alloc_context3(codec)));
    AVCodecContext& c = *encoder_;
    c.width = job_.width;
    c.height = job_.height;
    c.pix_fmt = AV_PIX_FMT_YUV420P;
    c.time_base = {job_.fps.denominator, job_.fps.numerator};
    c.framerate = {job_.fps.numerator, job_.fps.denominator};
    c.sample_aspect_ratio = {1, 1};
    c.thread_count = job_.encoder.threads;
    // a group of at most a second, closed: a film can be cut and searched there
    c.gop_size = std::max(1, job_.fps.numerator / job_.fps.denominator);
    c.flags |= AV_CODEC_FLAG_CLOSED_GOP;
    if ((muxer_->oformat->flags & AVFMT_GLOBALHEADER) != 0) c.flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    c.color_range = AVCOL_RANGE_MPEG;
    c.colorspace = AVCOL_SPC_BT709;
    c.color_primaries = AVCOL_PRI_BT709;
    c.color_trc = AVCOL_TRC_BT709;
    c.chroma_sample_location = AVCHROMA_LOC_LEFT;
    c.profile = FF_PROFILE_H264_HIGH;

    Options options;
    options.set("preset", job_.encoder.preset);
    options.set("crf", std::to_string(job_.encoder.crf));
    options.set("profile", "high");
    const std::set<int> before = thread_ids();
    check(avcodec_open2(&c, codec, options.pass()), "the encoder does not open");
    options.refuse_leftovers("libx264");
    encoder_threads_ = thread_ids();
    for (const int id : before)
      encoder_threads_.erase(id);

    stream_ = made(avformat_new_stream(muxer_.get(), nullptr));
    stream_->time_base = c.time_base;
    stream_->avg_frame_rate = c.framerate;
    check(avcodec_parameters_from_context(stream_->codecpar, &c), "cannot describe the stream");
    packet_.reset(made(av_packet_alloc()));
  }

  void open_converter() {
    yuv_.reset(made(av_frame_alloc()));
    yuv_->format = AV_PIX_FMT_YUV420P;
    yuv_->width = job_.width;
    yuv_->height = job_.height;
    yuv_->color_range = AVCOL_RANGE_MPEG;
    yuv_->colorspace = AVCOL_SPC_BT709;
    check(av_frame_get_buffer(yuv_.get(), 0), "no memory for a frame");

    // colour samples lie where players look for them, left of the middle; swscale would put them
    // half a pixel beside it
    converter_.reset(made(sws_alloc_context()));
    const std::pair<const char*, int> settings[] = {
        {"srcw", job_.width},
        {"srch", job_.height},
        {"src_format", AV_PIX_FMT_RGBA},
        {"dstw", job_.width},
        {"dsth", job_.height},
        {"dst_format", AV_PIX_FMT_YUV420P},
        {"dst_h_chr_pos", 0},
        {"dst_v_chr_pos", 128},
        {"sws_flags", SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP},
    };
    for (const auto& [key, value] : settings)
      check(av_opt_set_int(converter_.get(), key, value, 0), key);
    check(sws_init_context(converter_.get(), nullptr, nullptr), "swscale cannot convert this size");

    // full-range RGB in, limited-range BT.709 out; swscale's own default would be BT.601
    const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
    constexpr int kOne = 1 << 16;
    check(sws_setColorspaceDetails(converter_.get(), bt709, 1, bt709, 0, 0, kOne, kOne),
          "swscale cannot convert to BT.709");
  }

  void write_header() {
    Options options;
    options.set("movflags", "+faststart");
    check(avformat_write_header(muxer_.get(), options.pass()), "cannot begin the film");
    options.refuse_leftovers("the MP4 muxer");
  }

  void convert(const Image& frame) {
    check(av_frame_make_writable(yuv_.get()), "no memory for a frame");
    const std::uint8_t* rows[] = {frame.pixels.data()};
    const int strides[] = {4 * frame.width};
    check(sws_scale(converter_.get(), rows, strides, 0, frame.height, yuv_->data, yuv_->linesize),
          "cannot convert a frame");
  }

  // hands a frame over (null: no more) and writes what comes out
  void encode(const AVFrame* frame) {
    check(avcodec_send_frame(encoder_.get(), frame), "cannot encode");
    while (true) {
      const int code = avcodec_receive_packet(encoder_.get(), packet_.get());
      if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
      check(code, "cannot encode");
      packet_->stream_index = stream_->index;
      packet_->duration = 1;
      av_packet_rescale_ts(packet_.get(), encoder_->time_base, stream_->time_base);
      check(av_interleaved_write_frame(muxer_.get(), packet_.get()), "cannot write the film");
    }
  }

  SinkJob job_;
  AtomicFile file_;
  Owned<AVFormatContext> muxer_;
  Owned<AVCodecContext> encoder_;
  Owned<AVPacket> packet_;
  Owned<AVFrame> yuv_;
  Owned<SwsContext> converter_;
  AVStream* stream_ = nullptr;  // owned by the muxer
  std::set<int> encoder_threads_;
  std::int64_t next_ = 0;  // index of the next frame, its time in time_base units
  SinkTimes times_;
};

}  // namespace

std::unique_ptr<FrameSink> make_film_sink(const SinkJob& job) {
  if (job.still) {
    throw input_error("one picture (--still) is written as .png, not as a film")
        .at({job.output, 0, {}});
  }
  if (job.width % 2 != 0 || job.height % 2 != 0) {
    throw input_error("H.264 wants even sides: {}x{} is not, {}x{} is",
                      job.width,
                      job.height,
                      job.width + job.width % 2,
                      job.height + job.height % 2)
        .at({job.output, 0, {}});
  }
  return std::make_unique<FilmSink>(job);
}

bool has_encoder(const std::string& name) {
  return avcodec_find_encoder_by_name(name.c_str()) != nullptr;
}

std::string libav_version() {
  return av_version_info();
}

}  // namespace polhode
