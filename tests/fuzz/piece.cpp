// SPDX-License-Identifier: MIT
// The records of pieces of films (--shard, --resume), and their seals.
#include <algorithm>

#include "base/error.h"
#include "base/hash.h"
#include "film/output/segments.h"
#include "fuzz/harness.h"
#include "video/captions.h"
#include "video/seal.h"

namespace polhode {
namespace {

// the bytes as a file with a seal whose length is any text, and whose hash is right
void read_seal(const std::string& bytes) {
  constexpr std::size_t kLength = 10;
  const std::string length = bytes.substr(0, std::min(kLength, bytes.size()));
  const std::string body = bytes.substr(length.size());
  const FileInMemory file(body + content_hash(body) + length + "polhode-seal");
  const std::optional<std::string> text = sealed_text(file.name());
  promise(!text || body.ends_with(*text), "a sealed text is in its file");
}

void read_record(const std::string& comment) {
  const SegmentRecord record = parse_record(comment);
  promise(difference_between(record, record).empty(), "a piece belongs to its own film");
  web_vtt(record.film.captions, {});
  const SegmentRecord again = parse_record(comment_with(record));
  promise(difference_between(record, again).empty(),
          "a record that is written and read is the same");
}

}  // namespace

void run_harness(const std::string& bytes) {
  read_seal(bytes);
  read_record(bytes);
}

}  // namespace polhode
