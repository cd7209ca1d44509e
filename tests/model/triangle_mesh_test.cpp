// SPDX-License-Identifier: MIT
#include "model/triangle_mesh.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "base/units.h"
#include "math/so3.h"
#include "support/expect_error.h"

namespace polhode {
namespace {

using test::expect_input_error;

const char* const kBox =
    "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 4\nv 2 0 4\nv 2 3 4\nv 0 3 4\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 1 5 8 4\nf 2 3 7 6\n";
const char* const kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

TriangleMesh obj(const std::string& text) {
  return parse_triangle_mesh(text, "test.obj");
}

TriangleMesh solid(const std::string& text) {
  TriangleMesh mesh = obj(text);
  check_solid(mesh);
  return mesh;
}

// an octahedron with each triangle cut in four `times` times, on the unit sphere
TriangleMesh ball(int times) {
  TriangleMesh mesh =
      obj("v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
          "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 2 1 6\nf 3 2 6\nf 4 3 6\nf 1 4 6\n");
  for (; times > 0; --times) {
    std::string text;
    int count = 0;
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      for (const Vec3& p : {a, b, c})
        text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
      text += fmt::format("f {} {} {}\n", count + 1, count + 2, count + 3);
      count += 3;
    };
    for (const auto& t : mesh.triangles) {
      const Vec3 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
      const Vec3 ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
      add(a, ab, ca);
      add(b, bc, ab);
      add(c, ca, bc);
      add(ab, bc, ca);
    }
    mesh = obj(text);
  }
  return mesh;
}

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

TEST(TriangleMesh, BoxHasTheClosedForm) {
  const TriangleMesh mesh = solid(kBox);
  EXPECT_NEAR(volume_of(mesh), 24.0, 2e-14);
  const MassProperties body = mass_properties_of(mesh);
  EXPECT_LE((body.center - Vec3(1, 1.5, 2)).norm(), 1e-15);
  const Mat3 expected = Vec3(25.0 / 12, 20.0 / 12, 13.0 / 12).asDiagonal();
  EXPECT_LE((body.tensor - expected).norm(), 1e-14);
}

TEST(TriangleMesh, TetrahedronHasTheClosedForm) {
  // second moments 1/10 and 1/20 of the corner tetrahedron, carried to the centre (1/4, 1/4, 1/4)
  const MassProperties body = mass_properties_of(solid(kTetrahedron));
  EXPECT_LE((body.center - Vec3::Constant(0.25)).norm(), 1e-16);
  const double square = 1.0 / 10 - 1.0 / 16, product = 1.0 / 20 - 1.0 / 16;
  Mat3 expected = Mat3::Constant(-product);
  expected.diagonal().setConstant(2.0 * square);
  EXPECT_LE((body.tensor - expected).norm(), 1e-16);
}

TEST(TriangleMesh, BallsConvergeAtSecondOrder) {
  double before = 0.0;
  for (int times = 2; times <= 5; ++times) {
    const TriangleMesh mesh = ball(times);
    check_solid(mesh);
    const double error = (mass_properties_of(mesh).tensor - 0.4 * Mat3::Identity()).norm() / 0.4;
    if (before > 0.0) {
      EXPECT_NEAR(before / error, 4.0, 0.3);
    }
    before = error;
  }
}

TEST(TriangleMesh, MovesTurnsAndScalesWithItsPoints) {
  const TriangleMesh mesh = solid(kBox);
  TriangleMesh other = mesh;
  const Mat3 R = exp_rotation({0.4, -1.0, 0.3}).toRotationMatrix();
  for (Vec3& p : other.points)
    p = R * (0.5 * p) + Vec3(100.0, -50.0, 20.0);
  MassProperties expected = mass_properties_of(mesh);
  expected.center *= 0.5;
  expected.tensor *= 0.25;
  expected = moved(expected, R, {100.0, -50.0, 20.0});
  const MassProperties found = mass_properties_of(other);
  EXPECT_NEAR(volume_of(other), 3.0, 2e-13);
  EXPECT_LE((found.center - expected.center).norm(), 1e-13);
  EXPECT_LE((found.tensor - expected.tensor).norm(), 1e-13);
}

TEST(TriangleMesh, StlSaysTheSameAsObj) {
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

TEST(TriangleMesh, RefusesWhatBoundsNoSolid) {
  const std::string tetrahedron = kTetrahedron;
  expect_input_error([&] { solid(tetrahedron.substr(0, tetrahedron.size() - 8)); }, "", "is open");
  expect_input_error(
      [&] { solid("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"); },
      "",
      "inside out");
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

TEST(TriangleMesh, RefusesHostileFiles) {
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

}  // namespace
}  // namespace polhode
