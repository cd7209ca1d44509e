// SPDX-License-Identifier: MIT
#include "video/video_spec.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace polhode {
namespace {

TEST(VideoSpec, FrameRatesAreRatiosInLowestTerms) {
  EXPECT_EQ(parse_frame_rate("60"), (FrameRate{60, 1}));
  EXPECT_EQ(parse_frame_rate("30000/1001"), (FrameRate{30000, 1001}));
  EXPECT_EQ(parse_frame_rate("120/2"), (FrameRate{60, 1}));
  EXPECT_DOUBLE_EQ(parse_frame_rate("25/2").value(), 12.5);
  EXPECT_EQ(parse_frame_rate("60.0"), (FrameRate{60, 1}));
  EXPECT_EQ(parse_frame_rate("1e3"), (FrameRate{1000, 1}));
}

TEST(VideoSpec, DecimalRatesAreRefusedWithTheExactRatio) {
  for (const auto& [text, ratio] : {std::pair{"29.97", "30000/1001"},
                                    {"23.976", "24000/1001"},
                                    {"59.94", "60000/1001"},
                                    {"12.5", "25/2"}}) {
    try {
      parse_frame_rate(text);
      FAIL() << text;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(ratio), std::string::npos) << error.what();
    }
  }
}

TEST(VideoSpec, NonsenseIsNoFrameRate) {
  for (const char* text : {"",
                           "0",
                           "-1",
                           "1001",
                           "1/0",
                           "0/5",
                           "1/3",
                           "60/",
                           "/60",
                           "60/1/1",
                           "sixty",
                           "60 ",
                           "1e4",
                           "nan",
                           "inf",
                           "99999999999",
                           "0x10"}) {
    EXPECT_THROW(parse_frame_rate(text), Error) << text;
  }
}

TEST(VideoSpec, PictureSizesAreTwoSides) {
  EXPECT_EQ(parse_picture_size("1920x1080"), (PictureSize{1920, 1080}));
  EXPECT_EQ(parse_picture_size("16x16384"), (PictureSize{16, 16384}));
}

TEST(VideoSpec, NonsenseIsNoPictureSize) {
  for (const char* text : {"",
                           "1920",
                           "x",
                           "1920x",
                           "x1080",
                           "1920X1080",
                           "1920x1080x3",
                           "-16x16",
                           "15x16",
                           "16x16385",
                           "99999999999x16",
                           "1e3x16",
                           " 16x16",
                           "16.5x16"}) {
    EXPECT_THROW(parse_picture_size(text), Error) << text;
  }
}

}  // namespace
}  // namespace polhode
