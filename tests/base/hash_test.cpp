// SPDX-License-Identifier: MIT
#include "base/hash.h"

#include <set>

#include <gtest/gtest.h>

namespace polhode {
namespace {

// hashes are kept in files: they must stay the ones that xxhsum -H2 prints
TEST(ContentHash, IsXxh3Of128Bits) {
  EXPECT_EQ(content_hash(""), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(content_hash("abc"), "06b05ab6733a618578af5f94892f3950");
  EXPECT_EQ(content_hash(std::string(1000, 'x')), "50a1af5a5f2dcf01c0a4877b962cba82");
}

TEST(ContentHash, SeesEveryBit) {
  std::string bytes(64, '\0');
  std::set<std::string> seen = {content_hash(bytes)};
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string other = bytes;
    other[bit / 8] = static_cast<char>(other[bit / 8] ^ (1 << bit % 8));
    EXPECT_TRUE(seen.insert(content_hash(other)).second) << bit;
  }
  EXPECT_TRUE(seen.insert(content_hash(bytes + '\0')).second) << "the length counts";
}

}  // namespace
}  // namespace polhode
