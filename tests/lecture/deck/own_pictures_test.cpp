// SPDX-License-Identifier: MIT
#include "lecture/deck/own_pictures.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png.h"
#include "lecture/tiny_pictures.h"
#include "support/run.h"

namespace polhode {
namespace {

using namespace std::string_literals;
using test::from_hex;
using test::kJpegFrame;
using test::kJpegScan;
using test::kJpegTables;
using test::kWebp;

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

// as cameras write them
TEST_F(OwnPictures, MayHaveEndingsInCapitals) {
  EXPECT_EQ(picture_ending("a/IMG_1.JPG"), ".jpg");
  EXPECT_TRUE(is_picture_ending(".jpeg"));
  EXPECT_FALSE(is_picture_ending(".gif"));
  EXPECT_EQ(picture_ending("a"), "");
}

TEST_F(OwnPictures, OfPngAreWhole) {
  write_png(folder_ / "b.png", Image(3, 2), false);
  const std::string whole = test::read_text(folder_ / "b.png");
  EXPECT_EQ(wrong_with(".png", whole), "nothing");
  EXPECT_EQ(wrong_with(".png", whole.substr(0, whole.size() - 12)),
            "'a.png' is not a whole PNG picture: it ends before its last chunk");
}

// with a smaller picture in its first segment, as cameras have it
TEST_F(OwnPictures, OfJpegAreWhole) {
  const std::string inside = "\xff\xd8\xff\xda\0\2x\xff\xd9"s;
  const std::string start = "\xff\xd8\xff\xe1\0"s + static_cast<char>(inside.size() + 2) + inside;
  const std::string tables = from_hex(kJpegTables), frame = from_hex(kJpegFrame);
  const std::string scan = from_hex(kJpegScan);
  const std::string whole = start + tables + frame + scan;
  EXPECT_EQ(wrong_with(".jpg", whole), "nothing");
  EXPECT_EQ(wrong_with(".jpeg", whole + " and more"), "nothing");
  EXPECT_EQ(wrong_with(".jpg", start + "\xff\xd9"), "'a.jpg' has no picture in it");
  EXPECT_EQ(wrong_with(".jpg", start + tables + scan),
            "'a.jpg' is damaged: its picture has no size");
  EXPECT_EQ(wrong_with(".jpg", start + tables + frame + frame + scan), "'a.jpg' is damaged");
  EXPECT_EQ(wrong_with(".jpg", "picture"), "'a.jpg' is no .jpg file");
  for (std::size_t length = 3; length < whole.size(); ++length) {
    // a frame that ends in its first bytes is of no kind
    const std::string wrong = wrong_with(".jpg", whole.substr(0, length));
    EXPECT_TRUE(wrong == "'a.jpg' is cut off: it ends before its picture does" ||
                wrong == "'a.jpg' is a JPEG of a kind that browsers do not show")
        << length << wrong;
  }
  // without losses, 12 bits, no size, two colours
  for (const auto& [at, byte] :
       {std::pair(1, '\xc3'), std::pair(4, '\x0c'), std::pair(6, '\0'), std::pair(9, '\2')}) {
    std::string other = frame;
    other[static_cast<std::size_t>(at)] = byte;
    EXPECT_EQ(wrong_with(".jpg", start + tables + other + scan),
              "'a.jpg' is a JPEG of a kind that browsers do not show");
  }
  // a table of Huffman's of no class, and a scan of a colour that the frame has not
  for (const auto& [at, byte] : {std::pair(4, '\x54'), std::pair(49, '\7')}) {
    std::string other = scan;
    other[static_cast<std::size_t>(at)] = byte;
    EXPECT_EQ(wrong_with(".jpg", start + tables + frame + other), "'a.jpg' is damaged") << at;
  }
}

// as pandoc knows their size; what else they begin with stays
TEST_F(OwnPictures, OfJpegAreOfTheKindOfJfif) {
  const std::string start = "\xff\xd8"s, jfif = from_hex("ffe000104a46494600010100000100010000");
  const std::string rest = from_hex(kJpegTables) + from_hex(kJpegFrame) + from_hex(kJpegScan);
  const std::string named = as_jfif(start + rest);
  EXPECT_EQ(named, start + jfif + rest);
  EXPECT_EQ(wrong_with(".jpg", named), "nothing");
  EXPECT_EQ(as_jfif(named), named);
  const std::string exif = start + from_hex("ffe100084578696600") + "\0"s + rest;
  EXPECT_EQ(as_jfif(exif), exif);
  // three colours behind Adobe's segment, whose last byte says whether they are transformed
  const std::string adobe = from_hex("ffee000e41646f626500640000000001");
  const std::string colours = from_hex("ffc00011080008000803011100021100031100") + rest;
  std::string rgb = start + adobe + colours;
  EXPECT_EQ(as_jfif(rgb), start + jfif + adobe + colours);
  rgb[start.size() + adobe.size() - 1] = '\0';
  EXPECT_EQ(as_jfif(rgb), rgb);
  for (std::size_t length = 0; length < rgb.size(); ++length)
    EXPECT_EQ(as_jfif(rgb.substr(0, length)), rgb.substr(0, length));
}

TEST_F(OwnPictures, OfWebpAreWhole) {
  const std::string whole = from_hex(kWebp);
  EXPECT_EQ(wrong_with(".webp", whole), "nothing");
  EXPECT_EQ(wrong_with(".webp", "RIFF and others"), "'a.webp' is no .webp file");
  EXPECT_EQ(wrong_with(".webp", "RIFF\4\0\0\0WEBP"s), "'a.webp' has no picture in it");
  const std::string cut_off = "'a.webp' is cut off: it ends before its picture does";
  for (const std::size_t length : {12U, 20U, 33U})
    EXPECT_EQ(wrong_with(".webp", whole.substr(0, length)), cut_off);
  const auto with = [&](std::size_t at, char byte) {
    std::string other = whole;
    other[at] = byte;
    return wrong_with(".webp", other);
  };
  EXPECT_EQ(with(16, '\x7f'), cut_off);               // the length of its chunk
  EXPECT_EQ(with(4, '\x10'), "'a.webp' is damaged");  // its own
  EXPECT_EQ(with(20, 'x'), "'a.webp' is damaged");    // the signature of its picture
  EXPECT_EQ(with(12, 'X'), "'a.webp' has no picture in it");
}

TEST_F(OwnPictures, OfSvgAreXmlOfTheirKind) {
  const std::string head = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
  const std::string linked = " xmlns:xlink=\"http://www.w3.org/1999/xlink\"><image xlink:href=\"";
  const std::string old_type =
      "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" "
      "\"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\">";
  std::string nested;
  for (int i = 0; i < 300; ++i)
    nested = "<g>" + nested + "</g>";
  for (const std::string& right :
       {head + "><g/></svg>",
        "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + head + "/>",
        old_type + head + "><a href=\"https://a.org\">&amp;</a></svg>",
        "<!DOCTYPE svg [<!ENTITY s \"http://www.w3.org/2000/svg\">"
        "<!ENTITY t \"T\">]><svg xmlns=\"&s;\">&t;</svg>"s,
        head + linked + "data:image/png;base64,AA\"/></svg>",
        head + linked + "#a\"/></svg>",
        head + "><rect fill=\"url(#a)\" style=\"fill:url( '#b' )\" class=\"url(\"/></svg>",
        head + "><style>@namespace url(http://www.w3.org/2000/svg); /* url(c) */ "
               "@font-face{src:url(f.woff)} g{fill:url(data:image/png;base64,AA)}</style></svg>",
        head + ">" + nested + "</svg>",
        "\xff\xfe<\0s\0v\0g\0 \0x\0m\0l\0n\0s\0=\0\"\0h\0t\0t\0p\0:\0/\0/\0"
        "w\0w\0w\0.\0w\0003\0.\0o\0r\0g\0/\0002\0000\0000\0000\0/\0s\0v\0g\0"
        "\"\0/\0>\0"s})
    EXPECT_EQ(wrong_with(".svg", right), "nothing") << right;
  const std::pair<std::string, const char*> wrong[] = {
      {head + "><g>", "is no XML, as an SVG is: line 1: "},
      {head + "><image xlink:href=\"#a\"/></svg>", "line 1: Namespace prefix xlink for href"},
      {head + ">\xfc</svg>", "is no XML"},
      {head + "/>\0"s, "is no XML"},
      {old_type + head + ">&eacute;</svg>", "has &eacute; in it, which it does not define"},
      {head + linked + "b.jpg\"/></svg>", "needs another file, b.jpg, which"},
      {head + "><g fill=\"url(o.svg#g) red\"/></svg>", "needs another file, o.svg#g, which"},
      {head + "><g style=\"fill: url( 'o.svg#g')\"/></svg>", "another file, o.svg#g, which"},
      {head + "><style>/* a */ @import 'y.css';</style></svg>", "another file, y.css, which"},
      {head + "><style><![CDATA[@import url(\"y.css\");]]></style></svg>", "another file, y.css,"},
      {"<?xml-stylesheet type=\"text/css\" href=\"y.css\"?>" + head + "/>", "another file, y.css,"},
      {head + "><foreignObject><i xmlns=\"i\" src=\"x.png\"/></foreignObject></svg>",
       "needs another file, x.png, which"},
      {"<svg/>", "does not begin with <svg xmlns=\"http://www.w3.org/2000/svg\">"},
      {"<svg xmlns=\"http://www.w3.org/2000/svgs\"/>", "does not begin with <svg"},
      {"<html/>", "does not begin with <svg"},
      {"words", "is no XML"},
      {"", "is no XML"}};
  for (const auto& [bytes, says] : wrong)
    EXPECT_NE(wrong_with(".svg", bytes).find(says), std::string::npos)
        << bytes << wrong_with(".svg", bytes);
}

}  // namespace
}  // namespace polhode
