// SPDX-License-Identifier: MIT
// Which frames a name stands for, and in which order.
#include "video/frame_source.h"

#include <filesystem>

#include "image/png.h"
#include "support/expect_error.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

class FrameSourceNames : public ::testing::Test {
 protected:
  // a picture of one pixel, as grey as its level
  void picture(const std::string& name, int level) const {
    Image image(1, 1);
    image.pixels.assign(4, static_cast<std::uint8_t>(level));
    write_png(folder_ / name, image, false);
  }
  std::vector<std::string> labels(const std::string& name) const {
    const std::unique_ptr<FrameSource> source = open_frames(folder_ / name);
    const std::vector<std::string> all = source->info().labels;
    // and they come in this order
    SourceFrame frame;
    for (const std::string& label : all) {
      EXPECT_TRUE(source->next(frame));
      EXPECT_EQ(frame.label, label);
    }
    EXPECT_FALSE(source->next(frame));
    return all;
  }
  void refuses(const std::string& name, const std::string& says) const {
    test::expect_input_error([&] { open_frames(folder_ / name); }, "", says);
  }

  TemporaryFolder folder_;
};

using Labels = std::vector<std::string>;

TEST_F(FrameSourceNames, AFolderGoesByNumbersInItsNames) {
  for (const char* name : {"f10.png", "f2.png", "f02b.png", "a.PNG", "f.png"})
    picture(name, 10);
  test::write_text(folder_ / "notes.txt", "no picture");
  std::filesystem::create_directory(folder_ / "folder.png");
  EXPECT_EQ(labels("."), (Labels{"a.PNG", "f.png", "f2.png", "f02b.png", "f10.png"}));
}

TEST_F(FrameSourceNames, ANumberedNameIsEveryNumberThatItWouldWrite) {
  for (const char* name :
       {"f_007.png", "f_010.png", "f_1000.png", "f_7.png", "f_0011.png", "f_x.png"})
    picture(name, 10);
  EXPECT_EQ(labels("f_%03d.png"), (Labels{"7", "10", "1000"}));
  EXPECT_EQ(labels("f_%d.png"), (Labels{"7", "1000"}));
  // of any size
  for (const char* name :
       {"g_12345678901234567890123.png", "g_2147483648.png", "g_000.png", "g_0.png"})
    picture(name, 10);
  EXPECT_EQ(labels("g_%03d.png"), (Labels{"0", "2147483648", "12345678901234567890123"}));
  refuses("h_%03d.png", "picture does not exist");
  refuses("nowhere/f_%03d.png", "does not exist");
}

// a file that is there is that file, whatever its name looks like
TEST_F(FrameSourceNames, AFileIsAFile) {
  picture("take_%02d.png", 10);
  EXPECT_EQ(labels("take_%02d.png"), (Labels{""}));
}

TEST_F(FrameSourceNames, WhatIsNoSourceIsRefused) {
  refuses("nothing.png", "file does not exist");
  std::filesystem::create_directory(folder_ / "empty");
  refuses("empty", "no .png files");
  test::write_text(folder_ / "notes.txt", "text");
  refuses("notes.txt", "is not a picture");
}

}  // namespace
}  // namespace polhode
