// SPDX-License-Identifier: MIT
// Hashes, and nothing at all.
#include "video/plain_sinks.h"

#include "base/error.h"
#include "support/full_disk.h"
#include "support/run.h"
#include "video/sink_kinds.h"
#include "video/small_frames.h"

namespace polhode {
namespace {

using test::small_frame;
using test::small_job;
using test::TemporaryFolder;

TEST(PlainSinks, AFullDiskIsAnErrorAndLeavesNothing) {
  const TemporaryFolder folder;
  const auto make = [&] {
    const auto sink = make_sink(small_job(folder / "a.hash"));
    sink->push(small_frame(0));
    sink->push(small_frame(1));
    sink->finish();
  };
  EXPECT_EQ(test::with_full_disk(20, make), test::Outcome::environment);
  EXPECT_EQ(folder.entries(), 0);
  EXPECT_EQ(test::with_full_disk(100000, make), test::Outcome::done);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(PlainSinks, AHashFileHasALinePerFrameThatDependsOnEveryByte) {
  const TemporaryFolder folder;
  const auto lines_of = [&](const std::vector<Image>& frames) {
    const auto sink = make_sink(small_job(folder / "a.hash"));
    for (const Image& image : frames)
      sink->push(image);
    sink->finish();
    return test::read_text(folder / "a.hash");
  };
  Image changed = small_frame(1);
  changed.pixels.back() ^= 1;
  const std::string first = lines_of({small_frame(0), small_frame(1)});
  EXPECT_EQ(first, lines_of({small_frame(0), small_frame(1)}));
  EXPECT_NE(first, lines_of({small_frame(0), changed}));
  EXPECT_EQ(first.rfind("0 8x6 ", 0), 0u);
  EXPECT_NE(first.find("\n1 8x6 "), std::string::npos);
}

TEST(PlainSinks, AHashFileHasAFormWithoutEnding) {
  const TemporaryFolder folder;
  for (const char* name : {"frames.txt", "frames.mp4", "frames.png", "frames"}) {
    const auto sink = make_sink(small_job("hash:" + (folder / name)));
    sink->push(small_frame(0));
    sink->finish();
    EXPECT_EQ(test::read_text(folder / name).rfind("0 8x6 ", 0), 0u) << name;
  }
  EXPECT_THROW(make_sink(small_job("hash:")), Error);
  EXPECT_THROW(make_sink(small_job("hash:-")), Error);
}

TEST(PlainSinks, NullWritesNothing) {
  const auto sink = make_sink(small_job("null"));
  sink->push(small_frame(0));
  sink->finish();
  EXPECT_FALSE(std::filesystem::exists("null"));
}

// the list has what a hash file would have, in whichever format the film is
TEST(PlainSinks, HashesAreListedBesideAnySink) {
  const TemporaryFolder folder;
  std::vector<std::string> hashes;
  const auto sink = with_hashes(make_sink(small_job(folder / "a.hash")), hashes);
  for (int i = 0; i < 3; ++i)
    sink->push(small_frame(i));
  sink->finish();
  ASSERT_EQ(hashes.size(), 3u);
  std::string lines;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(hashes[static_cast<std::size_t>(i)], frame_hash(small_frame(i)));
    lines += std::to_string(i) + " 8x6 " + frame_hash(small_frame(i)) + "\n";
  }
  EXPECT_EQ(test::read_text(folder / "a.hash"), lines);
}

}  // namespace
}  // namespace polhode
