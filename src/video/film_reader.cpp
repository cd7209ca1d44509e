// SPDX-License-Identifier: MIT
#include "video/film_reader.h"

extern "C" {
#include <libavutil/pixdesc.h>
}

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "base/at_place.h"
#include "base/error.h"
#include "base/system/atomic_file.h"
#include "image/png.h"
#include "video/libav/libav.h"

namespace polhode {
namespace {

// Decoders tell of pictures for which they got no memory as of damaged ones.
bool memory_is_short() {
  constexpr std::size_t kMuch = 256U << 20U;  // bytes
  void* room = av_malloc(kMuch);
  av_free(room);
  return room == nullptr;
}

}  // namespace

class FilmReader::Implementation {
 public:
  explicit Implementation(const std::string& file) : file_(file) {
    at_place({file_, 0, {}}, [&] {
      refuse_unless_file(file);  // libav tells little about a name that leads nowhere
      quieten_libav();
      open_input();
      open_decoder();
      packet_.reset(made(av_packet_alloc()));
      decoded_.reset(made(av_frame_alloc()));
    });
  }

  const FilmInfo& info() const { return info_; }
  std::string frame_shown() const {
    const AVFrame& frame = *decoded_;
    return fmt::format("{} {}",
                       ratio(frame.sample_aspect_ratio),
                       colours(frame.color_range,
                               frame.color_primaries,
                               frame.color_trc,
                               frame.colorspace,
                               frame.chroma_location));
  }
  double end() const { return static_cast<double>(end_ - first_) * av_q2d(stream_->time_base); }

  bool next(Image& frame, double& time) {
    bool more = false;
    at_place({file_, 0, {}}, [&] {
      more = decode();
      if (!more) {
        refuse_short();
        return;
      }
      ++frames_;
      time = time_of_frame();
      convert(frame);
    });
    return more;
  }

 private:
  void open_input() {
    input_ = open_film(file_);
    AVFormatContext* input = input_.get();
    // the container's own word, before that of the stream takes its place
    std::vector<std::string> of_container;
    for (unsigned i = 0; i < input->nb_streams; ++i)
      of_container.push_back(shown(input->streams[i]));
    const int known = avformat_find_stream_info(input, nullptr);
    if (known < 0) throw film_error(known, "is not a readable film: its tracks are unknown");
    const int index = av_find_best_stream(input, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    if (index < 0) throw input_error("contains no pictures");
    stream_ = input->streams[index];
    if (input->duration > 0) info_.length = static_cast<double>(input->duration) / AV_TIME_BASE;
    info_.shown = shown(stream_);
    const auto k = static_cast<std::size_t>(index);
    if (k < of_container.size() && of_container[k] != info_.shown)
      info_.shown += ", in the container " + of_container[k];
  }

  void open_decoder() {
    const AVCodecParameters& track = *stream_->codecpar;
    if (track.codec_id == AV_CODEC_ID_NONE) throw input_error("has pictures of an unknown kind");
    if (track.codec_id == AV_CODEC_ID_TIFF)
      throw input_error("has TIFF pictures, whose damage libav does not tell; make them FFV1");
    const bool beside = keeps_alpha_beside();
    const AVCodec* codec =
        beside ? alpha_decoder(track.codec_id) : avcodec_find_decoder(track.codec_id);
    if (codec == nullptr) {
      throw environment_error("this FFmpeg cannot decode {}{}",
                              beside ? "the transparency of " : "",
                              avcodec_get_name(track.codec_id));
    }
    if (track.width <= 0 || track.height <= 0) throw input_error("contains no pictures");
    decoder_.reset(made(avcodec_alloc_context3(codec)));
    check_libav(avcodec_parameters_to_context(decoder_.get(), &track),
                "cannot read the film's header");
    decoder_->thread_count = 0;
    watch(*decoder_, told_);
    // a damaged frame is an error, not something to be guessed at; that of some decoders would end
    // the program by an assertion, and is flagged as well
    const bool may_explode = !is_of_mpeg4(track.codec_id);
    decoder_->err_recognition = AV_EF_CRCCHECK | (may_explode ? AV_EF_EXPLODE : 0);
    decoder_->max_pixels = static_cast<std::int64_t>(kMostPngPixels);
    const int opened = avcodec_open2(decoder_.get(), codec, nullptr);
    if (opened < 0) throw film_error(opened, "cannot be decoded");

    info_.width = track.width;
    info_.height = track.height;
    // AVI counts the ticks of its clock, of which a frame may take several
    const bool counts_frames = std::string_view(input_->iformat->name) != "avi";
    const std::int64_t frames = counts_frames ? stream_->nb_frames : 0;
    info_.frames = static_cast<int>(std::clamp<std::int64_t>(frames, 0, INT32_MAX));
    info_.codec = codec->name;
    const AVRational rate = stream_->avg_frame_rate;
    if (rate.num > 0 && rate.den > 0) info_.fps = {rate.num, rate.den};
    const AVPixFmtDescriptor* format =
        av_pix_fmt_desc_get(static_cast<AVPixelFormat>(track.format));
    info_.alpha = beside || (format != nullptr && (format->flags & AV_PIX_FMT_FLAG_ALPHA) != 0);
  }

  // the decoder of MPEG-4 part 2 and its kin, which are no H.264
  static bool is_of_mpeg4(AVCodecID codec) {
    constexpr AVCodecID kFamily[] = {AV_CODEC_ID_MPEG4,
                                     AV_CODEC_ID_MSMPEG4V1,
                                     AV_CODEC_ID_MSMPEG4V2,
                                     AV_CODEC_ID_MSMPEG4V3,
                                     AV_CODEC_ID_WMV1,
                                     AV_CODEC_ID_WMV2,
                                     AV_CODEC_ID_H263,
                                     AV_CODEC_ID_H263P,
                                     AV_CODEC_ID_H263I,
                                     AV_CODEC_ID_FLV1};
    return std::find(std::begin(kFamily), std::end(kFamily), codec) != std::end(kFamily);
  }

  // WebM has the alpha of a frame beside its colours, which only libvpx puts together
  bool keeps_alpha_beside() const {
    const AVCodecID codec = stream_->codecpar->codec_id;
    if (codec != AV_CODEC_ID_VP8 && codec != AV_CODEC_ID_VP9) return false;
    const AVDictionaryEntry* mode = av_dict_get(stream_->metadata, "alpha_mode", nullptr, 0);
    return mode != nullptr && std::string(mode->value) == "1";
  }
  static const AVCodec* alpha_decoder(AVCodecID codec) {
    return avcodec_find_decoder_by_name(codec == AV_CODEC_ID_VP8 ? "libvpx" : "libvpx-vp9");
  }

  std::string shown(AVStream* stream) const {
    const AVCodecParameters& track = *stream->codecpar;
    const AVRational pixel = av_guess_sample_aspect_ratio(input_.get(), stream, nullptr);
    // the container's word goes before that of the stream
    const std::string of_stream = ratio(track.sample_aspect_ratio);
    const bool is_interlaced =
        track.field_order != AV_FIELD_UNKNOWN && track.field_order != AV_FIELD_PROGRESSIVE;
    return fmt::format(
        "{}{} {}{}",
        ratio(pixel),
        of_stream == ratio(pixel) ? "" : fmt::format(" ({} in the stream)", of_stream),
        colours(track.color_range,
                track.color_primaries,
                track.color_trc,
                track.color_space,
                track.chroma_location),
        is_interlaced ? ", interlaced" : "");
  }

  static std::string ratio(const AVRational& shape) {
    return shape.num > 0 ? fmt::format("{}:{}", shape.num, shape.den) : "1:1";
  }

  static std::string colours(const AVColorRange& range,
                             const AVColorPrimaries& primaries,
                             const AVColorTransferCharacteristic& transfer,
                             const AVColorSpace& matrix,
                             const AVChromaLocation& place) {
    const int at = number_of(place);
    const bool is_usual = at == AVCHROMA_LOC_UNSPECIFIED || at == AVCHROMA_LOC_LEFT;
    return fmt::format(
        "{} {} {} {}{}",
        word(range, AVCOL_RANGE_NB, av_color_range_name),
        word(primaries, AVCOL_PRI_NB, av_color_primaries_name),
        word(transfer, AVCOL_TRC_NB, av_color_transfer_name),
        word(matrix, AVCOL_SPC_NB, av_color_space_name),
        is_usual ? "" : ", colours at " + word(place, AVCHROMA_LOC_NB, av_chroma_location_name));
  }

  // libav's name for a tag, which is below `end`, or its number where it has none
  template <class Tag>
  static std::string word(const Tag& tag, Tag end, const char* (*name_of)(Tag)) {
    const int number = number_of(tag);
    const bool known = number >= 0 && number < end;
    const char* name = known ? name_of(static_cast<Tag>(number)) : nullptr;
    return name != nullptr ? name : std::to_string(number);
  }

  // A film may have any number there, also one that the enumeration lacks.
  template <class Tag>
  static int number_of(const Tag& tag) {
    int number = 0;
    static_assert(sizeof number == sizeof tag);
    std::memcpy(&number, &tag, sizeof number);
    return number;
  }

  // the next picture into decoded_
  bool decode() {
    while (true) {
      const int received = avcodec_receive_frame(decoder_.get(), decoded_.get());
      if (received == AVERROR(EAGAIN)) {
        send_packet();
        continue;
      }
      if (received != 0 && received != AVERROR_EOF) refuse_damage(received);
      refuse_guesses();
      return received == 0;
    }
  }

  void send_packet() {
    while (true) {
      const int read = av_read_frame(input_.get(), packet_.get());
      if (read == AVERROR_EOF) {
        const int ended = avcodec_send_packet(decoder_.get(), nullptr);
        if (ended < 0) refuse_damage(ended);
        return;
      }
      if (read < 0) refuse_damage(read);
      const bool ours = packet_->stream_index == stream_->index;
      packets_ += ours ? 1 : 0;
      if (ours && packet_->pts != AV_NOPTS_VALUE)
        end_ = std::max(end_, packet_->pts + packet_->duration);
      const int sent = ours ? avcodec_send_packet(decoder_.get(), packet_.get()) : 0;
      av_packet_unref(packet_.get());
      if (sent < 0) refuse_damage(sent);
      if (ours) return;
    }
  }

  [[noreturn]] void refuse_damage(int code) const {
    const bool lacks = code == AVERROR_INVALIDDATA && memory_is_short();
    throw film_error(lacks ? AVERROR(ENOMEM) : code,
                     fmt::format("is damaged after frame {}", frames_));
  }

  // Some decoders (ProRes) pass on a picture of which parts could not be decoded; what stands there
  // is what the memory held before, which may be the right picture. Others (H.264, where memory
  // lacks) tell the log alone.
  void refuse_guesses() const {
    if (told_ || decoded_->decode_error_flags != 0 ||
        (decoded_->flags & AV_FRAME_FLAG_CORRUPT) != 0) {
      refuse_damage(AVERROR_INVALIDDATA);
    }
  }

  // A file that was cut off simply ends. Packets are counted, for a film may leave out frames that
  // it holds: those before the place where it was trimmed.
  void refuse_short() const {
    if (packets_ >= info_.frames) return;
    throw input_error(
        "is damaged: its header promises {} frames, but it contains {}", info_.frames, packets_);
  }

  double time_of_frame() {
    const std::int64_t stamp = decoded_->best_effort_timestamp;
    if (stamp == AV_NOPTS_VALUE) return static_cast<double>(frames_ - 1) / info_.fps.value();
    if (frames_ == 1) first_ = stamp;
    return static_cast<double>(stamp - first_) * av_q2d(stream_->time_base);
  }

  void convert(Image& frame) {
    const AVFrame& from = *decoded_;
    if (from.width != info_.width || from.height != info_.height) {
      throw input_error("changes its size at frame {}, from {}x{} to {}x{}",
                        frames_,
                        info_.width,
                        info_.height,
                        from.width,
                        from.height);
    }
    const std::array<int, 3> kind = {
        from.format, number_of(from.colorspace), number_of(from.color_range)};
    if (converter_ == nullptr || kind != kind_) open_converter();
    kind_ = kind;
    if (frame.width != from.width || frame.height != from.height) {
      frame = Image(from.width, from.height);
    }
    frame.ground.reset();
    frame.painted.clear();
    if (whole_ != nullptr) {
      av_image_copy(whole_->data,
                    whole_->linesize,
                    const_cast<const std::uint8_t**>(from.data),  // NOLINT: of libav before 7
                    from.linesize,
                    static_cast<AVPixelFormat>(from.format),
                    from.width,
                    from.height);
    }
    const AVFrame& blocks = whole_ != nullptr ? *whole_ : from;
    // swscale writes up to 60 bytes behind the last pixel, for which frames of libav have room
    AVFrame& to = *converted_;
    check_libav(
        sws_scale(
            converter_.get(), blocks.data, blocks.linesize, 0, to.height, to.data, to.linesize),
        "cannot convert a frame");
    if (to.format == AV_PIX_FMT_RGBA) {
      const int stride = 4 * from.width;
      av_image_copy_plane(
          frame.pixels.data(), stride, to.data[0], to.linesize[0], stride, from.height);
    } else if (to.format == AV_PIX_FMT_GBRAP) {
      interleave<std::uint8_t, 0, 0>(to, frame);
    } else {
      interleave<std::uint16_t, 7, 8>(to, frame);  // halves
    }
  }

  // planes of green, blue, red and opacity into pixels; they have some bits more than these
  template <class Sample, int kBitsOfColours, int kBitsOfOpacity>
  static void interleave(const AVFrame& planes, Image& frame) {
    const auto width = static_cast<std::size_t>(frame.width);
    for (int y = 0; y < frame.height; ++y) {
      const auto row_of = [&](int plane) {
        return reinterpret_cast<const Sample*>(planes.data[plane] +
                                               std::ptrdiff_t{y} * planes.linesize[plane]);
      };
      const Sample *green = row_of(0), *blue = row_of(1), *red = row_of(2), *opacity = row_of(3);
      std::uint8_t* pixel = frame.pixels.data() + 4 * width * static_cast<std::size_t>(y);
      for (std::size_t x = 0; x < width; ++x, pixel += 4) {
        pixel[0] = rounded<kBitsOfColours>(red[x]);
        pixel[1] = rounded<kBitsOfColours>(green[x]);
        pixel[2] = rounded<kBitsOfColours>(blue[x]);
        pixel[3] = rounded<kBitsOfOpacity>(opacity[x]);
      }
    }
  }

  template <int kBits>
  static std::uint8_t rounded(unsigned value) {
    constexpr unsigned kHalf = (1U << kBits) / 2;
    return static_cast<std::uint8_t>(std::min((value + kHalf) >> kBits, 255U));
  }

  // swscale takes others for BT.601
  void refuse_unknown(const AVColorSpace& matrix) const {
    constexpr int kKnown[] = {AVCOL_SPC_RGB,
                              AVCOL_SPC_BT709,
                              AVCOL_SPC_UNSPECIFIED,
                              AVCOL_SPC_FCC,
                              AVCOL_SPC_BT470BG,
                              AVCOL_SPC_SMPTE170M,
                              AVCOL_SPC_SMPTE240M,
                              AVCOL_SPC_BT2020_NCL,
                              AVCOL_SPC_BT2020_CL};
    if (std::find(std::begin(kKnown), std::end(kKnown), number_of(matrix)) != std::end(kKnown))
      return;
    throw input_error("has the matrix of colours '{}', which is not known here",
                      word(matrix, AVCOL_SPC_NB, av_color_space_name));
  }

  static int rounded_up(int size, int block) { return (size + block - 1) / block * block; }

  // gray is full unless it says otherwise, as libav has it for 8 bits
  static bool is_full(const AVFrame& from) {
    const int range = number_of(from.color_range), matrix = number_of(from.colorspace);
    const bool is_gray =
        av_pix_fmt_desc_get(static_cast<AVPixelFormat>(from.format))->nb_components <= 2;
    return range == AVCOL_RANGE_JPEG || matrix == AVCOL_SPC_RGB ||
           (is_gray && range == AVCOL_RANGE_UNSPECIFIED);
  }

  void open_converter() {
    const AVFrame& from = *decoded_;
    const auto kind = static_cast<AVPixelFormat>(from.format);
    const AVPixFmtDescriptor& samples = *av_pix_fmt_desc_get(kind);
    // Each pixel has the colour of its block. From brightness and colours swscale rounds once, and
    // fast, only into planes; other pixels it copies only into pixels. Of values of twice the
    // brightest, which a limited range allows, it makes black: it makes halves of these films.
    const bool is_packed = (samples.flags & (AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_PAL)) != 0;
    const bool is_halved = !is_packed && samples.nb_components > 2 && !is_full(from);
    const AVPixelFormat target = is_packed   ? AV_PIX_FMT_RGBA
                                 : is_halved ? AV_PIX_FMT_GBRAP16
                                             : AV_PIX_FMT_GBRAP;
    // Where blocks of pixels that share a colour reach beyond the picture, swscale would squeeze
    // them into it: it is given whole blocks.
    const int width = rounded_up(from.width, 1 << samples.log2_chroma_w),
              height = rounded_up(from.height, 1 << samples.log2_chroma_h);
    whole_.reset();
    if (width != from.width || height != from.height) {
      whole_ = new_frame(width, height, kind);
      for (int i = 0; i < AV_NUM_DATA_POINTERS && whole_->buf[i] != nullptr; ++i)
        std::fill_n(whole_->buf[i]->data, whole_->buf[i]->size, std::uint8_t{0});
    }
    converter_.reset(sws_getContext(width,
                                    height,
                                    kind,
                                    width,
                                    height,
                                    target,
                                    SWS_POINT | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT,
                                    nullptr,
                                    nullptr,
                                    nullptr));
    if (converter_ == nullptr) throw environment_error("swscale cannot convert this film");
    int matrix = number_of(from.colorspace);
    refuse_unknown(from.colorspace);
    const bool full = is_full(from);
    if (matrix == AVCOL_SPC_UNSPECIFIED || matrix == AVCOL_SPC_RGB) {
      constexpr int kHighDefinition = 720;  // rows
      matrix = from.height >= kHighDefinition ? SWS_CS_ITU709 : SWS_CS_ITU601;
    }
    converted_ = new_frame(width, height, target);
    const int* weights = sws_getCoefficients(matrix);
    constexpr int kOne = 1 << 16;
    // pixel formats without a matrix refuse this, and need none
    static_cast<void>(sws_setColorspaceDetails(
        converter_.get(), weights, full ? 1 : 0, weights, 1, 0, is_halved ? kOne / 2 : kOne, kOne));
  }

  std::string file_;
  LibavInput input_;
  AVStream* stream_ = nullptr;      // owned by the input
  std::atomic<bool> told_ = false;  // whether the decoder has told of an error
  Owned<AVCodecContext> decoder_;
  Owned<AVPacket> packet_;
  Owned<AVFrame> decoded_;
  Owned<SwsContext> converter_;
  Owned<AVFrame> whole_;  // a copy with whole blocks, where the decoded one has none
  Owned<AVFrame> converted_;
  std::array<int, 3> kind_ = {};  // pixel format, matrix and range that the converter takes
  std::int64_t first_ = 0;        // time stamp of the first frame
  std::int64_t end_ = 0;          // and of the end of the last one
  int frames_ = 0;                // how many have been decoded
  int packets_ = 0;               // and how many were read for them
  FilmInfo info_;
};

FilmReader::FilmReader(const std::string& file)
    : implementation_(std::make_unique<Implementation>(file)) {}
FilmReader::~FilmReader() = default;

const FilmInfo& FilmReader::info() const {
  return implementation_->info();
}

bool FilmReader::next(Image& frame, double& time) {
  return implementation_->next(frame, time);
}

std::string FilmReader::frame_shown() const {
  return implementation_->frame_shown();
}

double FilmReader::end() const {
  return implementation_->end();
}

bool has_film_ending(const std::string& name) {
  constexpr const char* kEndings[] = {
      ".mp4", ".mkv", ".mov", ".webm", ".gif", ".avi", ".m4v", ".apng"};
  return std::any_of(std::begin(kEndings), std::end(kEndings), [&](const char* ending) {
    return name.ends_with(ending);
  });
}

}  // namespace polhode
