// SPDX-License-Identifier: MIT
#include "model/triangle_mesh.h"

#include <algorithm>

#include "base/error.h"
#include "base/system/atomic_file.h"
#include "base/units.h"

namespace polhode {
namespace {

constexpr std::size_t kLargestMeshFile = 64u << 20;  // bytes

// volume, and the integrals of r and r r^T over it, all about `origin`
struct VolumeIntegrals {
  Vec3 origin = Vec3::Zero();
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

VolumeIntegrals integrate(const TriangleMesh& mesh) {
  VolumeIntegrals sum;
  sum.origin = mesh.points[static_cast<std::size_t>(mesh.triangles.front()[0])];
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    // the tetrahedron of origin and triangle, signed
    const Vec3 a = mesh.points[static_cast<std::size_t>(triangle[0])] - sum.origin;
    const Vec3 b = mesh.points[static_cast<std::size_t>(triangle[1])] - sum.origin;
    const Vec3 c = mesh.points[static_cast<std::size_t>(triangle[2])] - sum.origin;
    const double six_volumes = a.dot(b.cross(c));
    const Vec3 s = a + b + c;
    sum.volume += six_volumes / 6.0;
    sum.first += six_volumes / 24.0 * s;
    sum.second += six_volumes / 120.0 *
                  (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  return sum;
}

}  // namespace

double volume_of(const TriangleMesh& mesh) {
  return integrate(mesh).volume;
}

MassProperties mass_properties_of(const TriangleMesh& mesh) {
  const VolumeIntegrals sum = integrate(mesh);
  const Vec3 arm = sum.first / sum.volume;
  const Mat3 second = sum.second / sum.volume - arm * arm.transpose();
  return {1.0, sum.origin + arm, second.trace() * Mat3::Identity() - second};
}

TriangleMesh load_solid_mesh(const std::filesystem::path& file, double scale) {
  TriangleMesh mesh =
      parse_triangle_mesh(read_input(file, kLargestMeshFile), file.filename().string());
  Eigen::AlignedBox3d box;
  for (Vec3& point : mesh.points) {
    point *= scale;
    box.extend(point);
  }
  const double size = std::max(box.diagonal().stableNorm(), box.max().cwiseAbs().maxCoeff());
  const Magnitude lengths = magnitude_of(Unit::length);
  if (!(size >= lengths.least && size <= lengths.most)) {
    throw input_error(
        "the mesh is {:.3g} m large or far, of {:g} to {:g} m that are possible; change scale",
        size,
        lengths.least,
        lengths.most);
  }
  check_solid(mesh);
  return mesh;
}

}  // namespace polhode
