// SPDX-License-Identifier: MIT
// Hashes, and nothing at all.
#include "video/plain_sinks.h"

#include "base/error.h"
#include "support/full_disk.h"
#include "support/run.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

Image frame(int index) {
  Image image(8, 6);
  for (std::uint8_t& value : image.pixels)
    value = static_cast<std::uint8_t>(index * 7 + 1);
  return image;
}

SinkJob job_for(const std::string& output) {
  SinkJob job;
  job.output = output;
  job.width = 8;
  job.height = 6;
  job.transparent = true;
  return job;
}

TEST(PlainSinks, AFullDiskIsAnErrorAndLeavesNothing) {
  const TemporaryFolder folder;
  const auto make = [&] {
    const auto sink = make_sink(job_for(folder / "a.hash"));
    sink->push(frame(0));
    sink->push(frame(1));
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
    const auto sink = make_sink(job_for(folder / "a.hash"));
    for (const Image& image : frames)
      sink->push(image);
    sink->finish();
    return test::read_text(folder / "a.hash");
  };
  Image changed = frame(1);
  changed.pixels.back() ^= 1;
  const std::string first = lines_of({frame(0), frame(1)});
  EXPECT_EQ(first, lines_of({frame(0), frame(1)}));
  EXPECT_NE(first, lines_of({frame(0), changed}));
  EXPECT_EQ(first.rfind("0 8x6 ", 0), 0u);
  EXPECT_NE(first.find("\n1 8x6 "), std::string::npos);
}

TEST(PlainSinks, AHashFileHasAFormWithoutEnding) {
  const TemporaryFolder folder;
  for (const char* name : {"frames.txt", "frames.mp4", "frames.png", "frames"}) {
    const auto sink = make_sink(job_for("hash:" + (folder / name)));
    sink->push(frame(0));
    sink->finish();
    EXPECT_EQ(test::read_text(folder / name).rfind("0 8x6 ", 0), 0u) << name;
  }
  EXPECT_THROW(make_sink(job_for("hash:")), Error);
}

TEST(PlainSinks, NullWritesNothing) {
  const auto sink = make_sink(job_for("null"));
  sink->push(frame(0));
  sink->finish();
  EXPECT_FALSE(std::filesystem::exists("null"));
}

// the list has what a hash file would have, in whichever format the film is
TEST(PlainSinks, HashesAreListedBesideAnySink) {
  const TemporaryFolder folder;
  std::vector<std::string> hashes;
  const auto sink = with_hashes(make_sink(job_for(folder / "a.hash")), hashes);
  for (int i = 0; i < 3; ++i)
    sink->push(frame(i));
  sink->finish();
  ASSERT_EQ(hashes.size(), 3u);
  std::string lines;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(hashes[static_cast<std::size_t>(i)], frame_hash(frame(i)));
    lines += std::to_string(i) + " 8x6 " + frame_hash(frame(i)) + "\n";
  }
  EXPECT_EQ(test::read_text(folder / "a.hash"), lines);
}

}  // namespace
}  // namespace polhode
