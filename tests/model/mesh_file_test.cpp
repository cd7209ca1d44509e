// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/meshes.h"

namespace polhode::test {
namespace {

std::string binary_stl(const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const auto put = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i)
      put(0.0f);
    for (const int i : t) {
      for (int k = 0; k < 3; ++k)
        put(static_cast<float>(mesh.points[i][k]));
    }
    put(std::uint16_t{0});
  }
  return bytes;
}

TEST(MeshFile, StlSaysTheSameAsObj) {
  const TriangleMesh mesh = solid(kBox);
  std::string ascii = "solid box\n";
  for (const auto& t : mesh.triangles) {
    ascii += "facet normal 0 0 0\nouter loop\n";
    for (const int i : t) {
      const Vec3& p = mesh.points[i];
      ascii += fmt::format("vertex {} {} {}\n", p.x(), p.y(), p.z());
    }
    ascii += "endloop\nendfacet\n";
  }
  ascii += "endsolid box\n";
  for (const std::string& bytes : {ascii, binary_stl(mesh)}) {
    const TriangleMesh read = parse_triangle_mesh(bytes, "BOX.STL");
    check_solid(read);
    EXPECT_EQ(read.points.size(), 8u);
    EXPECT_EQ(read.triangles.size(), 12u);
    EXPECT_LE((mass_properties_of(read).tensor - mass_properties_of(mesh).tensor).norm(), 1e-14);
  }
}

// tabs between numbers, and what is no part of the surface
TEST(MeshFile, ReadsWhatOtherProgramsWriteIntoObj) {
  std::string obj = "# made elsewhere\no thing\n" + std::string(kBox) + "\nl 1 2\np 1\n";
  std::replace(obj.begin(), obj.end(), ' ', '\t');
  const TriangleMesh read = parse_triangle_mesh(obj, "box.obj");
  check_solid(read);
  EXPECT_EQ(read.triangles.size(), solid(kBox).triangles.size());
}

// a mark of the byte order, any ends of lines, lines that go on, capitals
TEST(MeshFile, ReadsTextsOfAnySystem) {
  const auto ended = [](std::string text, const std::string& end) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
      text.replace(at, 1, end);
    return text;
  };
  std::string goes_on = kBox;
  goes_on.insert(goes_on.find("f ") + 2, "\\\n ");
  for (const std::string& bytes : {"\xEF\xBB\xBF" + std::string(kBox),
                                   ended(kBox, "\r"),
                                   ended(kBox, "\r\n"),
                                   ended(kBox, " # a remark\n"),
                                   goes_on}) {
    const TriangleMesh read = parse_triangle_mesh(bytes, "box.obj");
    check_solid(read);
    EXPECT_NEAR(volume_of(read), 24.0, 1e-13) << bytes;
  }
  const TriangleMesh read = parse_triangle_mesh(
      "SOLID T\nFACET NORMAL 0 0 0\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1E0 0 0\nVERTEX 0 1 0\n"
      "ENDLOOP\nENDFACET\nENDSOLID T\n",
      "t.stl");
  EXPECT_EQ(read.triangles.size(), 1U);
}

// whatever its letters and its end, a binary file is no text
TEST(MeshFile, BytesOfBinaryFilesStayAsTheyAre) {
  const TriangleMesh mesh = solid(
      "v 65.5 0 0\nv 0 66.6 0\nv 0 0 67.7\nv -70 -80 -90\n"
      "f 1 2 3\nf 2 1 4\nf 3 2 4\nf 1 3 4\n");
  for (const std::string& rest : {std::string(), std::string("WRITTEN BY\r\nA PROGRAM")}) {
    const TriangleMesh read = parse_triangle_mesh(binary_stl(mesh) + rest, "test.stl");
    ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
    EXPECT_NEAR(volume_of(read), volume_of(mesh), 1e-5 * volume_of(mesh));
  }
}

// wherever the list of a face begins: an L, and a square with a corner within a side
TEST(MeshFile, FacesMayHaveAnyOutline) {
  const auto turned = [](std::vector<int> face, std::size_t by) {
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(by), face.end());
    std::string line = "f";
    for (const int corner : face)
      line += fmt::format(" {}", corner);
    return line + "\n";
  };
  const std::string prism =
      "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
      "v 0 0 1\nv 3 0 1\nv 3 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n"
      "f 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";
  for (std::size_t by = 0; by < 6; ++by) {
    EXPECT_NEAR(volume_of(solid(prism + turned({6, 5, 4, 3, 2, 1}, by) +
                                turned({7, 8, 9, 10, 11, 12}, 5 - by))),
                4.0,
                1e-14);
  }
  const std::string cube =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv .5 0 0\n"
      "f 5 6 7 8\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  for (std::size_t by = 0; by < 5; ++by) {
    EXPECT_NEAR(
        volume_of(solid(cube + turned({1, 4, 3, 2, 9}, by) + turned({1, 9, 2, 6, 5}, 4 - by))),
        1.0,
        1e-14);
  }
  expect_input_error([] { obj("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n"); },
                     "",
                     "face 1 crosses or touches itself");
}

// a fan of a hundred thousand corners would take minutes
TEST(MeshFile, RefusesFacesThatWouldTakeMinutes) {
  std::string disc, face = "f";
  for (int i = 0; i < 30'000; ++i) {
    const double angle = 2.0 * kPi * i / 30'000;
    disc += fmt::format("v {} {} 0\n", std::cos(angle), std::sin(angle));
    face += fmt::format(" {}", i + 1);
  }
  expect_input_error([&] { obj(disc + face + "\n"); }, "", "which has 30000 corners");
}

// CGAL would read what it can
TEST(MeshFile, RefusesVerticesThatAreNoNumbers) {
  const auto with = [](const std::string& last) {
    return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 " + last + "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  };
  for (const std::string& last :
       {std::string("1,5"), std::string("1x5"), std::string("1\0", 2), std::string("1 junk")})
    expect_input_error([&] { obj(with(last)); }, "", "vertex 4 has '");
  for (const char* last : {"1.5", "+1.5e0", "1. 1", "1.5 0.1 0.2 0.3"})
    EXPECT_NO_THROW(obj(with(last))) << last;
}

TEST(MeshFile, NamesTheCornerThatIsNotThere) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expect_input_error(
      [&] { obj(three + "f 1 2 4\n"); }, "", "face 2 names the vertex 4, but there are 3");
  expect_input_error([&] { obj(three + "f 1 2 -4\n"); }, "", "face 2 names the vertex -4");
  expect_input_error([&] { obj(three + "f 1.0 2 3\n"); }, "", "the corner '1.0'");
}

TEST(MeshFile, RefusesWhatBoundsNoSolid) {
  const std::string tetrahedron = kTetrahedron;
  expect_input_error([&] { solid(tetrahedron.substr(0, tetrahedron.size() - 8)); }, "", "is open");
  expect_input_error(
      [&] { solid("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"); },
      "",
      "inside out");
  expect_input_error(
      [&] {
        solid(
            "v 0 0 0\nv 1e150 0 0\nv 0 1e150 0\nv 0 0 1e150\n"
            "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
      },
      "",
      "too large");
  expect_input_error(
      [&] { solid("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"); },
      "",
      "turned over");
  expect_input_error([&] { solid(tetrahedron + "f 1 1 2\n"); }, "", "no area");
  // two tetrahedra through each other
  expect_input_error(
      [&] {
        solid(tetrahedron +
              "v .1 .1 .1\nv 1.1 .1 .1\nv .1 1.1 .1\nv .1 .1 1.1\n"
              "f 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n");
      },
      "",
      "crosses itself: triangles");
}

// a second shell: a cavity faces inwards, another body outwards
TEST(MeshFile, ShellsFaceTheRightWay) {
  const auto second = [](double size, double x, bool outwards) {
    return fmt::format(
        "v {1} {1} {1}\nv {2} {1} {1}\nv {1} {3} {1}\nv {1} {1} {3}\n{0}",
        outwards ? "f 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n" : "f 5 6 7\nf 5 8 6\nf 5 7 8\nf 6 8 7\n",
        x,
        x + size,
        x + size);
  };
  EXPECT_NO_THROW(solid(std::string(kTetrahedron) + second(0.1, 2.0, true)));
  EXPECT_NO_THROW(solid(std::string(kTetrahedron) + second(0.1, 0.1, false)));
  expect_input_error(
      [&] { solid(std::string(kTetrahedron) + second(0.1, 2.0, false)); }, "", "is inside out");
  expect_input_error(
      [&] { solid(std::string(kTetrahedron) + second(0.1, 0.1, true)); }, "", "as no cavity does");
}

TEST(MeshFile, RefusesHostileFiles) {
  for (const std::string& bytes : {std::string(),
                                   std::string("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                                   std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"),
                                   std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n"),
                                   std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2000000000\n"),
                                   std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999\n"),
                                   std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"),
                                   std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n"),
                                   std::string("v 0 0")}) {
    EXPECT_THROW(obj(bytes), Error) << bytes;
    EXPECT_THROW(parse_triangle_mesh(bytes, "test.stl"), Error) << bytes;
  }
  // a binary file broken off anywhere, one that promises too much, and one with a NaN
  std::string bytes = binary_stl(solid(kTetrahedron));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(parse_triangle_mesh(bytes.substr(0, size), "test.stl"), Error) << size;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + 100, &nan, sizeof(nan));
  EXPECT_THROW(parse_triangle_mesh(bytes, "test.stl"), Error);
  bytes[83] = '\x7f';
  EXPECT_THROW(parse_triangle_mesh(bytes, "test.stl"), Error);
  expect_input_error([] { parse_triangle_mesh("", "test.ply"); }, "", ".obj or .stl");
}

// the order of corners and the places of points are the file's; a face of four becomes two
// triangles
TEST(MeshFile, ObjFacesAreCutIntoTrianglesThatLookOutwards) {
  const TriangleMesh box = obj(kBox);
  EXPECT_EQ(box.points.size(), 8U);
  EXPECT_EQ(box.triangles.size(), 12U);
  EXPECT_NEAR(volume_of(box), 24.0, 1e-13);
  const TriangleMesh negative = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n");
  EXPECT_EQ(negative.triangles.at(0), (std::array<int, 3>{0, 1, 2}));
}

}  // namespace
}  // namespace polhode::test
