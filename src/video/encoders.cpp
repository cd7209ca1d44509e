// SPDX-License-Identifier: MIT
#include "video/encoders.h"

#include <algorithm>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/nearest.h"
#include "video/frame_sink.h"
#include "video/libav/libav.h"
#include "video/plain_sinks.h"

namespace polhode {
namespace {

// which of nine efforts a preset is, 0 is the fastest
std::size_t effort(const std::string& preset) {
  const std::vector<std::string>& all = encoder_presets();
  const auto found = std::find(all.begin(), all.end(), preset);
  return static_cast<std::size_t>(found - all.begin());
}

int plain_pixels(bool, bool) {
  // H.264 and HEVC in 4:4:4 stay blank in PowerPoint, QuickTime and browsers
  return AV_PIX_FMT_YUV420P;
}
int vp9_pixels(bool alpha, bool finest) {
  if (alpha) return AV_PIX_FMT_YUVA420P;  // libvpx knows no finer one with alpha
  return finest ? AV_PIX_FMT_YUV444P : AV_PIX_FMT_YUV420P;
}
int prores_pixels(bool alpha, bool) {
  return alpha ? AV_PIX_FMT_YUVA444P10 : AV_PIX_FMT_YUV444P10;
}
int raw_pixels(bool, bool finest) {
  return finest ? AV_PIX_FMT_YUV444P : AV_PIX_FMT_YUV420P;
}
int apng_pixels(bool alpha, bool) {
  return alpha ? AV_PIX_FMT_RGBA : AV_PIX_FMT_RGB24;
}
int gif_pixels(bool, bool) {
  return AV_PIX_FMT_PAL8;
}

void configure_x264(const EncoderSettings& settings, AVCodecContext& c, LibavOptions& options) {
  c.profile = FF_PROFILE_H264_HIGH;
  options.set("preset", settings.preset);
  options.set("crf", std::to_string(settings.crf));
  options.set("profile", "high");
  options.set("forced-idr", "1");
  // Where speed is wanted: frames out of order and weighted prediction take a quarter of the time
  // of encoding these films, and save 8 to 24 % of their bytes.
  if (effort(settings.preset) <= effort("veryfast")) {
    c.max_b_frames = 0;
    options.set("weightp", "0");
  }
  // The AVX-512 code of x264 164 reads what nobody wrote where rows are no multiple of eight
  // macroblocks: no two films were alike. AVX2 encodes 7 % slower, and 60 % without the
  // other two words.
  const bool whole_rows = c.width % 128 == 0;
  if (!whole_rows && (av_get_cpu_flags() & AV_CPU_FLAG_AVX512) != 0)
    options.set("x264-params", "asm=avx2,sse2fast,cache64");
}

void configure_x265(const EncoderSettings& settings, AVCodecContext&, LibavOptions& options) {
  options.set("preset", settings.preset);
  options.set("crf", std::to_string(settings.crf));
  options.set("forced-idr", "1");
  options.set("x265-params",
              // without frames out of order: of very short films libx265 gave packets without times
              fmt::format("log-level=none:open-gop=0:bframes=0:pools={0}:frame-threads={0}",
                          settings.threads));
}

// as libvpx and its successor libaom have it: without a bit rate the quality alone decides
void set_constant_quality(const EncoderSettings& settings,
                          int cpu_used,
                          AVCodecContext& c,
                          LibavOptions& options) {
  options.set("cpu-used", std::to_string(cpu_used));
  options.set("crf", std::to_string(settings.crf));
  options.set("row-mt", "1");
  c.bit_rate = 0;
}

void configure_vp9(const EncoderSettings& settings, AVCodecContext& c, LibavOptions& options) {
  // realtime for the two fastest, else from 5 (fast) to 0
  constexpr std::array kCpuUsed = {8, 6, 5, 5, 4, 3, 2, 1, 0};
  const std::size_t e = effort(settings.preset);
  options.set("deadline", e < 2 ? "realtime" : "good");
  set_constant_quality(settings, kCpuUsed[e], c, options);
  // pictures that are never shown would get no alpha
  if (c.pix_fmt == AV_PIX_FMT_YUVA420P) options.set("auto-alt-ref", "0");
}

void configure_aom(const EncoderSettings& settings, AVCodecContext& c, LibavOptions& options) {
  constexpr std::array kCpuUsed = {8, 8, 8, 7, 6, 6, 5, 4, 3};
  const std::size_t e = effort(settings.preset);
  options.set("usage", e < 5 ? "realtime" : "good");
  set_constant_quality(settings, kCpuUsed[e], c, options);
}

void configure_svt(const EncoderSettings& settings, AVCodecContext&, LibavOptions& options) {
  constexpr std::array kPreset = {12, 11, 10, 9, 8, 7, 6, 5, 4};
  // it writes to standard error by itself otherwise
  setenv("SVT_LOG", "1", 0);
  options.set("preset", std::to_string(kPreset[effort(settings.preset)]));
  options.set("crf", std::to_string(settings.crf));
  options.set("svtav1-params", fmt::format("lp={}", settings.threads));
}

void configure_prores(const EncoderSettings& settings, AVCodecContext&, LibavOptions& options) {
  options.set("profile", settings.finest ? "4444xq" : "4444");
  options.set("vendor", "apl0");  // some editors look for it
}

void configure_raw(const EncoderSettings&, AVCodecContext&, LibavOptions&) {}

void configure_apng(const EncoderSettings&, AVCodecContext&, LibavOptions& options) {
  options.set("pred", "mixed");
}

void configure_gif(const EncoderSettings&, AVCodecContext& c, LibavOptions& options) {
  c.time_base = {1, 100};  // the format knows hundredths of a second
  // Without "offsetting", which cuts off what is clear around a picture: for its left and right it
  // does not look at the last row.
  options.set("gifflags", "transdiff");
}

Error unknown_codec(const FilmFormat& format, const std::string& codec) {
  return input_error(
      "{} films take no codec '{}'{}", format.ending, codec, suggestion(codec, format.codecs));
}

// what --crf or --preset is for, when this output takes none
std::string takers(bool (*takes)(const FilmEncoder&)) {
  std::vector<std::string> endings;
  for (const FilmFormat& format : film_formats()) {
    const bool any = std::any_of(
        film_encoders().begin(), film_encoders().end(), [&](const FilmEncoder& encoder) {
          return encoder.codec == format.codecs.front() && takes(encoder);
        });
    if (any) endings.push_back(format.ending);
  }
  return fmt::format("{}", fmt::join(endings, ", "));
}

bool takes_presets(const FilmEncoder& encoder) {
  return encoder.presets;
}
bool takes_crf(const FilmEncoder& encoder) {
  return encoder.worst_crf > 0;
}

Error takes_none(const char* option, bool (*takes)(const FilmEncoder&)) {
  return input_error("this format has none; omit it, or write one of {}", takers(takes))
      .at({{}, 0, option});
}

void check_preset(const std::string& preset) {
  const std::vector<std::string>& all = encoder_presets();
  if (std::find(all.begin(), all.end(), preset) != all.end()) return;
  throw input_error("unknown preset '{}'{}", preset, suggestion(preset, all))
      .at({{}, 0, "--preset"});
}

}  // namespace

const std::vector<FilmEncoder>& film_encoders() {
  // clang-format off
  static const std::vector<FilmEncoder> table = {
      {"h264", "H.264", "libx264", ".mp4 that everything plays",
       false, true, 51, {26, 18, 12}, plain_pixels, configure_x264},
      {"hevc", "HEVC", "libx265", ".mp4 for QuickTime and televisions, --codec hevc",
       false, true, 51, {28, 20, 14}, plain_pixels, configure_x265},
      // forces keyframes, and takes every size; SVT does neither
      {"av1", "AV1", "libaom-av1", ".mp4 for new browsers, --codec av1",
       false, true, 63, {38, 28, 18}, plain_pixels, configure_aom},
      {"av1", "AV1", "libsvtav1", "where libaom-av1 is missing; keyframes only every second",
       false, true, 63, {38, 28, 18}, plain_pixels, configure_svt},
      {"vp9", "VP9", "libvpx-vp9", ".webm for web pages, with alpha",
       true, true, 63, {36, 24, 15}, vp9_pixels, configure_vp9},
      {"prores", "ProRes 4444", "prores_ks", ".mov for video editors, with alpha",
       true, false, 0, {}, prores_pixels, configure_prores},
      {"gif", "GIF", "gif", ".gif",
       true, false, 0, {}, gif_pixels, configure_gif},
      {"apng", "APNG", "apng", ".apng, lossless with alpha",
       true, false, 0, {}, apng_pixels, configure_apng},
      {"raw", "YUV4MPEG2", "wrapped_avframe", ".y4m and - (standard output), raw frames",
       false, false, 0, {}, raw_pixels, configure_raw},
  };
  // clang-format on
  return table;
}

const std::vector<FilmFormat>& film_formats() {
  static const std::vector<FilmFormat> table = {
      {".mp4", "mp4", {"h264", "hevc", "av1"}, true, {{"movflags", "+faststart"}}},
      // the numbers of tracks would be random
      {".webm", "webm", {"vp9"}, true, {{"fflags", "+bitexact"}}},
      {".mov", "mov", {"prores"}, true, {{"movflags", "+faststart"}}},
      {".gif", "gif", {"gif"}, false, {}},
      {".apng", "apng", {"apng"}, false, {{"plays", "0"}}},
      {".y4m", "yuv4mpegpipe", {"raw"}, false, {}},
  };
  return table;
}

const FilmFormat* find_film_format(const std::string& output) {
  if (output.starts_with(kHashPrefix)) return nullptr;  // behind it any ending may stand
  for (const FilmFormat& format : film_formats()) {
    if (output.ends_with(format.ending)) return &format;
    if (output == kStandardOutput && format.ending == ".y4m") return &format;
  }
  return nullptr;
}

bool has_encoder(const std::string& name) {
  return avcodec_find_encoder_by_name(name.c_str()) != nullptr;
}

std::string codec_package() {
  return fmt::format("libavcodec{}", LIBAVCODEC_VERSION_MAJOR);
}

const FilmEncoder& find_encoder(const FilmFormat& format, const std::string& codec) {
  const std::string& wanted = codec.empty() ? format.codecs.front() : codec;
  if (std::find(format.codecs.begin(), format.codecs.end(), wanted) == format.codecs.end()) {
    throw unknown_codec(format, wanted).at({{}, 0, "--codec"});
  }
  std::vector<std::string> tried;
  for (const FilmEncoder& encoder : film_encoders()) {
    if (encoder.codec != wanted) continue;
    if (has_encoder(encoder.name)) return encoder;
    tried.push_back(encoder.name);
  }
  throw environment_error(
      "this FFmpeg lacks {}; install one that has it (Debian: {}), or choose another format",
      fmt::join(tried, " and "),
      codec_package());
}

EncoderSettings settle_encoder(const std::string& output, const EncoderWish& wish) {
  EncoderSettings settings;
  settings.finest = wish.grade == Grade::archive;
  settings.preset.clear();
  settings.crf = 0;
  if (wish.forced) check_preset(*wish.forced);
  const FilmFormat* format = find_film_format(output);
  if (format == nullptr) {
    // hashes and nothing at all take any command line of a film
    if (!output.ends_with(".png")) return settings;
    if (wish.codec) throw input_error("a picture has none; omit it").at({{}, 0, "--codec"});
    if (wish.forced) throw takes_none("--preset", takes_presets);
    if (wish.crf) throw takes_none("--crf", takes_crf);
    return settings;
  }
  const FilmEncoder& encoder = find_encoder(*format, wish.codec.value_or(""));
  settings.codec = encoder.codec;
  if (wish.forced && !encoder.presets) throw takes_none("--preset", takes_presets);
  if (encoder.presets) settings.preset = wish.forced.value_or(wish.preset);
  if (wish.crf && encoder.worst_crf == 0) throw takes_none("--crf", takes_crf);
  if (encoder.worst_crf == 0) return settings;
  settings.crf = wish.crf.value_or(encoder.crf[static_cast<std::size_t>(wish.grade)]);
  if (settings.crf < 1 || settings.crf > encoder.worst_crf) {
    throw input_error(
        "must be 1 (best) to {} for {}, got {}", encoder.worst_crf, encoder.title, settings.crf)
        .at({{}, 0, "--crf"});
  }
  return settings;
}

}  // namespace polhode
