// SPDX-License-Identifier: MIT
#include "app/piecewise.h"

#include <mutex>
#include <set>

#include <fmt/format.h>

#include "base/hash.h"
#include "base/one_line.h"
#include "base/system/files.h"
#include "base/system/parallel.h"
#include "motion/convoy.h"

namespace polhode {

std::string hash_of_work(const std::string& words) {
  return content_hash(words).substr(0, 16);
}

void refuse_other_work(const std::string& submitted, const std::string& words) {
  if (submitted.empty() || submitted == hash_of_work(words)) return;
  throw input_error(
      "a scene, an option or the program has changed since {} was submitted; submit it again",
      submitted.substr(0, 40))
      .at({{}, 0, "--submitted"});
}

std::optional<Shard> part_of_work(const PartOptions& options, const std::string& words) {
  refuse_other_work(options.submitted, words);
  if (!options.shard) return {};
  return parse_shard(*options.shard);
}

std::vector<long> pieces_of_part(const Piecewise& work, const std::optional<Shard>& shard) {
  const long groups = work.groups > 0 ? work.groups : work.pieces;
  const std::vector<long> dealt = pieces_of(shard, groups, work.things);
  const std::set<long> mine(dealt.begin(), dealt.end());
  std::vector<long> pieces;
  for (long i = 0; i < work.pieces; ++i)
    if (mine.contains(work.group_of(i))) pieces.push_back(i);
  return pieces;
}

long make_pieces(const Piecewise& work,
                 KeptRows& kept,
                 const std::optional<Shard>& shard,
                 int jobs,
                 ProgressKind progress) {
  const std::vector<long> mine = pieces_of_part(work, shard);
  std::set<long> done;
  kept.load([&](const std::string& line) {
    const std::optional<long> piece = work.take_up(line);
    if (piece) done.insert(*piece);
    return piece.has_value();
  });
  std::vector<long> left;
  for (const long piece : mine)
    if (!done.contains(piece)) left.push_back(piece);
  if (left.empty()) return 0;
  work.prepare(left);
  const int all = static_cast<int>(mine.size());
  Progress bar(progress, all, work.things, all - static_cast<int>(left.size()));
  std::mutex lock;
  int count = 0;
  try {
    const auto make = [&](long i) {
      const long piece = left[static_cast<std::size_t>(i)];
      work.make(piece);
      const std::lock_guard guard(lock);
      kept.add(work.line_of(piece));
      bar.show(++count);
    };
    const auto count_of_pieces = static_cast<long>(left.size());
    work.in_convoys ? parallel_in_convoys(count_of_pieces, jobs, make)
                    : parallel_for(count_of_pieces, jobs, make);
  } catch (...) {
    kept.save();
    throw;
  }
  return static_cast<long>(left.size());
}

KeptRows kept_rows_of(const std::filesystem::path& file,
                      const std::string& words,
                      const std::optional<Shard>& shard) {
  return {file, words, shard ? fmt::format("{}-of-{}", shard->number, shard->of) : ""};
}

std::string make_part(const Piecewise& work,
                      const std::filesystem::path& file,
                      const std::string& words,
                      const Shard& shard,
                      int jobs,
                      ProgressKind progress) {
  const auto all = static_cast<long>(pieces_of_part(work, shard).size());
  make_folder(file.parent_path(), {{}, 0, "--output"});
  KeptRows kept = kept_rows_of(file, words, shard);
  const long made = make_pieces(work, kept, shard, jobs, progress);
  if (made > 0) kept.save();
  return fmt::format(
      "part {}: {} of {} {}, {} of them from earlier runs; kept in {} until the same command "
      "without --shard collects them\n",
      name_of(shard),
      all,
      work.pieces,
      work.things,
      all - made,
      one_line(file.parent_path().string()));
}

}  // namespace polhode
