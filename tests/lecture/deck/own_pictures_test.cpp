// SPDX-License-Identifier: MIT
#include "lecture/deck/own_pictures.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png.h"
#include "support/run.h"

namespace polhode {
namespace {

using namespace std::string_literals;

class OwnPictures : public ::testing::Test {
 protected:
  // what is wrong with a picture of these bytes; "nothing"
  std::string wrong_with(const std::string& ending, const std::string& bytes) const {
    const std::filesystem::path file = folder_ / ("a" + ending);
    test::write_text(file, bytes);
    try {
      require_picture(file, ending);
      return "nothing";
    } catch (const Error& error) {
      EXPECT_EQ(error.fault(), Fault::input);
      return error.message();
    }
  }

  test::TemporaryFolder folder_;
};

TEST_F(OwnPictures, OfPngAreWhole) {
  write_png(folder_ / "b.png", Image(3, 2), false);
  const std::string whole = test::read_text(folder_ / "b.png");
  EXPECT_EQ(wrong_with(".png", whole), "nothing");
  EXPECT_EQ(wrong_with(".png", whole.substr(0, whole.size() - 12)),
            "'a.png' is not a whole PNG picture: it ends before its last chunk");
}

// segments of these bytes, with a smaller picture in the first one, as cameras have it
TEST_F(OwnPictures, OfJpegAreWhole) {
  const std::string inside = "\xff\xd8\xff\xda\0\2x\xff\xd9"s;
  const std::string start = "\xff\xd8\xff\xe1\0"s + static_cast<char>(inside.size() + 2) + inside;
  const std::string scan = "\xff\xff\xda\0\3\1pixels\xff\0more\xff\xd0more"s;
  EXPECT_EQ(wrong_with(".jpg", start + scan + scan + "\xff\xd9"), "nothing");
  EXPECT_EQ(wrong_with(".jpeg", start + scan + "\xff\xd9 and more"), "nothing");
  EXPECT_EQ(wrong_with(".jpg", start + "\xff\xd9"), "'a.jpg' has no picture in it");
  EXPECT_EQ(wrong_with(".jpg", "picture"), "'a.jpg' is no .jpg file");
  const std::string whole = start + scan + "\xff\xd9";
  for (std::size_t length = 3; length < whole.size(); ++length)
    EXPECT_EQ(wrong_with(".jpg", whole.substr(0, length)),
              "'a.jpg' is cut off: it ends before its picture does")
        << length;
}

TEST_F(OwnPictures, OfWebpAreWhole) {
  const std::string whole = "RIFF\x10\0\0\0WEBPVP8L\4\0\0\0abcd"s;
  EXPECT_EQ(wrong_with(".webp", whole), "nothing");
  EXPECT_EQ(wrong_with(".webp", "RIFF and others"), "'a.webp' is no .webp file");
  for (const std::size_t length : {12U, 20U, 23U})
    EXPECT_EQ(wrong_with(".webp", whole.substr(0, length)),
              "'a.webp' is cut off: it ends before its picture does");
}

TEST_F(OwnPictures, OfSvgAreXmlOfTheirKind) {
  const std::string right = "<svg xmlns=\"http://www.w3.org/2000/svg\"><g/></svg>";
  EXPECT_EQ(wrong_with(".svg", right), "nothing");
  EXPECT_EQ(wrong_with(".svg",
                       "<?xml version=\"1.0\"?><!DOCTYPE svg [<!ENTITY s "
                       "\"http://www.w3.org/2000/svg\">]><s:svg xmlns:s=\"&s;\"/>"),
            "nothing");
  EXPECT_EQ(wrong_with(".svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><g>"),
            "'a.svg' is no XML, as an SVG is");
  EXPECT_EQ(wrong_with(".svg", "<svg/>"),
            "'a.svg' does not begin with <svg xmlns=\"http://www.w3.org/2000/svg\">");
  EXPECT_EQ(wrong_with(".svg", "<html/>"), "'a.svg' is no .svg file");
}

}  // namespace
}  // namespace polhode
