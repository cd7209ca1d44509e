// SPDX-License-Identifier: MIT
// What has been rendered for a deck, kept by content: a file's name holds the hash of all that it
// depends on, so that it is made once and never shown for something else.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

namespace polhode {

// One thing to make.
struct Product {
  std::string name;  // for people: "free_top-film"
  std::string key;   // everything that it depends on, as text
  // Writes files whose names begin with `stem` into the folder and returns what is to be known of
  // them; called by any thread. Throws Error.
  std::function<nlohmann::ordered_json(const std::filesystem::path& folder,
                                       const std::string& stem)>
      make;
};

// The folder of products. Products appear whole: first their files, last STEM.json, which lists the
// files with their sizes and hashes; without it, or when a file is not as listed, a product is made
// again. Safe to use from several threads for different products.
class Media {
 public:
  // Throws Error (input) when the folder cannot be made.
  explicit Media(std::filesystem::path folder);
  ~Media();
  Media(const Media&) = delete;
  Media& operator=(const Media&) = delete;

  // NAME-HASH, what the files of the product begin with.
  static std::string stem_of(const Product& product);
  // The facts of a product, from before or made now, with "files" (a list of name, bytes, hash).
  // Throws what `make` throws, and Error (environment) when the folder takes no files.
  nlohmann::ordered_json obtain(const Product& product);
  // How many were made, not found.
  int made() const { return made_; }
  // Removes products that nobody has obtained from this object: those of earlier versions.
  void forget_the_rest();

 private:
  bool is_whole(const nlohmann::ordered_json& facts) const;

  std::filesystem::path folder_;
  std::filesystem::path work_;  // for what is not whole yet
  std::mutex lock_;
  std::set<std::string> used_;  // stems
  int made_ = 0;
};

// A hash of the program itself and the versions of what it draws and encodes with: part of every
// key.
std::string program_identity();

}  // namespace polhode
