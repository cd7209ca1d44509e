// SPDX-License-Identifier: MIT
#include "app/compare/frame_pairs.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/flat_image.h"

namespace polhode {
namespace {

// Frames from memory: one for each label, of grey levels 10, 11, 12, …
class MadeFrames final : public FrameSource {
 public:
  MadeFrames(SourceKind kind, const std::vector<std::string>& labels) {
    info_.kind = kind;
    info_.labels = labels;
    info_.frames = static_cast<int>(labels.size());
  }
  // a film of so many frames, the rate told, the first at `start`
  MadeFrames(int frames, FrameRate fps, double start = 0.0) : start_(start) {
    info_.kind = SourceKind::film;
    info_.fps = fps;
    info_.frames = frames;
  }

  const SourceInfo& info() const override { return info_; }
  bool next(SourceFrame& frame) override {
    if (given_ == broken_at) throw input_error("is damaged");
    if (given_ == info_.frames) return false;
    frame.image = test::flat_image(size.width, size.height, 10 + given_, 10 + given_, 10 + given_);
    frame.label = info_.labels.empty() ? "" : info_.labels.at(static_cast<std::size_t>(given_));
    frame.time = start_ + given_ / info_.fps.value();
    ++given_;
    return true;
  }

  PictureSize size{4, 2};
  int broken_at = -1;

 private:
  SourceInfo info_;
  double start_ = 0.0;
  int given_ = 0;
};

std::unique_ptr<MadeFrames> folder(const std::vector<std::string>& labels) {
  return std::make_unique<MadeFrames>(SourceKind::folder, labels);
}
std::unique_ptr<MadeFrames> film(int frames, FrameRate fps = {10, 1}, double start = 0.0) {
  return std::make_unique<MadeFrames>(frames, fps, start);
}

// reads all pairs; their number, or what was wrong behind how many of them
std::string outcome_of(std::unique_ptr<FrameSource> a,
                       std::unique_ptr<FrameSource> b,
                       bool by_order = false) {
  int pairs = 0;
  try {
    FramePairs both("A", std::move(a), "B", std::move(b), by_order);
    SourceFrame left, right;
    for (; both.next(left, right); ++pairs) {
      EXPECT_EQ(left.image.at(0, 0)[0], 10 + pairs);
      EXPECT_EQ(right.image.at(0, 0)[0], 10 + pairs);
    }
    return fmt::format("{} pairs", pairs);
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::input);
    return fmt::format("{} pairs, then {}", pairs, error.what());
  }
}

// many more than are read ahead
TEST(FramePairs, FilmsOfOneClockArePairedToTheirEnd) {
  EXPECT_EQ(outcome_of(film(40), film(40)), "40 pairs");
  EXPECT_EQ(FramePairs("A", film(3), "B", film(5)).count(), 5);
}

// half of the shorter frame time is what may be between them
TEST(FramePairs, FilmsArePairedByTime) {
  EXPECT_EQ(outcome_of(film(5), film(5, {10, 1}, 0.049)), "5 pairs");
  EXPECT_EQ(outcome_of(film(5), film(5, {10, 1}, 0.051)),
            "0 pairs, then A: shows a frame at 0.0000 s, B shows none then");
  EXPECT_EQ(outcome_of(film(9), film(9, {20, 1})),
            "1 pairs, then B: shows a frame at 0.0500 s, A shows none then");
  EXPECT_EQ(outcome_of(film(9), film(9, {20, 1}), true), "9 pairs") << "times do not count";
}

TEST(FramePairs, AFrameWithoutAPartnerIsAnError) {
  EXPECT_EQ(outcome_of(film(5), film(3)), "3 pairs, then B: has 3 frames, A has more");
  EXPECT_EQ(outcome_of(film(1), film(3)), "1 pairs, then A: has 1 frame, B has more");
}

// known before any is read
TEST(FramePairs, PicturesOfAFolderArePairedByName) {
  EXPECT_EQ(outcome_of(folder({"a", "b"}), folder({"a", "b"})), "2 pairs");
  EXPECT_EQ(outcome_of(folder({"a", "b"}), folder({"a", "c"})),
            "0 pairs, then B: has no picture 'b', which A has");
  EXPECT_EQ(outcome_of(folder({"a"}), folder({"a", "c"})),
            "0 pairs, then A: has no picture 'c', which B has");
  EXPECT_EQ(outcome_of(folder({"a", "b"}), folder({"a", "c"}), true), "2 pairs");
  const auto numbered = [](const std::vector<std::string>& labels) {
    return std::make_unique<MadeFrames>(SourceKind::numbered, labels);
  };
  EXPECT_EQ(outcome_of(numbered({"1", "2"}), numbered({"1", "3"})),
            "0 pairs, then B: has no number '2', which A has");
  EXPECT_EQ(outcome_of(numbered({"1", "2"}), folder({"a", "b"})), "2 pairs") << "by their order";
  EXPECT_EQ(outcome_of(numbered({"1", "2"}), folder({"a"})),
            "0 pairs, then B: has 1 frame, A has more");
}

// a film and its pictures: by order, and known only at the end
TEST(FramePairs, AFilmIsPairedWithPicturesByOrder) {
  EXPECT_EQ(outcome_of(film(2), folder({"a", "b"})), "2 pairs");
  EXPECT_EQ(outcome_of(folder({"a", "b", "c"}), film(2)),
            "2 pairs, then B: has 2 frames, A has more");
}

TEST(FramePairs, FramesOfOtherSizesAreRefused) {
  auto large = film(2);
  large->size = {8, 6};
  EXPECT_EQ(outcome_of(film(2), std::move(large)), "0 pairs, then A: is 4x2 pixels, B is 8x6");
}

// what comes before the damage is still compared
TEST(FramePairs, AnErrorWaitsBehindTheFramesBeforeIt) {
  auto broken = film(10);
  broken->broken_at = 4;
  EXPECT_EQ(outcome_of(std::move(broken), film(10)), "4 pairs, then is damaged");
}

// the threads that read ahead end with the object
TEST(FramePairs, NotAllFramesNeedBeRead) {
  FramePairs both("A", film(1000), "B", film(1000));
  SourceFrame a, b;
  EXPECT_TRUE(both.next(a, b));
}

}  // namespace
}  // namespace polhode
