// SPDX-License-Identifier: MIT
// A chain of libavfilter's filters that frames are pushed through. Not for other libraries.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "video/libav/libav.h"

struct AVFilterContext;
struct AVFilterGraph;

namespace polhode {

// What one input takes.
struct FilterInput {
  std::string name;  // of its pad in the description
  int width = 0;     // pixels
  int height = 0;    // pixels
  AVPixelFormat format = AV_PIX_FMT_NONE;
};

// Filters as libavfilter's text describes them; the output pad is called "out". Times are
// hundredths of a second. libavfilter is opened when the first one is made: with the libraries it
// brings it would double the time in which the program starts. All throw Error (environment).
class FilterGraph {
 public:
  FilterGraph(const std::string& description, const std::vector<FilterInput>& inputs);

  // The frame stays the caller's; null: no more will come.
  void push(std::size_t input, AVFrame* frame);
  // What has come out, which holds until the next call; null when there is nothing yet.
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
