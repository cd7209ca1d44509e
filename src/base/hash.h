// SPDX-License-Identifier: MIT
// Content hashes: XXH3 with 128 bits, as 32 hexadecimal digits. They detect changes but are not
// cryptographic.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

// The hash of `size` bytes at `data`.
std::string content_hash(const void* data, std::size_t size);
inline std::string content_hash(std::string_view text) {
  return content_hash(text.data(), text.size());
}

}  // namespace polhode
