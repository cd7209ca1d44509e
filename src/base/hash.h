// SPDX-License-Identifier: MIT
// 128-bit content hashes (XXH3) as 32 hex digits; for equality, not for secrecy.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

std::string content_hash(const void* data, std::size_t size);
inline std::string content_hash(std::string_view text) {
  return content_hash(text.data(), text.size());
}

}  // namespace polhode
