// SPDX-License-Identifier: MIT
// PNG pictures: one, or a numbered sequence.
#pragma once

#include "video/frame_sink.h"

namespace polhode {

std::unique_ptr<FrameSink> make_png_sink(const SinkJob& job);
// NAME_%05d.png: one %d, with or without a zero-padded width of at most nine. No frame has
// its name before finish(), so a failure leaves older frames as they were.
std::unique_ptr<FrameSink> make_png_sequence_sink(const SinkJob& job);

// A validated file-name pattern.
struct NumberedName {
  std::string before;
  std::string after;
  int width = 0;  // digits, zero-padded

  std::string of(int index) const;
};

// Is there a %d or %0Nd in it?
bool has_frame_number(const std::string& pattern);

// Throws Error (input) for anything but exactly one %d or %0Nd.
NumberedName parse_numbered_name(const std::string& pattern);

}  // namespace polhode
