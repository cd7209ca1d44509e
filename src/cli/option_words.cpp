// SPDX-License-Identifier: MIT
#include "cli/option_words.h"

#include <algorithm>

#include "base/system/progress.h"
#include "film/render_plan.h"
#include "frame/view_spec.h"
#include "lecture/lecture.h"
#include "motion/motion_spec.h"
#include "motion/stepper_table.h"
#include "render/context.h"
#include "video/encoders.h"

namespace polhode {
namespace {

// the names of the rows, in their order, each once
template <class Table, class Name>
std::vector<std::string> words_of(const Table& table, Name name) {
  std::vector<std::string> words;
  for (const auto& row : table) {
    if (std::find(words.begin(), words.end(), row.*name) == words.end()) words.push_back(row.*name);
  }
  return words;
}

}  // namespace

std::vector<std::string> backend_words() {
  return backend_names();
}

std::vector<std::string> codec_words() {
  // only .mp4 has a choice
  std::vector<std::string> words;
  for (const FilmFormat& format : film_formats()) {
    if (format.codecs.size() > 1)
      words.insert(words.end(), format.codecs.begin(), format.codecs.end());
  }
  return words;
}

std::vector<std::string> document_words() {
  return words_of(lecture_outputs(), &LectureOutput::name);
}

std::vector<std::string> method_words() {
  return method_names();
}

std::vector<std::string> preset_words() {
  return encoder_presets();
}

std::vector<std::string> progress_words() {
  return progress_names();
}

std::vector<std::string> quality_words() {
  return words_of(qualities(), &Quality::name);
}

std::vector<std::string> stepper_words() {
  return words_of(stepper_table(), &StepperInfo::name);
}

std::vector<std::string> theme_words() {
  return theme_names();
}

}  // namespace polhode
