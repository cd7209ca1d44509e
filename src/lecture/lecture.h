// SPDX-License-Identifier: MIT
// The use case `lecture`: from a deck to everything that a lecture needs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/doctor.h"
#include "base/system/progress.h"
#include "lecture/products.h"

namespace polhode {

// A kind of document that can come out.
struct LectureOutput {
  std::string name;  // of --to
  std::string file;  // in the folder
  std::string doc;
};
const std::vector<LectureOutput>& lecture_outputs();

struct LectureJob {
  std::filesystem::path deck;
  std::string output;  // folder, made when it is missing; empty: output/DECK_lecture
  std::string to;  // names of outputs with commas between; empty: all that this machine can make
  bool allow_outside = false;
  LectureSettings settings;
  int jobs = 2;  // films that are made at the same time
  ProgressKind progress = ProgressKind::automatic;
};

struct LectureResult {
  std::string summary;          // what was made, for people
  std::vector<Error> problems;  // what was left out: the rest is there
};

// Documents appear together when all are ready; what is rendered is kept in DIR/media and used
// again as long as it is right. Throws Error when nothing can be made at all.
LectureResult lecture(const LectureJob& job);

// What each output needs that is missing here, for `doctor`.
std::vector<ExternalNeed> lecture_needs();

}  // namespace polhode
