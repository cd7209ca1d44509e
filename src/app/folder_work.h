// SPDX-License-Identifier: MIT
// Work in pieces of which a folder of files is made: charts, maps and sections.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/divided_work.h"
#include "app/piecewise.h"

namespace polhode {

// What is to be done, checked.
struct FolderWork {
  std::filesystem::path where;     // the folder
  std::vector<std::string> files;  // names of what is made in it
  std::string kept;                // name of the file of finished pieces, until all are there
  std::string words;               // all that the results depend on
  Piecewise pieces;
};

// Throws Error (input) if the work would replace one of the files that it reads.
void refuse_own_input(const FolderWork& work, const std::vector<std::filesystem::path>& inputs);

// What the pieces become when all are there.
struct FolderResult {
  std::vector<std::string> contents;  // of FolderWork::files
  std::string summary;
  std::vector<std::string> warnings = {};  // to be logged
};

// Makes what is missing of all pieces and writes the files, together at the end, and returns the
// summary; or makes a part of the pieces and says so. If it is interrupted or fails, finished
// pieces are kept for the next run of the same work. Throws Error as part_of_work, OutputFolder,
// KeptRows, make_pieces and require_gnuplot do, and what `finish` throws.
std::string make_folder_work(const FolderWork& work,
                             const PartOptions& part,
                             int jobs,
                             ProgressKind progress,
                             const std::function<FolderResult()>& finish);

// The same work before it is begun, without the times that it takes.
DividedWork divided(const FolderWork& work);

}  // namespace polhode
