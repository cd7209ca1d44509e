// SPDX-License-Identifier: MIT
// What `lecture` is asked for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/piecewise.h"
#include "base/system/progress.h"
#include "lecture/products.h"

namespace polhode {

// A kind of document. To add one: a row in lecture_outputs() and a function
// in lecture/documents/documents.cpp.
struct LectureOutput {
  std::string name;  // value of --to
  std::string file;  // file name in the output folder
  std::string doc;   // what it contains
};
// All kinds of documents, in the order in which they are made; the table exists until the
// program ends.
const std::vector<LectureOutput>& lecture_outputs();

// The options of `lecture`.
struct LectureJob {
  std::filesystem::path deck;  // a Markdown file
  std::string output;          // folder, created if needed; empty: output/DECK_lecture
  std::string to;  // names of documents, separated by commas; empty: all that this machine can make
  bool allow_outside = false;  // see DeckRoot (lecture/deck/sandbox.h)
  LectureSettings settings;
  // Products made at the same time; 0: one per processor. Charts and stability maps are made one by
  // one after the others, because they measure times or use all processors themselves.
  int jobs = 2;
  PartOptions part;
  ProgressKind progress = ProgressKind::automatic;
};

}  // namespace polhode
