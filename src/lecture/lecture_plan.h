// SPDX-License-Identifier: MIT
// What a lecture needs, planned before anything is made: its products, and the documents that this
// machine can make of them.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/divided_work.h"
#include "base/error.h"
#include "base/json.h"
#include "film/output/shard.h"
#include "lecture/deck/deck.h"
#include "lecture/documents/pages.h"
#include "lecture/documents/turning.h"
#include "lecture/lecture_job.h"
#include "lecture/media.h"
#include "lecture/products.h"

namespace polhode {

// One product with what came of it.
struct LectureTask {
  Product product;
  bool alone = false;   // it measures time, and has the machine to itself
  double cost_s = 0.0;  // about what it takes on one processor, s
  Json facts;
  std::optional<Error> failure;
};

// Everything that is being made.
struct LectureWork {
  const LectureJob* job = nullptr;
  Deck deck;
  std::string deck_text;
  std::map<std::string, std::shared_ptr<DeckScene>> scenes;  // by the deck's name for them
  std::map<std::string, Error> bad_scenes;
  std::map<std::string, LectureTask> tasks;                 // by stem
  std::map<std::string, std::string> inspections, motions;  // scene -> stem
  std::vector<std::string> stems;                           // of each picture; empty: it failed
  std::vector<std::string> failures;                        // of each picture; empty: none
  std::map<std::string, std::string> images;  // the deck's own pictures -> copies in media/
  std::string address;                        // of the documents on the web; empty: unknown
};

// The scene of that name, loaded once. Throws what is wrong with it, each time the same.
const DeckScene& scene_of(LectureWork& work, const std::string& name);

// An error of a scene behind the place in the deck that asked for it.
Error in_deck(const LectureWork& work, int line, const Error& error);

// The tasks of the shard, or all; those that take longest come first and are dealt out first.
// Throws Error as pieces_of() (film/output/shard.h) does.
std::vector<LectureTask*> tasks_of(LectureWork& work, const std::optional<Shard>& shard);

// Scripts of others that documents contain.
struct Scripts {
  std::optional<Reveal> reveal;
  std::optional<Three> three;            // only if something is to be turned
  std::optional<std::string> core = {};  // find_page_core(), only if something has sliders
};

// What is to be made, and with what; nothing is written yet. Its work refers to the job.
struct PlannedLecture {
  // Reads the deck and plans its products. Throws Error as lecture() (lecture/lecture.h) does
  // before it writes anything.
  explicit PlannedLecture(const LectureJob& job);

  bool wants(const std::string& name) const;
  // Names of the documents, and of what goes with them.
  std::vector<std::string> files() const;
  // Throws Error (input), naming --output, if what is made would overwrite or remove the deck or a
  // file that it names: documents lie in `folder`, and in its folders `data` and `media` only what
  // the last run has made stays.
  void refuse_overwriting() const;
  // All that the products depend on, and which they are.
  std::string words() const;

  std::filesystem::path folder;
  Scripts scripts;
  Printer printer;
  std::string left_out;  // documents that this machine cannot make
  std::vector<std::string> outputs;
  LectureWork work;
};

// The same work before it is begun; its pieces are the products. Throws Error as lecture() does.
DividedWork divided_lecture(const LectureJob& job);

}  // namespace polhode
