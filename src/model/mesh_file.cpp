// SPDX-License-Identifier: MIT
// OBJ and STL to TriangleMesh, and whether it bounds a solid: the only file that sees CGAL.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>
#include <tuple>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/STL.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include "base/error.h"
#include "base/system/interrupt.h"
#include "base/units.h"
#include "model/triangle_mesh.h"

namespace polhode {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Faces = std::vector<std::vector<std::size_t>>;
using Triangle = std::array<int, 3>;

std::string text(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

const Vec3& corner(const TriangleMesh& mesh, const Triangle& triangle, int i) {
  return mesh.points[static_cast<std::size_t>(triangle[static_cast<std::size_t>(i % 3)])];
}

Point cgal(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

// The corners and faces of an OBJ file, with blanks between their numbers; lines, points, materials
// and the like are no part of a surface.
std::string surface_of_obj(const std::string& bytes) {
  std::istringstream in(bytes);
  std::string kept;
  for (std::string line; std::getline(in, line);) {
    std::replace(line.begin(), line.end(), '\t', ' ');
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos) continue;
    const std::string word = line.substr(first, line.find(' ', first) - first);
    if (word != "v" && word != "f") continue;
    kept += line;
    // a file that ends within a line ends early
    if (!in.eof()) kept += '\n';
  }
  return kept;
}

// the points and faces as they stand in the file
void read_soup(const std::string& bytes,
               const std::string& name,
               std::vector<Point>& points,
               Faces& faces) {
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  std::istringstream in(ending == ".obj" ? surface_of_obj(bytes) : bytes);
  bool good = false;
  if (ending == ".obj") {
    good = CGAL::IO::read_OBJ(in, points, faces);
  } else if (ending == ".stl") {
    good = CGAL::IO::read_STL(in, points, faces);
  } else {
    throw input_error("'{}' is not a mesh file; give one that ends in .obj or .stl", name);
  }
  if (!good) {
    throw input_error(
        "'{}' ends early or is not {} after face {}", name, ending.substr(1), faces.size());
  }
  if (faces.empty()) throw input_error("'{}' has no faces", name);
}

// do two triangles touch anywhere but at the corners they share?
bool cross(const TriangleMesh& mesh, Triangle s, Triangle t) {
  // shared corners first, in the same order in both
  int shared = 0;
  for (int i = 0; i < 3; ++i) {
    const auto found = std::find(t.begin() + shared, t.end(), s[static_cast<std::size_t>(i)]);
    if (found == t.end()) continue;
    std::iter_swap(found, t.begin() + shared);
    std::swap(s[static_cast<std::size_t>(i)], s[static_cast<std::size_t>(shared)]);
    ++shared;
  }
  const auto point = [&](const Triangle& triangle, int i) {
    return cgal(corner(mesh, triangle, i));
  };
  const Kernel::Triangle_3 first(point(s, 0), point(s, 1), point(s, 2));
  const Kernel::Triangle_3 second(point(t, 0), point(t, 1), point(t, 2));
  if (shared == 0) return CGAL::do_intersect(first, second);
  if (shared == 1) {
    // then the side opposite the corner of one of them meets the other
    return CGAL::do_intersect(first, Kernel::Segment_3(point(t, 1), point(t, 2))) ||
           CGAL::do_intersect(second, Kernel::Segment_3(point(s, 1), point(s, 2)));
  }
  // neighbours: flat against each other, folded over the common edge
  return shared == 3 || (CGAL::coplanar(point(s, 0), point(s, 1), point(s, 2), point(t, 2)) &&
                         CGAL::coplanar_orientation(
                             point(s, 0), point(s, 1), point(s, 2), point(t, 2)) == CGAL::POSITIVE);
}

// Triangles whose boxes overlap are found by CGAL (Zomorodian and Edelsbrunner, Int. J. Comput.
// Geom. Appl. 12 (2002) 143). A fan of long needles has as many such pairs as it has pairs.
void refuse_crossings(const TriangleMesh& mesh) {
  constexpr std::size_t kMostPairs = 250'000'000;  // some ten seconds
  constexpr std::size_t kPairsBetweenLooks = 1 << 16;
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    boxes.emplace_back(cgal(corner(mesh, triangle, 0)).bbox() +
                           cgal(corner(mesh, triangle, 1)).bbox() +
                           cgal(corner(mesh, triangle, 2)).bbox(),
                       t);
  }
  std::size_t pairs = 0;
  std::optional<std::pair<std::size_t, std::size_t>> first;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    if (++pairs % kPairsBetweenLooks == 0) stop_if_interrupted();
    if (pairs > kMostPairs) {
      throw input_error(
          "the mesh has so many long, thin triangles side by side that it cannot be checked for "
          "crossings (over {} pairs among {} triangles); give it rounder triangles",
          kMostPairs,
          mesh.triangles.size());
    }
    const std::pair<std::size_t, std::size_t> pair = std::minmax(a.info(), b.info());
    if (first && *first < pair) return;
    if (cross(mesh, mesh.triangles[pair.first], mesh.triangles[pair.second])) first = pair;
  });
  if (!first) return;
  Eigen::AlignedBox3d common[2];
  const std::size_t both[2] = {first->first, first->second};
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < 3; ++i)
      common[k].extend(corner(mesh, mesh.triangles[both[k]], i));
  }
  throw input_error("the mesh crosses itself: triangles {} and {}, near {}",
                    first->first + 1,
                    first->second + 1,
                    text(common[0].intersection(common[1]).center()));
}

// each directed edge once, and its reverse once
void refuse_open_edges(const TriangleMesh& mesh) {
  struct Edge {
    int from, to;
    std::size_t triangle;
    bool operator<(const Edge& other) const {
      return std::tie(from, to, triangle) < std::tie(other.from, other.to, other.triangle);
    }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i)
      edges.push_back({mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3], t});
  }
  std::sort(edges.begin(), edges.end());
  const auto where = [&](const Edge& edge) {
    return fmt::format("{} - {}",
                       text(mesh.points[static_cast<std::size_t>(edge.from)]),
                       text(mesh.points[static_cast<std::size_t>(edge.to)]));
  };
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge& edge = edges[i];
    const Edge& next = edges[i + 1];
    if (edge.from != next.from || edge.to != next.to) continue;
    throw input_error(
        "triangles {} and {} run the same way along the edge {}: one is turned over, or more than "
        "two meet there",
        edge.triangle + 1,
        next.triangle + 1,
        where(edge));
  }
  for (const Edge& edge : edges) {
    const auto found = std::lower_bound(edges.begin(), edges.end(), Edge{edge.to, edge.from, 0});
    if (found != edges.end() && found->from == edge.to && found->to == edge.from) continue;
    throw input_error("the mesh is open: triangle {} has no neighbour along the edge {}",
                      edge.triangle + 1,
                      where(edge));
  }
}

}  // namespace

TriangleMesh parse_triangle_mesh(const std::string& bytes, const std::string& name) {
  std::vector<Point> points;
  Faces faces;
  read_soup(bytes, name, points, faces);

  // corners at one place become one
  TriangleMesh mesh;
  std::map<std::array<double, 3>, int> index_of;
  std::vector<int> merged;
  for (const Point& p : points) {
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) {
      throw input_error("'{}': vertex {} is not finite", name, merged.size() + 1);
    }
    const auto [place, fresh] =
        index_of.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(mesh.points.size()));
    if (fresh) mesh.points.emplace_back(p.x(), p.y(), p.z());
    merged.push_back(place->second);
  }

  // faces become fans of triangles
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f].size() < 3) {
      throw input_error("'{}': face {} has {} corners", name, f + 1, faces[f].size());
    }
    for (const std::size_t i : faces[f]) {
      if (i < merged.size()) continue;
      throw input_error("'{}': face {} names a vertex that does not exist; there are {}",
                        name,
                        f + 1,
                        merged.size());
    }
    for (std::size_t i = 1; i + 1 < faces[f].size(); ++i) {
      mesh.triangles.push_back({merged[faces[f][0]], merged[faces[f][i]], merged[faces[f][i + 1]]});
    }
  }
  return mesh;
}

// The parts of a mesh that hang together, as the shell of each point.
std::vector<int> shells_of(const TriangleMesh& mesh) {
  std::vector<int> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[static_cast<std::size_t>(i)] != i) {
      int& up = parent[static_cast<std::size_t>(i)];
      up = parent[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  };
  for (const Triangle& corners : mesh.triangles) {
    for (const int other : {corners[1], corners[2]})
      parent[static_cast<std::size_t>(root(other))] = root(corners[0]);
  }
  for (std::size_t i = 0; i < parent.size(); ++i)
    parent[i] = root(static_cast<int>(i));
  return parent;
}

// How often a shell goes round a point: 1 inside of one that faces outwards, 0 outside (Van
// Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125).
double winding(const TriangleMesh& mesh, const std::vector<Triangle>& shell, const Vec3& point) {
  double sum = 0.0;
  for (const Triangle& corners : shell) {
    const Vec3 a = corner(mesh, corners, 0) - point;
    const Vec3 b = corner(mesh, corners, 1) - point;
    const Vec3 c = corner(mesh, corners, 2) - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2.0 * kPi);
}

// Shells must face outwards, and those of cavities inwards.
void refuse_wrong_shells(const TriangleMesh& mesh) {
  constexpr std::size_t kMostShells = 1000;
  const std::vector<int> shell_of = shells_of(mesh);
  std::map<int, std::vector<Triangle>> shells;
  for (const Triangle& corners : mesh.triangles)
    shells[shell_of[static_cast<std::size_t>(corners[0])]].push_back(corners);
  if (shells.size() == 1) return;
  if (shells.size() > kMostShells) {
    throw input_error(
        "the mesh has {} separate parts; at most {} are allowed", shells.size(), kMostShells);
  }
  std::map<int, Eigen::AlignedBox3d> boxes;
  for (const auto& [name, shell] : shells) {
    for (const Triangle& corners : shell) {
      for (int i = 0; i < 3; ++i)
        boxes[name].extend(corner(mesh, corners, i));
    }
  }
  for (const auto& [name, shell] : shells) {
    stop_if_interrupted();
    const Vec3& point = corner(mesh, shell.front(), 0);
    int around = 0;
    for (const auto& [other_name, other] : shells) {
      if (other_name == name || !boxes[other_name].contains(point)) continue;
      if (std::round(winding(mesh, other, point)) != 0.0) ++around;
    }
    double six_volumes = 0.0;
    for (const Triangle& corners : shell) {
      six_volumes +=
          (corner(mesh, corners, 0) - point)
              .dot((corner(mesh, corners, 1) - point).cross(corner(mesh, corners, 2) - point));
    }
    const bool faces_out = six_volumes > 0.0;
    if (faces_out == (around % 2 == 0)) continue;
    throw input_error(
        "the part near {} {}; list the corners of its triangles the other way round",
        text(point),
        faces_out ? "lies inside another and faces outwards, as no cavity does" : "is inside out");
  }
}

void check_solid(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw input_error("the mesh has no triangles");
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    if (CGAL::collinear(cgal(corner(mesh, corners, 0)),
                        cgal(corner(mesh, corners, 1)),
                        cgal(corner(mesh, corners, 2)))) {
      throw input_error("triangle {} has no area, near {}", t + 1, text(corner(mesh, corners, 0)));
    }
  }
  refuse_open_edges(mesh);
  refuse_crossings(mesh);
  const double volume = volume_of(mesh);
  if (!std::isfinite(volume)) {
    throw input_error("the mesh is too large: its volume in m^3 is beyond the range of numbers");
  }
  if (!(volume > 0.0)) {
    throw input_error(
        "the mesh is inside out: its volume is {:.6g} m^3; list the corners of each triangle the "
        "other way round, counter-clockwise seen from outside",
        volume);
  }
  refuse_wrong_shells(mesh);
}

}  // namespace polhode
