// SPDX-License-Identifier: MIT
// Work that consists of independent pieces: rows of a map, motions of a section, methods of a
// chart. One run makes them all, or several runs, on any machines with a common folder, make a part
// each (--shard K/N), and the run without --shard collects what they have made.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/system/kept_rows.h"
#include "base/system/progress.h"
#include "film/output/shard.h"

namespace polhode {

// Which part of the work of a command a run does; the values of its options.
struct PartOptions {
  std::optional<std::string> shard;  // --shard, "K/N"; absent: the whole
  // --submitted: hash_of_work() of the work that was meant; empty: whatever it is now
  std::string submitted;
};

// The hash by which work is named; `words` are all that its results depend on.
std::string hash_of_work(const std::string& words);

// Throws Error (input), with --submitted as key, if the work is another than was meant; `submitted`
// may be empty.
void refuse_other_work(const std::string& submitted, const std::string& words);

// The part. Throws Error (input) as refuse_other_work() and parse_shard() (film/output/shard.h) do.
std::optional<Shard> part_of_work(const PartOptions& options, const std::string& words);

// The pieces of a work, numbered from 0. Each result is kept as a line of text.
struct Piecewise {
  long pieces = 0;
  std::string things;  // plural noun for the pieces: "rows"
  // Pieces that share expensive preparations are a group, and stay together in a part. groups: how
  // many there are, 0: each piece is one; group_of: numbered from 0.
  long groups = 0;
  std::function<long(long piece)> group_of = [](long piece) {
    return piece;
  };
  // Takes up the result in a line; returns the number of the piece, nothing if the line is not
  // one of this work.
  std::function<std::optional<long>(const std::string& line)> take_up;
  // Called once with the pieces that are about to be made.
  std::function<void(const std::vector<long>& pieces)> prepare = [](const std::vector<long>&) {
  };
  // Whether motions of several pieces may step together (motion/convoy.h).
  bool in_convoys = false;
  // Makes a piece. Called once for each, on any thread.
  std::function<void(long piece)> make;
  // The line of a piece that has been made. Called on one thread at a time.
  std::function<std::string(long piece)> line_of;
};

// The pieces of the shard, or all. Throws Error as pieces_of() (film/output/shard.h) does.
std::vector<long> pieces_of_part(const Piecewise& work, const std::optional<Shard>& shard);

// Takes up what `kept` has, makes what is missing, of the shard or of all, on `jobs` threads (0:
// one per processor), and keeps each result when it is there, also if the run ends early. Returns
// how many pieces it made. Throws Error as KeptRows, pieces_of() (film/output/shard.h) and the
// members of `work` do.
long make_pieces(const Piecewise& work,
                 KeptRows& kept,
                 const std::optional<Shard>& shard,
                 int jobs,
                 ProgressKind progress);

// KeptRows of the whole or of a part.
KeptRows kept_rows_of(const std::filesystem::path& file,
                      const std::string& words,
                      const std::optional<Shard>& shard);

// Makes a part of the work into the folder, which is created if need be, and says in one line what
// was done. `options`: as of make_pieces(). Throws Error as that does.
std::string make_part(const Piecewise& work,
                      const std::filesystem::path& file,
                      const std::string& words,
                      const Shard& shard,
                      int jobs,
                      ProgressKind progress);

}  // namespace polhode
