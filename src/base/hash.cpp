// SPDX-License-Identifier: MIT
#include "base/hash.h"

#include <xxhash.h>

#include <fmt/format.h>

namespace polhode {

std::string content_hash(const void* data, std::size_t size) {
  const XXH128_hash_t hash = XXH3_128bits(data, size);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace polhode
