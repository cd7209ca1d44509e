// SPDX-License-Identifier: MIT
#include "video/libav/filter_graph.h"

extern "C" {
#include <libavfilter/avfilter.h>
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
}

#include <fmt/format.h>

#include "base/system/shared_library.h"

namespace polhode {
namespace {

SharedLibrary open_library() {
  const std::string name = fmt::format("libavfilter.so.{}", LIBAVFILTER_VERSION_MAJOR);
  try {
    return SharedLibrary({name});
  } catch (const Error& error) {
    throw environment_error(
        "a GIF needs libavfilter ({}); install it (Debian: libavfilter{}), or choose another "
        "format",
        error.message(),
        LIBAVFILTER_VERSION_MAJOR);
  }
}

// the functions of libavfilter that are used here, as its headers declare them
struct FilterFunctions {
  SharedLibrary library = open_library();
  decltype(&::av_buffersink_get_frame) av_buffersink_get_frame =
      library.function<decltype(::av_buffersink_get_frame)>("av_buffersink_get_frame");
  decltype(&::av_buffersrc_add_frame_flags) av_buffersrc_add_frame_flags =
      library.function<decltype(::av_buffersrc_add_frame_flags)>("av_buffersrc_add_frame_flags");
  decltype(&::avfilter_get_by_name) avfilter_get_by_name =
      library.function<decltype(::avfilter_get_by_name)>("avfilter_get_by_name");
  decltype(&::avfilter_graph_alloc) avfilter_graph_alloc =
      library.function<decltype(::avfilter_graph_alloc)>("avfilter_graph_alloc");
  decltype(&::avfilter_graph_config) avfilter_graph_config =
      library.function<decltype(::avfilter_graph_config)>("avfilter_graph_config");
  decltype(&::avfilter_graph_create_filter) avfilter_graph_create_filter =
      library.function<decltype(::avfilter_graph_create_filter)>("avfilter_graph_create_filter");
  decltype(&::avfilter_graph_free) avfilter_graph_free =
      library.function<decltype(::avfilter_graph_free)>("avfilter_graph_free");
  decltype(&::avfilter_graph_parse_ptr) avfilter_graph_parse_ptr =
      library.function<decltype(::avfilter_graph_parse_ptr)>("avfilter_graph_parse_ptr");
  decltype(&::avfilter_inout_alloc) avfilter_inout_alloc =
      library.function<decltype(::avfilter_inout_alloc)>("avfilter_inout_alloc");
  decltype(&::avfilter_inout_free) avfilter_inout_free =
      library.function<decltype(::avfilter_inout_free)>("avfilter_inout_free");
};

const FilterFunctions& lib() {
  static const FilterFunctions functions;
  return functions;
}

// a list of open pads that frees itself
class Pads {
 public:
  Pads() = default;
  ~Pads() { lib().avfilter_inout_free(&first_); }
  Pads(const Pads&) = delete;
  Pads& operator=(const Pads&) = delete;

  void add(const std::string& name, AVFilterContext* filter) {
    AVFilterInOut* pad = made(lib().avfilter_inout_alloc());
    pad->name = av_strdup(name.c_str());
    pad->filter_ctx = filter;
    pad->pad_idx = 0;
    pad->next = first_;
    first_ = pad;
  }
  AVFilterInOut** pass() { return &first_; }

 private:
  AVFilterInOut* first_ = nullptr;
};

AVFilterContext* make_filter(AVFilterGraph& graph,
                             const char* kind,
                             const std::string& name,
                             const std::string& arguments) {
  AVFilterContext* filter = nullptr;
  check_libav(lib().avfilter_graph_create_filter(&filter,
                                                 lib().avfilter_get_by_name(kind),
                                                 name.c_str(),
                                                 arguments.c_str(),
                                                 nullptr,
                                                 &graph),
              fmt::format("libavfilter makes no {}", kind));
  return filter;
}

}  // namespace

FilterGraph::FilterGraph(const std::string& description, const std::vector<FilterInput>& inputs)
    : graph_(made(lib().avfilter_graph_alloc())), frame_(made(av_frame_alloc())) {
  graph_->nb_threads = 1;
  Pads outputs_of_sources;
  for (const FilterInput& input : inputs) {
    const std::string arguments =
        fmt::format("video_size={}x{}:pix_fmt={}:time_base=1/100:pixel_aspect=1/1",
                    input.width,
                    input.height,
                    static_cast<int>(input.format));
    sources_.push_back(make_filter(*graph_, "buffer", input.name, arguments));
    outputs_of_sources.add(input.name, sources_.back());
  }
  sink_ = make_filter(*graph_, "buffersink", "out", "");
  Pads input_of_sink;
  input_of_sink.add("out", sink_);
  check_libav(lib().avfilter_graph_parse_ptr(graph_.get(),
                                             description.c_str(),
                                             input_of_sink.pass(),
                                             outputs_of_sources.pass(),
                                             nullptr),
              "libavfilter does not know what a GIF needs");
  check_libav(lib().avfilter_graph_config(graph_.get(), nullptr), "libavfilter does not open");
}

void FilterGraph::Free::operator()(AVFilterGraph* graph) const {
  lib().avfilter_graph_free(&graph);
}

void FilterGraph::push(std::size_t input, AVFrame* frame) {
  check_libav(lib().av_buffersrc_add_frame_flags(
                  sources_[input], frame, AV_BUFFERSRC_FLAG_KEEP_REF | AV_BUFFERSRC_FLAG_PUSH),
              "cannot filter a frame");
}

AVFrame* FilterGraph::pull() {
  av_frame_unref(frame_.get());
  const int code = lib().av_buffersink_get_frame(sink_, frame_.get());
  if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return nullptr;
  check_libav(code, "cannot filter a frame");
  return frame_.get();
}

}  // namespace polhode
