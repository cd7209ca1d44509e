// SPDX-License-Identifier: MIT
#include "video/libav/film_header.h"

namespace polhode {

Owned<AVFormatContext> open_container(const FilmFormat& format, const FilmOutput& output) {
  AVFormatContext* muxer = nullptr;
  check_libav(
      avformat_alloc_output_context2(&muxer, nullptr, format.muxer.c_str(), output.url().c_str()),
      fmt::format("this FFmpeg writes no {}", format.ending));
  muxer->pb = output.stream();
  return Owned<AVFormatContext>(muxer);
}

void add_notes(AVFormatContext& muxer,
               const std::vector<std::pair<const char*, std::string>>& notes) {
  for (const auto& [key, text] : notes) {
    if (!text.empty()) check_libav(av_dict_set(&muxer.metadata, key, text.c_str(), 0), key);
  }
}

void add_chapters(AVFormatContext& muxer, const FilmMetadata& metadata, const FrameRate& fps) {
  for (std::size_t i = 0; i < metadata.chapters.size(); ++i) {
    const bool last = i + 1 == metadata.chapters.size();
    auto* chapter = static_cast<AVChapter*>(made(av_mallocz(sizeof(AVChapter))));
    chapter->id = static_cast<std::int64_t>(i) + 1;
    chapter->time_base = {fps.denominator, fps.numerator};
    chapter->start = metadata.chapters[i].start;
    chapter->end = last ? metadata.frames : metadata.chapters[i + 1].start;
    av_dict_set(&chapter->metadata, "title", metadata.chapters[i].title.c_str(), 0);
    int count = static_cast<int>(muxer.nb_chapters);
    const int added = av_dynarray_add_nofree(&muxer.chapters, &count, chapter);
    muxer.nb_chapters = static_cast<unsigned>(count);
    if (added < 0) {
      av_dict_free(&chapter->metadata);
      av_free(chapter);
      throw environment_error("no memory for the film");
    }
  }
}

void begin_film(AVFormatContext& muxer, const FilmFormat& format) {
  LibavOptions options;
  for (const auto& [key, value] : format.options) {
    options.set(key.c_str(), value);
  }
  check_libav(avformat_write_header(&muxer, options.pass()), "cannot begin the film");
  options.refuse_leftovers(fmt::format("the muxer {}", format.muxer));
}

}  // namespace polhode
