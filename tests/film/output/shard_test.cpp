// SPDX-License-Identifier: MIT
#include "film/output/shard.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace polhode {
namespace {

TEST(Shard, IsReadAndNamedAsKOfN) {
  const Shard shard = parse_shard("2/8");
  EXPECT_EQ(shard.number, 2);
  EXPECT_EQ(shard.of, 8);
  EXPECT_EQ(name_of(shard), "2/8");
  EXPECT_EQ(name_of(parse_shard("1/1")), "1/1");
}

TEST(Shard, OtherTextIsRefused) {
  for (const char* text : {"", "3", "a/b", "1/", "/2", "1/2/3", "1.5/2", " 1/2", "1/99999999999"}) {
    SCOPED_TRACE(text);
    test::expect_input_error([&] { parse_shard(text); }, "--shard", "must be K/N, such as 2/8");
  }
  for (const char* text : {"0/3", "4/3", "-1/3", "1/0", "1/-2"}) {
    SCOPED_TRACE(text);
    test::expect_input_error([&] { parse_shard(text); }, "--shard", "K from 1 to N");
  }
}

// every frame is in one shard, and the shards are as equal as can be
TEST(Shard, TogetherTheyAreTheFilm) {
  for (const int frames : {1, 2, 7, 100, 9973, 2000000000}) {
    for (const int of : {1, 2, 3, 7, 64}) {
      if (of > frames) continue;
      int next = 0;
      for (int k = 1; k <= of; ++k) {
        const FrameRange range = range_of({k, of}, frames);
        EXPECT_EQ(range.first, next) << k << '/' << of << " of " << frames;
        EXPECT_GE(range.count, frames / of);
        EXPECT_LE(range.count, frames / of + 1);
        next += range.count;
      }
      EXPECT_EQ(next, frames) << of;
    }
  }
}

TEST(Shard, NoneIsEmpty) {
  test::expect_input_error([] { range_of({1, 8}, 7); }, "--shard", "only 7 frames");
  EXPECT_EQ(range_of({7, 7}, 7).count, 1);
}

TEST(Shard, PiecesAreDealtOutInTurn) {
  EXPECT_EQ(pieces_of(Shard{1, 3}, 7, "rows"), (std::vector<long>{0, 3, 6}));
  EXPECT_EQ(pieces_of(Shard{3, 3}, 7, "rows"), (std::vector<long>{2, 5}));
  EXPECT_EQ(pieces_of({}, 3, "rows"), (std::vector<long>{0, 1, 2}));
  EXPECT_TRUE(pieces_of({}, 0, "rows").empty());
  test::expect_input_error([] { pieces_of(Shard{1, 8}, 7, "rows"); }, "--shard", "only 7 rows");
}

}  // namespace
}  // namespace polhode
