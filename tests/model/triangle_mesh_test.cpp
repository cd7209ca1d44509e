// SPDX-License-Identifier: MIT
#include "model/triangle_mesh.h"

#include <cmath>

#include <gtest/gtest.h>

#include "math/so3.h"
#include "support/expect_error.h"
#include "support/meshes.h"
#include "support/run.h"

namespace polhode::test {
namespace {

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

TEST(TriangleMesh, IsLoadedScaledAndChecked) {
  const TemporaryFolder folder;
  write_text(folder / "box.obj", kBox);
  EXPECT_NEAR(volume_of(load_solid_mesh(folder / "box.obj", 0.01)), 24e-6, 1e-19);
  const std::string open =
      std::string(kTetrahedron).substr(0, std::string(kTetrahedron).size() - 8);
  write_text(folder / "open.obj", open);
  expect_input_error([&] { load_solid_mesh(folder / "open.obj", 1.0); }, "", "is open");
  EXPECT_THROW(load_solid_mesh(folder / "none.obj", 1.0), Error);
}

}  // namespace
}  // namespace polhode::test
