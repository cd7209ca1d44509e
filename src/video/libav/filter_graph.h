// SPDX-License-Identifier: MIT
// Runs frames through a graph of libavfilter. Private to video/.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "video/libav/libav.h"

struct AVFilterContext;
struct AVFilterGraph;

namespace polhode {

// The format of one input.
struct FilterInput {
  std::string name;  // of its pad in the graph description
  int width = 0;     // pixels
  int height = 0;    // pixels
  AVPixelFormat format = AV_PIX_FMT_NONE;
};

// A graph in libavfilter's text form, with one output pad, "out". Times (pts) are in hundredths
// of a second. libavfilter is loaded when the first graph is made, because with its
// dependencies it would double the start-up time of the program. Not thread-safe. All members
// throw Error (environment).
class FilterGraph {
 public:
  // description: as ffmpeg's -filter_complex takes it, with the pads of the inputs in brackets.
  FilterGraph(const std::string& description, const std::vector<FilterInput>& inputs);

  // Pushes a frame, which stays the caller's, to the input of that index, from 0; null marks the
  // end of that input.
  void push(std::size_t input, AVFrame* frame);
  // The next output frame, owned by this object and valid until the next call; null if none
  // is ready.
  AVFrame* pull();

 private:
  struct Free {
    void operator()(AVFilterGraph* graph) const;
  };
  std::unique_ptr<AVFilterGraph, Free> graph_;
  std::vector<AVFilterContext*> sources_;  // owned by the graph
  AVFilterContext* sink_ = nullptr;        // owned by the graph
  Owned<AVFrame> frame_;
};

}  // namespace polhode
