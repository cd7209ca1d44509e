// SPDX-License-Identifier: MIT
// The cache of what has been rendered for a deck. A file name contains the hash of everything that
// the file depends on, so it is made once and never used for anything else.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

namespace polhode {

// A thing to make and cache.
struct Product {
  std::string name;  // for display: "free_top-film"
  std::string key;   // everything that it depends on, as text
  // writes files whose names begin with `stem` into the folder and returns facts about them; called
  // on any thread; may throw Error
  std::function<nlohmann::ordered_json(const std::filesystem::path& folder,
                                       const std::string& stem)>
      make;
};

// The folder of products. The last file of a product is STEM.json, which lists the others with
// sizes and hashes; if it is missing or a file is not as listed, the product is made again.
// Different products may be used from different threads at the same time.
class Media {
 public:
  // Throws Error (input), naming --output, if the folder cannot be created or written.
  explicit Media(std::filesystem::path folder);
  ~Media();
  Media(const Media&) = delete;
  Media& operator=(const Media&) = delete;

  // NAME-HASH, the beginning of the names of the product's files.
  static std::string stem_of(const Product& product);
  // The facts of a product, cached or made now, with "files" (a list of name, bytes, hash). Throws
  // what `make` throws, and Error (environment) if a file cannot be written.
  nlohmann::ordered_json obtain(const Product& product);
  // The number of products that were made, not found in the cache.
  int made() const { return made_; }
  // Deletes the products that have not been obtained from this object.
  void forget_the_rest();

 private:
  bool is_whole(const nlohmann::ordered_json& facts) const;

  std::filesystem::path folder_;
  std::filesystem::path work_;  // for incomplete products
  std::mutex lock_;
  std::set<std::string> used_;  // stems
  int made_ = 0;
};

// A hash of the binary and the versions of the libraries that it draws and encodes with. Part of
// every key.
std::string program_identity();

}  // namespace polhode
