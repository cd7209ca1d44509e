// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <cstdlib>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/expect_error.h"
#include "support/full_disk.h"
#include "support/run.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

Image noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image image(width, height);
  for (std::uint8_t& value : image.pixels)
    value = static_cast<std::uint8_t>(random() & 255);
  return image;
}

TEST(Png, KeepsEveryByteWithAlpha) {
  const TemporaryFolder folder;
  const Image image = noise(37, 23, 1);
  write_png(folder / "a.png", image, true);
  const Image back = read_png(folder / "a.png");
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 23);
  EXPECT_EQ(back.pixels, image.pixels);
  EXPECT_EQ(folder.entries(), 1);
}

// 16 bits without a gamma are values like those of 8 bits, of which they keep the upper half
TEST(Png, SixteenBitsAreTheSamePicture) {
  const TemporaryFolder folder;
  const Image image = noise(20, 10, 3);
  write_png(folder / "a.png", image, false);
  const std::string command = "ffmpeg -nostdin -loglevel error -y -i '" + (folder / "a.png") +
                              "' -pix_fmt rgb48be '" + (folder / "b.png") + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const Image back = read_png(folder / "b.png");
  ASSERT_EQ(back.pixels.size(), image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    // the program that writes them rounds
    if (i % 4 == 3) continue;
    EXPECT_NEAR(back.pixels[i], image.pixels[i], 1) << i;
  }
}

// libpng would show other rows
TEST(Png, SixteenBitsWithInterlacingAreRefused) {
  std::string bytes = encode_png(noise(20, 10, 3), false);
  bytes[28] = 1;
  bytes[24] = 16;
  test::expect_error(
      [&] { decode_png(bytes, "a.png"); }, Fault::input, "", "save it without interlacing");
}

TEST(Png, WithoutAlphaIsOpaqueAndKeepsColour) {
  const TemporaryFolder folder;
  const Image image = noise(20, 10, 2);
  write_png(folder / "a.png", image, false);
  const Image back = read_png(folder / "a.png");
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    EXPECT_EQ(back.pixels[i], i % 4 == 3 ? 255 : image.pixels[i]);
  }
}

TEST(Png, WhatIsNoPngIsAnInputErrorThatNamesTheFile) {
  const TemporaryFolder folder;
  test::write_text(folder / "a.png", "not a picture");
  const std::string whole = [&] {
    write_png(folder / "b.png", noise(20, 10, 3), true);
    return test::read_text(folder / "b.png");
  }();
  test::write_text(folder / "cut.png", whole.substr(0, whole.size() / 2));
  test::write_text(folder / "end.png", whole.substr(0, whole.size() - 12));  // all pixels are there
  for (const char* name : {"a.png", "cut.png", "end.png", "missing.png"}) {
    try {
      read_png(folder / name);
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::input);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
    }
  }
}

TEST(Png, AnAnimationIsNoPicture) {
  const TemporaryFolder folder;
  write_png(folder / "a.png", noise(20, 10, 3), true);
  std::string bytes = test::read_text(folder / "a.png");
  // behind the header, that two pictures follow, and how often
  constexpr std::size_t kHeaderEnds = 33;
  bytes.insert(kHeaderEnds, std::string("\0\0\0\10acTL\0\0\0\2\0\0\0\0\0\0\0\0", 20));
  test::write_text(folder / "a.png", bytes);
  test::expect_input_error([&] { read_png(folder / "a.png"); }, "", "name it .apng");
}

// of an animation the number of its frames is one, how often it repeats is none
TEST(Png, TagsOfAnAnimationCountItsFrames) {
  const TemporaryFolder folder;
  write_png(folder / "a.png", noise(20, 10, 3), true);
  const std::string still = test::read_text(folder / "a.png");
  const auto tags = [&](char frames, char times) {
    std::string bytes = still;
    constexpr std::size_t kHeaderEnds = 33;
    std::string chunk("\0\0\0\10acTL\0\0\0\0\0\0\0\0\0\0\0\0", 20);
    chunk[11] = frames;
    chunk[15] = times;
    bytes.insert(kHeaderEnds, chunk);
    test::write_text(folder / "b.png", bytes);
    return png_tags(folder / "b.png");
  };
  EXPECT_EQ(tags(2, 0), tags(2, 1));
  EXPECT_NE(tags(2, 0), tags(3, 0));
}

// forty bytes may claim a picture of terabytes
TEST(Png, AnAbsurdSizeIsRefusedBeforeItIsBelieved) {
  const TemporaryFolder folder;
  write_png(folder / "a.png", noise(16, 16, 6), true);
  std::string bytes = test::read_text(folder / "a.png");
  // 983,040 x 983,040, and the checksum of that header
  bytes.replace(16, 8, std::string("\0\x0f\0\0\0\x0f\0\0", 8));
  std::uint32_t sum = 0xffffffffu;
  for (std::size_t i = 12; i < 29; ++i) {
    sum ^= static_cast<unsigned char>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit)
      sum = sum >> 1 ^ ((sum & 1) != 0 ? 0xedb88320u : 0u);
  }
  for (std::size_t i = 0; i < 4; ++i)
    bytes[29 + i] = static_cast<char>(~sum >> (24 - 8 * i) & 255);
  test::write_text(folder / "a.png", bytes);
  test::expect_input_error([&] { read_png(folder / "a.png"); }, "", "983040x983040");
}

TEST(Png, AFullDiskIsAnErrorThatSaysSoAndLeavesNothing) {
  const TemporaryFolder folder;
  const Image image = noise(64, 64, 7);
  write_png(folder / "a.png", image, true);
  const auto whole = static_cast<rlim_t>(std::filesystem::file_size(folder / "a.png"));
  for (const rlim_t most : {rlim_t{0}, rlim_t{100}, whole / 2, whole - 1}) {
    const auto make = [&] {
      write_png(folder / "b.png", image, true);
    };
    EXPECT_EQ(test::with_full_disk(most, make), test::Outcome::environment) << most;
    EXPECT_EQ(folder.entries(), 1) << most;
  }
}

TEST(Png, AnUnwritablePlaceLeavesNothing) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_png(folder / "nowhere/a.png", noise(4, 4, 4), true), Error);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace polhode
