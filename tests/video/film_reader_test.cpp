// SPDX-License-Identifier: MIT
// Films that we write, read again.
#include "video/film_reader.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "base/error.h"
#include "image/compare.h"
#include "support/expect_error.h"
#include "support/flat_image.h"
#include "support/run.h"
#include "video/decoded_film.h"
#include "video/sink_kinds.h"

namespace polhode {
namespace {

using test::TemporaryFolder;

Image flat(int r, int g, int b) {
  return test::flat_image(64, 48, r, g, b);
}

void write_film(const std::string& file,
                const std::vector<Image>& frames,
                FrameRate fps = {25, 1}) {
  SinkJob job;
  job.output = file;
  job.width = frames.at(0).width;
  job.height = frames.at(0).height;
  job.fps = fps;
  const std::unique_ptr<FrameSink> sink = make_sink(job);
  for (const Image& frame : frames)
    sink->push(frame);
  sink->finish();
}

std::vector<Image> ramp(int count) {
  std::vector<Image> frames;
  for (int i = 0; i < count; ++i)
    frames.push_back(flat(20 + 5 * i, 100, 200 - 4 * i));
  return frames;
}

TEST(FilmReader, GivesFramesInOrderWithTheirTimes) {
  const TemporaryFolder folder;
  for (const FrameRate fps : {FrameRate{25, 1}, FrameRate{30000, 1001}}) {
    const std::vector<Image> frames = ramp(30);
    write_film(folder / "a.mp4", frames, fps);
    FilmReader reader(folder / "a.mp4");
    EXPECT_EQ(reader.info().width, 64);
    EXPECT_EQ(reader.info().height, 48);
    EXPECT_EQ(reader.info().frames, 30);
    EXPECT_EQ(reader.info().fps, fps);
    EXPECT_EQ(reader.info().codec, "h264");
    EXPECT_FALSE(reader.info().alpha);
    Image image;
    double time = -1.0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      ASSERT_TRUE(reader.next(image, time)) << i;
      EXPECT_NEAR(time, static_cast<double>(i) / fps.value(), 1e-6);
      EXPECT_LE(compare(image, frames[i], 0).largest, 3) << i;
    }
    EXPECT_FALSE(reader.next(image, time));
  }
}

// swscale writes beyond pictures whose width is no multiple of 16; what lay there was lost
TEST(FilmReader, WritesNothingBehindAPicture) {
  const TemporaryFolder folder;
  for (const int width : {24, 72, 74, 76, 78, 426}) {
    for (const int height : {16, 64}) {
      const Image gray = test::flat_image(width, height, 90, 90, 90);
      write_film(folder / "a.mp4", {gray, gray, gray});
      FilmReader reader(folder / "a.mp4");
      Image image(width, height);
      // room behind the pixels shows it
      constexpr std::size_t kRoom = 64;
      std::vector<std::uint8_t> bytes(image.pixels.size() + kRoom, 0xA5);
      bytes.resize(image.pixels.size());
      image.pixels.swap(bytes);
      double time = 0.0;
      while (reader.next(image, time)) {
        const std::uint8_t* behind = image.pixels.data() + image.pixels.size();
        for (std::size_t i = 0; i < kRoom; ++i)
          ASSERT_EQ(behind[i], 0xA5) << width << "x" << height << ", " << i;
        EXPECT_LE(compare(image, gray, 0).largest, 3);
      }
    }
  }
}

void make_foreign(const std::string& filter,
                  const std::string& file,
                  const std::string& options = "") {
  const std::string command = "ffmpeg -nostdin -loglevel error -y -f lavfi -i \"" + filter +
                              "\" -frames:v 2 -c:v ffv1 " + options + " '" + file + "'";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

Image first_picture(const std::string& file) {
  FilmReader reader(file);
  Image image;
  double time = 0.0;
  if (!reader.next(image, time)) throw std::runtime_error(file + " has no picture");
  return image;
}

TEST(FilmReader, EveryColumnHasItsOwnColour) {
  const TemporaryFolder folder;
  for (const std::string format : {"yuv444p", "yuv440p"}) {
    make_foreign(
        "color=gray:s=16x16,format=" + format + ",geq=lum=128:cb='if(mod(X,2),128,220)':cr=128",
        folder / "a.mkv");
    const Image image = first_picture(folder / "a.mkv");
    EXPECT_GT(image.at(4, 8)[2], image.at(5, 8)[2] + 100) << format;
    EXPECT_NEAR(image.at(5, 8)[2], image.at(5, 8)[0], 3) << format;
  }
}

// ITU-R BT.601: blocks of pixels share a colour, at the edges with less than they have elsewhere
TEST(FilmReader, EveryPixelHasTheColourOfItsBlock) {
  const TemporaryFolder folder;
  struct Blocks {
    const char* format;
    int across, down;  // pixels
    int scale;         // of values that have more than 8 bits
  };
  for (const auto& [format, across, down, scale] : {Blocks{"yuv444p", 1, 1, 1},
                                                    {"yuv440p", 1, 2, 1},
                                                    {"yuv422p", 2, 1, 1},
                                                    {"yuv420p", 2, 2, 1},
                                                    {"yuv420p10", 2, 2, 4},
                                                    {"yuv411p", 4, 1, 1},
                                                    {"yuv410p", 4, 4, 1}}) {
    for (const char* size : {"40x24", "33x21", "38x23"}) {
      make_foreign(
          fmt::format("color=gray:s={0},format={1},geq=lum=128*{2}:cb='{2}*if(mod(X,2),100,180)':"
                      "cr='{2}*if(mod(Y,2),110,150)'",
                      size,
                      format,
                      scale),
          folder / "a.mkv");
      const Image image = first_picture(folder / "a.mkv");
      for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
          const double light = (128.0 - 16.0) / 219.0,
                       blue = ((x / across % 2 == 1 ? 100.0 : 180.0) - 128.0) / 224.0,
                       red = ((y / down % 2 == 1 ? 110.0 : 150.0) - 128.0) / 224.0;
          const double expected[] = {
              light + 1.402 * red, light - 0.344136 * blue - 0.714136 * red, light + 1.772 * blue};
          for (int k = 0; k < 3; ++k)
            ASSERT_NEAR(image.at(x, y)[k], 255.0 * expected[k], 0.6)
                << format << " " << size << " at " << x << ", " << y;
        }
      }
    }
  }
}

// a limited range has room for twice the brightest blue, of which swscale makes black
TEST(FilmReader, ColoursBeyondTheBrightestAreCutOff) {
  const TemporaryFolder folder;
  for (const auto& [format, scale] :
       std::vector<std::pair<std::string, int>>{{"yuv444p", 1}, {"yuv420p10le", 4}}) {
    make_foreign(fmt::format("nullsrc=s=16x16,format={},geq=lum='255*{}':cb='255*{}':cr='128*{}'",
                             format,
                             scale,
                             scale,
                             scale),
                 folder / "a.mkv",
                 "-colorspace bt709 -color_range tv");
    const Image image = first_picture(folder / "a.mkv");
    // ITU-R BT.709
    const double green = 255.0 * (239.0 / 219.0 - 0.187324 * 127.0 / 224.0);
    EXPECT_EQ(image.at(8, 8)[0], 255) << format;
    EXPECT_NEAR(image.at(8, 8)[1], green, 0.6) << format;
    EXPECT_EQ(image.at(8, 8)[2], 255) << format;
  }
}

// what each frame says counts, not what the first one does
TEST(FilmReader, TagsMayChangeWithinAFilm) {
  const TemporaryFolder folder;
  const std::string ffmpeg = "ffmpeg -nostdin -loglevel error -y ";
  std::string bytes;
  for (const char* tags : {"matrix_coefficients=1", "matrix_coefficients=6"}) {
    ASSERT_EQ(std::system((ffmpeg +
                           "-f lavfi -i color=0x20c040:s=32x32 -frames:v 2 -pix_fmt yuv420p "
                           "-c:v libx264 -qp 0 -bsf:v h264_metadata=" +
                           tags + " '" + (folder / "part.h264") + "'")
                              .c_str()),
              0);
    bytes += test::read_text(folder / "part.h264");
  }
  test::write_text(folder / "both.h264", bytes);
  ASSERT_EQ(std::system((ffmpeg + "-r 10 -i '" + (folder / "both.h264") + "' -c copy '" +
                         (folder / "both.mkv") + "'")
                            .c_str()),
            0);
  FilmReader reader(folder / "both.mkv");
  std::vector<Image> frames(4);
  std::vector<std::string> shown;
  double time = 0.0;
  for (Image& frame : frames) {
    ASSERT_TRUE(reader.next(frame, time));
    shown.push_back(reader.frame_shown());
  }
  EXPECT_EQ(shown[0], shown[1]);
  EXPECT_TRUE(shown[1].ends_with(" bt709")) << shown[1];
  EXPECT_TRUE(shown[2].ends_with(" smpte170m")) << shown[2];
  EXPECT_EQ(compare(frames[0], frames[1], 0).largest, 0);
  EXPECT_GT(compare(frames[1], frames[2], 0).largest, 10);
}

TEST(FilmReader, GrayOfLimitedRangeIsReadSo) {
  const TemporaryFolder folder;
  for (const auto& [format, value] : std::vector<std::pair<std::string, int>>{
           {"gray", 16}, {"gray10le", 16 << 2}, {"gray16le", 16 << 8}}) {
    make_foreign(fmt::format("nullsrc=s=16x16,format={},geq=lum={}", format, value),
                 folder / "a.mkv",
                 "-color_range tv");
    const Image image = first_picture(folder / "a.mkv");
    EXPECT_EQ(image.at(8, 8)[0], 0) << format;
  }
}

TEST(FilmReader, UnknownMatricesAreRefused) {
  const TemporaryFolder folder;
  make_foreign("color=gray:s=16x16,format=yuv444p", folder / "a.mkv", "-colorspace ycgco");
  FilmReader reader(folder / "a.mkv");
  Image image;
  double time = 0.0;
  try {
    reader.next(image, time);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("'ycgco'"), std::string::npos) << error.message();
  }
}

// as libav has it for 8 bits
TEST(FilmReader, GrayIsFullUnlessItSaysOtherwise) {
  const TemporaryFolder folder;
  for (const auto& [format, value] : std::vector<std::pair<std::string, int>>{
           {"gray", 8}, {"gray10le", 8 << 2}, {"gray12le", 8 << 4}, {"gray16le", 8 << 8}}) {
    make_foreign(fmt::format("nullsrc=s=16x16,format={},geq=lum={}", format, value),
                 folder / "a.mkv");
    const Image image = first_picture(folder / "a.mkv");
    EXPECT_NEAR(image.at(8, 8)[0], 8, 1) << format;
  }
}

TEST(FilmReader, TellsWhereColoursAreIfNotAtTheLeft) {
  const TemporaryFolder folder;
  const std::string command =
      "ffmpeg -nostdin -loglevel error -y -f lavfi -i color=gray:s=32x32 -frames:v 2 -pix_fmt "
      "yuv420p -c:v libx264 ";
  ASSERT_EQ(std::system((command + "'" + (folder / "a.mp4") + "'").c_str()), 0);
  ASSERT_EQ(std::system((command + "-bsf:v h264_metadata=chroma_sample_loc_type=2 '" +
                         (folder / "b.mp4") + "'")
                            .c_str()),
            0);
  EXPECT_EQ(FilmReader(folder / "a.mp4").info().shown.find("colours at"), std::string::npos);
  EXPECT_NE(FilmReader(folder / "b.mp4").info().shown.find(", colours at topleft"),
            std::string::npos);
}

// the tag that WebM has for what is kept beside the colours; here it is in the pictures
TEST(FilmReader, OtherCodecsMayHaveTransparencyToo) {
  const TemporaryFolder folder;
  make_foreign("color=red:s=16x16,format=yuva420p", folder / "a.mkv");
  FilmReader reader(folder / "a.mkv");
  EXPECT_TRUE(reader.info().alpha);
  Image image;
  double time = 0.0;
  EXPECT_TRUE(reader.next(image, time));
}

// of a picture that was used for something else before, every pixel is new
TEST(FilmReader, AReusedPictureKeepsNoGround) {
  const TemporaryFolder folder;
  write_film(folder / "a.mp4", ramp(2));
  FilmReader reader(folder / "a.mp4");
  Image image;
  image.wipe(64, 48, {0, 0, 0, 255});
  image.painted.push_back({0, 0, 8, 8});
  double time = 0.0;
  ASSERT_TRUE(reader.next(image, time));
  EXPECT_FALSE(image.ground);
  EXPECT_TRUE(image.painted.empty());
}

// the fast conversion stays within a few levels of the careful one of the tests
// WebM has it beside the colours, where FFmpeg's own decoder does not look
TEST(FilmReader, SeesTransparencyInEveryFormatThatHasIt) {
  for (const Way& way : test::all_ways()) {
    if (!way.encoder->alpha) continue;
    SCOPED_TRACE(way.name());
    const TemporaryFolder folder;
    SinkJob job = test::job_for(folder, way, {25, 1});
    job.transparent = true;
    {
      const std::unique_ptr<FrameSink> sink = make_sink(job);
      Image clear(job.width, job.height);
      for (int x = 0; x < job.width * job.height; ++x)
        clear.pixels[static_cast<std::size_t>(4 * x + 3)] = x % job.width < 20 ? 255 : 0;
      for (int i = 0; i < 3; ++i)
        sink->push(clear);
      sink->finish();
    }
    FilmReader reader(job.output);
    Image frame;
    double time = 0.0;
    ASSERT_TRUE(reader.next(frame, time));
    EXPECT_TRUE(reader.info().alpha);
    EXPECT_GT(frame.at(10, 10)[3], 200);
    EXPECT_LT(frame.at(50, 10)[3], 50);
  }
}

TEST(FilmReader, ColoursAreThoseOfAPlayer) {
  const TemporaryFolder folder;
  const std::vector<Image> frames = {
      flat(255, 0, 0), flat(0, 255, 0), flat(0, 0, 255), flat(240, 165, 30), flat(16, 20, 28)};
  write_film(folder / "a.mp4", frames);
  const test::DecodedFilm wanted = test::decode(folder / "a.mp4");
  FilmReader reader(folder / "a.mp4");
  Image image;
  double time = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    ASSERT_TRUE(reader.next(image, time));
    EXPECT_LE(compare(image, wanted.frames[i], 0).largest, 3) << i;
    EXPECT_LE(compare(image, frames[i], 0).largest, 4) << i;
  }
}

TEST(FilmReader, SaysWhatCannotBeRead) {
  const TemporaryFolder folder;
  const auto open = [&](const std::string& name) {
    return [file = folder / name] {
      FilmReader{file};
    };
  };
  test::expect_input_error(open("nothing.mp4"), "", "file does not exist");
  std::filesystem::create_directory(folder / "folder.mp4");
  test::expect_input_error(open("folder.mp4"), "", "folder");
  test::write_text(folder / "text.mp4", "this is no film");
  test::expect_input_error(open("text.mp4"), "", "not a readable film");
  test::write_text(folder / "empty.mp4", "");
  test::expect_input_error(open("empty.mp4"), "", "not a readable film");
  // libav would read other files in its place, under whatever name
  test::write_text(folder / "list.mp4", "ffconcat version 1.0\nfile empty.mp4\n");
  test::expect_input_error(open("list.mp4"), "", "it is no MP4");
}

void read_whole(const std::string& file) {
  FilmReader reader(file);
  Image image;
  double time = 0.0;
  while (reader.next(image, time)) {
  }
}

// however much of it is missing or wrong, a damaged film never passes for a whole one
TEST(FilmReader, ATruncatedFilmIsDamaged) {
  const TemporaryFolder folder;
  write_film(folder / "whole.mp4", ramp(40));
  const std::string bytes = test::read_text(folder / "whole.mp4");
  for (const double share : {0.05, 0.3, 0.6, 0.9, 0.99}) {
    const auto length = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
    test::write_text(folder / "cut.mp4", bytes.substr(0, length));
    SCOPED_TRACE(share);
    test::expect_input_error([&] { read_whole(folder / "cut.mp4"); }, "", "");
  }
}

// libav's decoder of ProRes passes on a picture although a part of it could not be decoded
TEST(FilmReader, AFrameOfWhichAPartIsLostIsDamaged) {
  const TemporaryFolder folder;
  std::vector<Image> frames = ramp(1);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x)
      frames[0].at(x, y)[0] = static_cast<std::uint8_t>(x * x + y * y * y);
  }
  write_film(folder / "whole.mov", frames);
  EXPECT_NO_THROW(read_whole(folder / "whole.mov"));
  const std::string bytes = test::read_text(folder / "whole.mov");
  const std::size_t picture = bytes.find("icpf");
  ASSERT_NE(picture, std::string::npos);
  int damaged = 0;
  for (std::size_t at = picture + 500; at < picture + 1500; at += 50) {
    std::string altered = bytes;
    altered.replace(at, 8, 8, '\0');
    test::write_text(folder / "damaged.mov", altered);
    try {
      read_whole(folder / "damaged.mov");
    } catch (const Error& error) {
      EXPECT_NE(error.message().find("is damaged after frame"), std::string::npos);
      ++damaged;
    }
  }
  EXPECT_EQ(damaged, 20);
}

// libav's decoder of MPEG-4 part 2 ends the program where it is to refuse damage
TEST(FilmReader, DamagedMpeg4IsRefused) {
  const TemporaryFolder folder;
  ASSERT_EQ(
      std::system(("ffmpeg -nostdin -loglevel error -y -f lavfi -i testsrc=s=64x48:r=10:d=1.2 "
                   "-c:v mpeg4 -g 6 '" +
                   (folder / "whole.mp4") + "'")
                      .c_str()),
      0);
  EXPECT_NO_THROW(read_whole(folder / "whole.mp4"));
  const std::string bytes = test::read_text(folder / "whole.mp4");
  const std::size_t pictures = bytes.find("mdat") + 4, end = bytes.find("moov");
  constexpr std::size_t kDamage = 100;
  for (std::size_t at = pictures; at + kDamage < end; at += kDamage) {
    std::string altered = bytes;
    altered.replace(at, kDamage, kDamage, '\0');
    test::write_text(folder / "damaged.mp4", altered);
    SCOPED_TRACE(at);
    test::expect_input_error([&] { read_whole(folder / "damaged.mp4"); }, "", "is damaged");
  }
}

// libav's decoder of GIF tells the log of damage, and passes on what it has of the picture
TEST(FilmReader, DamagedGifIsRefused) {
  const TemporaryFolder folder;
  make_foreign("testsrc=s=64x48:r=10:d=1", folder / "whole.gif", "-c:v gif -pix_fmt rgb8");
  EXPECT_NO_THROW(read_whole(folder / "whole.gif"));
  const std::string bytes = test::read_text(folder / "whole.gif");
  int damaged = 0, tried = 0;
  constexpr std::size_t kHeader = 1100, kDamage = 40;
  for (std::size_t at = kHeader; at + kDamage < bytes.size(); at += 37) {
    std::string altered = bytes;
    altered.replace(at, kDamage, kDamage, '\377');
    test::write_text(folder / "damaged.gif", altered);
    ++tried;
    try {
      read_whole(folder / "damaged.gif");
    } catch (const Error&) {
      ++damaged;
    }
  }
  EXPECT_GE(damaged, tried * 3 / 4) << tried;
}

TEST(FilmReader, MatroskaThatEndsInItsHeaderIsNoFilm) {
  const TemporaryFolder folder;
  make_foreign("color=gray:s=16x16", folder / "whole.mkv");
  const std::string bytes = test::read_text(folder / "whole.mkv");
  for (std::size_t length = 40; length < 400; length += 9) {
    test::write_text(folder / "cut.mkv", bytes.substr(0, length));
    SCOPED_TRACE(length);
    test::expect_input_error([&] { read_whole(folder / "cut.mkv"); }, "", "");
  }
}

TEST(FilmReader, TiffIsRefusedWithItsReason) {
  const TemporaryFolder folder;
  make_foreign("color=gray:s=16x16", folder / "a.mov", "-c:v tiff");
  test::expect_input_error([&] { FilmReader{folder / "a.mov"}; }, "", "has TIFF pictures");
}

TEST(FilmReader, PicturesOfAnUnknownKindAreToldOfTheFilm) {
  const TemporaryFolder folder;
  write_film(folder / "a.mp4", ramp(2));
  std::string bytes = test::read_text(folder / "a.mp4");
  bytes.replace(bytes.find("avc1", bytes.find("stsd")), 4, "abcd");
  test::write_text(folder / "a.mp4", bytes);
  test::expect_input_error([&] { FilmReader{folder / "a.mp4"}; }, "", "of an unknown kind");
}

// libav would take what stands before a colon for a protocol
TEST(FilmReader, ANameIsAFileEvenIfItLooksLikeAnAddress) {
  const TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  for (const char* name : {"take:1.mp4", "http:a.mp4", "%s 50%.mp4"}) {
    write_film(name, ramp(2));
    EXPECT_EQ(FilmReader(name).info().frames, 2) << name;
  }
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace polhode
