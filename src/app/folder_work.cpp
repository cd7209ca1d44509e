// SPDX-License-Identifier: MIT
#include "app/folder_work.h"

#include <optional>

#include "base/system/log.h"
#include "base/system/output_folder.h"
#include "base/system/overwriting.h"
#include "base/system/progress.h"
#include "chart/gnuplot.h"

namespace polhode {

void refuse_own_input(const FolderWork& work, const std::vector<std::filesystem::path>& inputs) {
  refuse_same_files(work.where, work.files, inputs);
  refuse_same_files(work.where, {work.kept}, inputs);
}

std::string make_folder_work(const FolderWork& work,
                             const PartOptions& part,
                             int jobs,
                             ProgressKind progress,
                             const std::function<FolderResult()>& finish) {
  const std::filesystem::path file = work.where / work.kept;
  const std::optional<Shard> shard = part_of_work(part, work.words);
  if (shard) return make_part(work.pieces, file, work.words, *shard, jobs, progress);

  require_gnuplot();
  OutputFolder folder(work.where, work.files);
  KeptRows kept(file, work.words);
  make_pieces(work.pieces, kept, {}, jobs, progress);
  const FolderResult result = [&] {
    const Busy busy(progress, "drawing the pictures");
    return finish();
  }();
  for (const std::string& warning : result.warnings)
    spdlog::warn("{}", warning);
  folder.commit(result.contents);
  kept.remove();
  return result.summary;
}

DividedWork divided(const FolderWork& work) {
  DividedWork same;
  same.words = work.words;
  same.output = work.where;
  same.proof = work.files;
  same.things = work.pieces.things;
  same.pieces = work.pieces.groups > 0 ? work.pieces.groups : work.pieces.pieces;
  return same;
}

}  // namespace polhode
