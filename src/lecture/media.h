// SPDX-License-Identifier: MIT
// The cache of what has been rendered for a deck. A file name contains the hash of everything that
// the file depends on, so it is made once and never used for anything else.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/system/unfinished.h"

namespace polhode {

// A thing to make and cache.
struct Product {
  std::string name;  // for display and file names: "free_top-film"; letters, digits, - and _
  std::string key;   // all that it depends on, as text, with program_identity()
  // Writes files whose names begin with `stem` into the folder and returns facts about them, a JSON
  // object. Called on any thread. May throw Error.
  std::function<Json(const std::filesystem::path& folder, const std::string& stem)> make;
};

// The folder of products. The last file of a product is STEM.json, which lists the others with
// sizes and hashes and has a hash of itself; if it is missing or any of this is not so, the product
// is made again. Several
// threads may call obtain() at the same time, each for another product; the other members must not
// be called meanwhile.
class Media {
 public:
  // deck_folder: warnings name files in it relative to it, so that what is given away does not tell
  // where it was made. Throws Error (input), naming --output, if the folder cannot be created or
  // written.
  explicit Media(std::filesystem::path folder, const std::filesystem::path& deck_folder = {});
  ~Media();
  Media(const Media&) = delete;
  Media& operator=(const Media&) = delete;

  // NAME-HASH, the beginning of the names of the product's files.
  static std::string stem_of(const Product& product);
  // The facts of a product, cached or made now, with "files" (a list of objects with "name",
  // "bytes" and "hash"), "hash", of all of them, and "warnings", the sentences with which it was
  // made. Throws what `make`
  // throws, Error (input) as read_file and AtomicFile (base/system/atomic_file.h) do, and
  // (environment) if a file cannot be written.
  Json obtain(const Product& product);
  // The number of products that were made, not found in the cache.
  int made() const { return made_; }
  // Deletes the products of earlier runs that have not been obtained from this object, and what
  // killed runs have left; nothing while other runs work in the folder, such as shards, where the
  // file system can lock a folder. A file that cannot be deleted stays. Throws Error (input) as
  // read_file does.
  void forget_the_rest();

 private:
  // Removes what killed runs have left; returns whether no other run is at work.
  bool clear_of_killed_runs() const;
  // Whether the facts are those that were written for this stem, and all files that they list exist
  // with the listed hashes. Facts name no files but these.
  bool is_whole(const std::string& stem, const Json& facts) const;

  std::filesystem::path folder_;
  std::vector<std::string> deck_folders_;  // names of the deck's folder, which ends in a slash
  std::filesystem::path work_;             // for incomplete products
  std::optional<Unfinished> unfinished_;
  int at_work_ = -1;  // file descriptor that holds a lock on work_; -1 without one
  std::mutex lock_;
  std::set<std::string> used_;  // stems
  int made_ = 0;
};

// Whether a file of the folder has the hash of its entry, an object with "name" and "hash", in a
// list of what was written.
bool is_as_listed(const std::filesystem::path& folder, const Json& file);

// The version of the program, a hash of its binary ("unknown" without /proc), and the versions of
// the libraries that it draws and encodes with, as text. Part of every key. Thread-safe.
std::string program_identity();

}  // namespace polhode
