// SPDX-License-Identifier: MIT
#include "lecture/media.h"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>
#include <vector>

#include <sys/file.h>

#include "base/error.h"
#include "base/hash.h"
#include "base/json.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "base/system/log.h"
#include "base/version.h"
#include "film/report/motion_report.h"

namespace polhode {
namespace {

// the text of that key; "" if it is not there
std::string text_at(const Json& json, const char* key) {
  const bool there = json.is_object() && json.contains(key) && json[key].is_string();
  return there ? json[key].get<std::string>() : "";
}

// whether a file of the folder belongs to that product by its name
bool is_part_of(const std::string& stem, const std::string& file) {
  return file.starts_with(stem) && file.find('/') == std::string::npos;
}

const std::string kWork = ".work-";      // begins the names of the folders of runs
constexpr std::size_t kHashDigits = 16;  // 64 bits: enough for the files of a deck

// What a card says of itself; that of another product, or of somebody else, says another.
std::string hash_of_card(const std::string& stem, Json facts) {
  facts.erase("hash");
  return content_hash(stem + "\n" + facts.dump());
}

// Whether a fact, or one within it, that names a file names one that is listed.
bool names_only(const Json& facts, const std::set<std::string>& listed) {
  static const std::set<std::string> keys = {
      "film", "poster", "paper", "file", "svg", "png", "csv", "glb", "viewer"};
  if (!facts.is_structured()) return true;
  for (const auto& [key, value] : facts.items()) {
    const bool is_file = facts.is_object() && keys.contains(key);
    const bool is_good = is_file ? value.is_string() && listed.contains(value.get<std::string>())
                                 : names_only(value, listed);
    if (!is_good) return false;
  }
  return true;
}

// A descriptor with a lock on the folder, for as long as it is open; -1 if somebody else has one,
// or there are none.
int lock_on(const std::filesystem::path& folder) {
  const int folder_file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder_file < 0 || flock(folder_file, LOCK_EX | LOCK_NB) == 0) return folder_file;
  close(folder_file);
  return -1;
}

}  // namespace

Media::Media(std::filesystem::path folder, const std::filesystem::path& deck_folder)
    : folder_(std::move(folder)), deck_folders_{(absolute_path(deck_folder) / "").string()} {
  if (!deck_folder.empty()) deck_folders_.push_back((deck_folder / "").string());
  std::error_code failed;
  std::filesystem::create_directories(folder_, failed);
  std::string name = (folder_ / (kWork + "XXXXXX")).string();
  const Unbroken until_remembered;
  if (failed || mkdtemp(name.data()) == nullptr) {
    throw input_error("cannot write into the folder '{}'", folder_.string())
        .at({{}, 0, "--output"});
  }
  work_ = name;
  unfinished_.emplace(work_);
  at_work_ = lock_on(work_);
}

Media::~Media() {
  std::error_code ignored;
  std::filesystem::remove_all(work_, ignored);
  if (at_work_ >= 0) close(at_work_);
}

std::string Media::stem_of(const Product& product) {
  return fmt::format("{}-{}", product.name, content_hash(product.key).substr(0, kHashDigits));
}

bool Media::is_whole(const std::string& stem, const Json& facts) const {
  if (!facts.is_object() || !facts.contains("files") || !facts["files"].is_array()) return false;
  if (text_at(facts, "hash") != hash_of_card(stem, facts)) return false;
  std::set<std::string> listed;
  for (const Json& file : facts["files"]) {
    const std::string name = text_at(file, "name");
    if (!is_part_of(stem, name) || !is_as_listed(folder_, file)) return false;
    listed.insert(name);
  }
  Json others = facts;
  others.erase("inspection");  // numbers
  return names_only(others, listed);
}

Json Media::obtain(const Product& product) {
  const std::string stem = stem_of(product);
  const std::filesystem::path card = folder_ / (stem + ".json");
  {
    const std::lock_guard guard(lock_);
    used_.insert(stem);
  }
  std::error_code missing;
  if (std::filesystem::exists(card, missing)) {
    Json facts = parse_foreign_json(read_file(card));
    if (is_whole(stem, facts)) return facts;
  }
  const std::filesystem::path work = work_ / stem;
  std::filesystem::create_directories(work, missing);
  Json facts;
  std::vector<std::string> warnings = warnings_of([&] { facts = product.make(work, stem); });
  for (std::string& words : warnings) {
    for (const std::string& folder : deck_folders_)
      if (words.starts_with(folder)) words.erase(0, folder.size());
  }
  facts["warnings"] = warnings;
  facts["files"] = Json::array();
  for (const std::filesystem::path& file : entries_of(work, Fault::environment)) {
    const std::string bytes = read_file(file);
    facts["files"].push_back({{"name", file.filename().string()},
                              {"bytes", bytes.size()},
                              {"hash", content_hash(bytes)}});
    move_file(file, folder_ / file.filename());
  }
  facts["hash"] = hash_of_card(stem, facts);
  // a folder that is being removed has not all its files
  if (is_ending()) throw Error(Fault::interrupted, "interrupted");
  write_file(card, facts.dump(1) + "\n");
  const std::lock_guard guard(lock_);
  ++made_;
  return facts;
}

bool Media::clear_of_killed_runs() const {
  bool alone = true;
  for (const std::filesystem::path& other : entries_of(folder_, Fault::environment)) {
    if (!other.filename().string().starts_with(kWork) || other.filename() == work_.filename())
      continue;
    const int lock = lock_on(other);
    alone = alone && lock >= 0;
    if (lock < 0) continue;
    std::error_code failed;
    std::filesystem::remove_all(other, failed);
    close(lock);
  }
  return alone;
}

void Media::forget_the_rest() {
  if (!clear_of_killed_runs()) return;
  std::error_code failed;
  for (const std::filesystem::path& card : entries_of(folder_, Fault::environment)) {
    // only what a card of ours lists
    if (card.extension() != ".json" || used_.contains(card.stem().string())) continue;
    if (!std::filesystem::is_regular_file(card, failed)) continue;
    const Json facts = parse_foreign_json(read_file(card));
    if (!facts.is_object() || !facts.contains("files") || !facts["files"].is_array()) continue;
    const std::string stem = card.stem().string();
    for (const Json& file : facts["files"]) {
      const std::string name = text_at(file, "name");
      if (is_part_of(stem, name)) std::filesystem::remove(folder_ / name, failed);
    }
    std::filesystem::remove(card, failed);
  }
}

bool is_as_listed(const std::filesystem::path& folder, const Json& file) {
  try {
    return content_hash(read_file(folder / file.at("name").get<std::string>())) ==
           file.at("hash").get<std::string>();
  } catch (const Error&) {
    return false;
  } catch (const Json::exception&) {
    return false;
  }
}

std::string program_identity() {
  static const std::string identity = [] {
    std::string program;
    try {
      program = content_hash(read_file("/proc/self/exe"));
    } catch (const Error&) {
      program = "unknown";  // no /proc: the version must do
    }
    return fmt::format("{} {} {}", program_version(), program, versions().dump());
  }();
  return identity;
}

}  // namespace polhode
