// SPDX-License-Identifier: MIT
// The command `lecture`: makes the documents of a lecture from a deck.
#pragma once

#include <string>
#include <vector>

#include "app/commands/doctor.h"
#include "base/error.h"
#include "lecture/lecture_job.h"

namespace polhode {

// What the command prints.
struct LectureResult {
  std::string summary;          // what was made, and which documents this machine cannot make
  std::vector<Error> problems;  // what was left out; everything else was made
};

// Makes all documents; they appear together when all are ready. Rendered media are kept in
// DIR/media and reused while they are valid, also after an error; those that the deck no longer
// needs are deleted at the end. A picture that cannot be made is one of the problems, not an Error,
// unless the program is interrupted. Throws Error (input) as read_deck (lecture/deck/deck.h),
// find_reveal (lecture/documents/pages.h) and trusted_file (lecture/deck/sandbox.h) do, naming --to
// for an unknown document, naming --output for a folder that cannot be written, and as AtomicFile
// (base/system/atomic_file.h) does; (environment) naming --to for an output that this machine
// cannot make, without pandoc, and if a program fails or the disk is full; (interrupted).
//
// With job.part.shard it only makes a part of the products, in DIR/media, and needs nothing but
// pandoc; the run without it finds them. Then the problems are those of these products. It also
// throws Error (input) as part_of_work() (app/piecewise.h) and pieces_of() (film/output/shard.h)
// do.
LectureResult lecture(const LectureJob& job);

// The state of the programs and the font that the outputs need, for the command `doctor`. Throws
// Error (interrupted), and (input) if a file of reveal.js cannot be read.
std::vector<ExternalNeed> lecture_needs();

}  // namespace polhode
