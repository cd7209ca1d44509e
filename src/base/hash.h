// SPDX-License-Identifier: MIT
// Content hashes: XXH3 with 128 bits (library xxHash), as 32 hexadecimal digits, high half first.
// They detect changes but are not cryptographic.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

// The hash of `size` bytes at `data`.
std::string content_hash(const void* data, std::size_t size);
// The hash of the bytes of `text`.
inline std::string content_hash(std::string_view text) {
  return content_hash(text.data(), text.size());
}

}  // namespace polhode
