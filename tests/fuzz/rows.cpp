// SPDX-License-Identifier: MIT
// Rows of charts, maps and sections that an earlier run or a shard has kept.
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "base/error.h"
#include "base/system/atomic_file.h"
#include "base/system/kept_rows.h"
#include "fuzz/harness.h"

namespace polhode {
namespace {

namespace fs = std::filesystem;

// one for the whole process
const fs::path& folder() {
  static const fs::path made = [] {
    std::string name = "/tmp/fuzz_rows_XXXXXX";
    promise(mkdtemp(name.data()) != nullptr, "a folder");
    std::atexit([] { fs::remove_all(folder()); });
    return fs::path(name);
  }();
  return made;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

std::vector<std::string> loaded(KeptRows rows) {
  std::vector<std::string> found;
  rows.load([&](const std::string& line) {
    found.push_back(line);
    return true;
  });
  return found;
}

}  // namespace

void run_harness(const std::string& bytes) {
  for (const fs::path& entry : fs::directory_iterator(folder()))
    fs::remove(entry);
  const fs::path file = folder() / "rows";
  const std::vector<std::string> lines = lines_of(bytes);
  const std::string words = lines.empty() ? "" : lines.front();
  const bool has_words = words.find('\r') == std::string::npos;

  // damaged rows: as they are, those before the first wrong seal come back
  write_file(file, bytes);
  const std::vector<std::string> whole = loaded(KeptRows(file, words));
  promise(whole.size() < lines.size() + 1, "rows are not made up");
  for (std::size_t i = 0; i < whole.size(); ++i)
    promise(lines[i + 1].starts_with(whole[i] + " "), "rows are those of the file");

  // what is written comes back, and not to other work
  fs::remove(file);
  KeptRows rows(file, words);
  for (const std::string& line : lines)
    rows.add(line);
  rows.save();
  if (has_words) promise(loaded(KeptRows(file, words)) == lines, "rows come back");
  promise(loaded(KeptRows(file, words + "x")).empty(), "rows of other work are not taken");
}

}  // namespace polhode
