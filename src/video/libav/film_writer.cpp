// SPDX-License-Identifier: MIT
#include "video/libav/film_writer.h"

#include <algorithm>

#include "base/at_place.h"
#include "base/check.h"
#include "base/system/stage_clock.h"
#include "video/libav/film_header.h"

namespace polhode {
namespace {

AVPixelFormat pixel_format(const FilmEncoder& row, const SinkJob& job) {
  return static_cast<AVPixelFormat>(row.pixels(job.transparent, job.encoder.finest));
}

// checked before any file is opened
const FilmEncoder& fitting_encoder(const FilmFormat& format, const SinkJob& job) {
  const FilmEncoder& row = find_encoder(format, job.encoder.codec);
  const AVPixFmtDescriptor& pixels = *av_pix_fmt_desc_get(pixel_format(row, job));
  const int step_x = 1 << pixels.log2_chroma_w;
  const int step_y = 1 << pixels.log2_chroma_h;
  const bool rgb = (pixels.flags & AV_PIX_FMT_FLAG_RGB) != 0;
  if (!rgb && (job.width % step_x != 0 || job.height % step_y != 0)) {
    throw input_error("{0} needs even sides: use {3}x{4} instead of {1}x{2}",
                      row.title,
                      job.width,
                      job.height,
                      job.width + job.width % step_x,
                      job.height + job.height % step_y)
        .at({job.output, 0, {}});
  }
  CHECK(job.encoder.threads >= 1);
  // 0 would be lossless, in a profile that few players know
  CHECK(row.worst_crf == 0 || (job.encoder.crf >= 1 && job.encoder.crf <= row.worst_crf));
  return row;
}

const FilmFormat& format_of(const SinkJob& job) {
  const FilmFormat* format = find_film_format(job.output);
  CHECK(format != nullptr);
  return *format;
}

void set_colours(AVCodecContext& c) {
  const AVPixFmtDescriptor& pixels = *av_pix_fmt_desc_get(c.pix_fmt);
  if ((pixels.flags & (AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_PAL)) != 0) return;
  c.color_range = AVCOL_RANGE_MPEG;
  c.colorspace = AVCOL_SPC_BT709;
  c.color_primaries = AVCOL_PRI_BT709;
  c.color_trc = AVCOL_TRC_BT709;
  if (pixels.log2_chroma_w > 0) c.chroma_sample_location = AVCHROMA_LOC_LEFT;
}

}  // namespace

FilmWriter::FilmWriter(const SinkJob& job)
    : job_(job), format_(format_of(job)), row_(fitting_encoder(format_, job)), output_(job.output) {
  quieten_libav();
  at_place({job_.output, 0, {}}, [&] {
    muxer_ = open_container(format_, output_);
    open_encoder();
  });
}

void FilmWriter::open_encoder() {
  const AVCodec* codec = avcodec_find_encoder_by_name(row_.name.c_str());
  encoder_.reset(made(avcodec_alloc_context3(codec)));
  AVCodecContext& c = *encoder_;
  c.width = job_.width;
  c.height = job_.height;
  c.pix_fmt = pixel_format(row_, job_);
  c.time_base = {job_.fps.denominator, job_.fps.numerator};
  c.framerate = {job_.fps.numerator, job_.fps.denominator};
  c.sample_aspect_ratio = {1, 1};
  c.thread_count = job_.encoder.threads;
  // a group of at most a second, closed: a film can be cut and searched there
  c.gop_size = std::max(1, job_.fps.numerator / job_.fps.denominator);
  c.flags |= AV_CODEC_FLAG_CLOSED_GOP;
  if ((muxer_->oformat->flags & AVFMT_GLOBALHEADER) != 0) c.flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  set_colours(c);

  LibavOptions options;
  row_.configure(job_.encoder, c, options);
  const std::set<int> before = thread_ids();
  check_libav(
      avcodec_open2(&c, codec, options.pass()),
      fmt::format(
          "the encoder {} does not open for {}x{} pixels", row_.name, job_.width, job_.height));
  options.refuse_leftovers(row_.name);
  threads_ = thread_ids();
  for (const int id : before) {
    threads_.erase(id);
  }

  stream_ = made(avformat_new_stream(muxer_.get(), nullptr));
  stream_->time_base = c.time_base;
  stream_->avg_frame_rate = c.framerate;
  check_libav(avcodec_parameters_from_context(stream_->codecpar, &c), "cannot describe the stream");
  // QuickTime plays HEVC under this name only
  if (row_.codec == "hevc") stream_->codecpar->codec_tag = MKTAG('h', 'v', 'c', '1');
  packet_.reset(made(av_packet_alloc()));
}

void FilmWriter::describe(const FilmMetadata& metadata) {
  CHECK(!begun_);
  if (!format_.keeps_metadata) return;
  add_chapters(*muxer_, metadata, job_.fps);
  if (!metadata.comment.empty()) job_.comment = metadata.comment;
}

void FilmWriter::write_header() {
  begun_ = true;
  if (format_.keeps_metadata) {
    const std::string encoder = fmt::format("{} of FFmpeg {}", row_.name, av_version_info());
    add_notes(*muxer_, {{"title", job_.title}, {"comment", job_.comment}, {"encoder", encoder}});
  }
  begin_film(*muxer_, format_);
}

void FilmWriter::write(AVFrame& frame, bool key) {
  at_place({job_.output, 0, {}}, [&] {
    if (!begun_) write_header();
    frame.pict_type = key ? AV_PICTURE_TYPE_I : AV_PICTURE_TYPE_NONE;
    encode(&frame);
  });
}

// hands a frame over (null: no more) and writes what comes out
void FilmWriter::encode(const AVFrame* frame) {
  encode_frame(*encoder_, frame, *packet_, "cannot encode", [&] {
    packet_->stream_index = stream_->index;
    packet_->duration = 1;
    av_packet_rescale_ts(packet_.get(), encoder_->time_base, stream_->time_base);
    check_libav(av_interleaved_write_frame(muxer_.get(), packet_.get()), "cannot write the film");
  });
}

void FilmWriter::set_at_end(const char* option, std::int64_t value) {
  check_libav(av_opt_set_int(muxer_->priv_data, option, value, 0), option);
}

void FilmWriter::finish() {
  at_place({job_.output, 0, {}}, [&] {
    CHECK(begun_);
    encode(nullptr);
    check_libav(av_write_trailer(muxer_.get()), "cannot finish the film");
    output_.finish(seal_);
  });
}

}  // namespace polhode
