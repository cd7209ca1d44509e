// SPDX-License-Identifier: MIT
// The small languages of options and values: every parser of a short text reads every input.
#include <cmath>
#include <functional>
#include <vector>

#include "base/base64.h"
#include "base/color.h"
#include "base/csv.h"
#include "base/error.h"
#include "base/name_list.h"
#include "base/nearest.h"
#include "base/numbers.h"
#include "base/one_line.h"
#include "base/utf8.h"
#include "film/output/shard.h"
#include "fuzz/harness.h"
#include "lecture/deck/quotes.h"
#include "lecture/deck/sandbox.h"
#include "motion/motion_spec.h"
#include "scene/scene_file.h"
#include "scene/toml_text.h"
#include "video/video_spec.h"

namespace polhode {
namespace {

void read_numbers(const std::string& text) {
  if (const std::optional<double> number = parse_number(text))
    promise(std::isfinite(*number), "numbers are finite");
  if (const std::optional<int> whole = parse_integer(text))
    promise(parse_number(text) == *whole, "a whole number is a number");
}

void read_frame_rate(const std::string& text) {
  const FrameRate rate = parse_frame_rate(text);
  promise(rate.denominator > 0 && rate.value() >= 1.0 && rate.value() <= 1000.0, "frame rates");
}

void read_size(const std::string& text) {
  const PictureSize size = parse_picture_size(text);
  promise(size.width >= kSmallestSide && size.height >= kSmallestSide, "sizes of pictures");
}

void read_accuracy(const std::string& text) {
  promise(parse_accuracy(text).value > 0.0, "an accuracy is positive");
}

void read_shard(const std::string& text) {
  const Shard shard = parse_shard(text);
  promise(shard.number >= 1 && shard.number <= shard.of, "a shard is one of its film");
}

void read_names(const std::string& text) {
  for (const std::string& name : split_names(text))
    promise(name.find(',') == std::string::npos, "no name has a comma");
  nearest_name(text.substr(0, 100), method_names());
  known_names(text, method_names(), "method", "--methods");
}

void read_quote(const std::string& text) {
  const Json facts = {{"mass_kg", 1.5}, {"derived", {{"flip_time_s", -1e-300}}}};
  quoted(facts, parse_quote("{inspect:" + text + "}"));
}

// the path of a number, as in --x of `stability`
void read_key_path(const std::string& text) {
  static const FileInMemory scene("body.moments = [1, 2, 3]\nbody.parts = [{ mass = 1 }]\n");
  number_in_scene(scene.name(), {}, text);
}

void read_escapes(const std::string& text) {
  promise(percent_decoded(percent_encoded(text)) == text, "escapes of a URL");
  base64(text);
  csv_field(text);
  promise(cut(text).size() <= 43, "a text is cut");
  for (std::size_t i = 0; i < text.size(); ++i)
    promise(i + utf8_length(text, i) <= text.size(), "characters end within their text");
}

}  // namespace

void run_harness(const std::string& bytes) {
  static const std::vector<std::function<void(const std::string&)>> readers = {
      read_numbers,
      read_frame_rate,
      read_size,
      read_accuracy,
      read_shard,
      read_names,
      read_quote,
      read_key_path,
      read_escapes,
      [](const std::string& text) { parse_color(text); },
      [](const std::string& text) { check_link(text); },
      [](const std::string& text) { check_formula(text); },
  };
  for (const auto& read : readers) {
    try {
      read(bytes);
    } catch (const Error&) {
      continue;
    }
  }
}

}  // namespace polhode
