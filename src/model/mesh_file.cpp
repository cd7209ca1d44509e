// SPDX-License-Identifier: MIT
// OBJ and STL to TriangleMesh, and whether it bounds a solid: the only file that sees CGAL.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <sstream>
#include <string_view>
#include <tuple>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include "base/error.h"
#include "base/one_line.h"
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

// of a face of any number of corners
const Vec3& corner(const TriangleMesh& mesh, const std::vector<int>& face, std::size_t i) {
  return mesh.points[static_cast<std::size_t>(face[i % face.size()])];
}

const Vec3& corner(const TriangleMesh& mesh, const Triangle& triangle, int i) {
  return mesh.points[static_cast<std::size_t>(triangle[static_cast<std::size_t>(i % 3)])];
}

Point cgal(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

// A text without the mark of its byte order, with a line feed after each line, and lines that are
// continued after a backslash in one.
std::string plain_lines(const std::string& bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  const std::size_t first = bytes.compare(0, kMark.size(), kMark) == 0 ? kMark.size() : 0;
  std::string lines;
  lines.reserve(bytes.size());
  for (std::size_t i = first; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (c != '\r' && c != '\n') {
      lines += c;
      continue;
    }
    if (c == '\r' && i + 1 < bytes.size() && bytes[i + 1] == '\n') ++i;
    if (!lines.empty() && lines.back() == '\\') {
      lines.back() = ' ';
    } else {
      lines += '\n';
    }
  }
  return lines;
}

// Throws Error (input) for a vertex with a word that is no number, of which CGAL reads what it can.
// words: of its line, behind the first; number: which vertex it is, from 1
void check_vertex(std::istringstream& words, const std::string& name, long number) {
  for (std::string word; words >> word;) {
    const char* first = word.data() + (word.starts_with('+') ? 1 : 0);
    double value = 0.0;
    const auto [end, failed] = std::from_chars(first, word.data() + word.size(), value);
    if (failed != std::errc::invalid_argument && end == word.data() + word.size()) continue;
    throw input_error(
        "'{}': vertex {} has '{}', which is no number", name, number, one_line(word.substr(0, 40)));
  }
}

// Faces name corners that were given, from 1 on or from the last one backwards.
class ObjCorners {
 public:
  explicit ObjCorners(const std::string& name) : name_(name) {}

  // that of a line "v 1 2 3"; what follows are a weight or a colour
  void add_corner(const std::string& line) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    check_vertex(words, name_, ++corners_);
  }

  // those of a line "f 1 2/5 3//7"
  void add_face(const std::string& line) {
    ++faces_;
    std::istringstream words(line);
    std::string word;
    words >> word;
    while (words >> word) {
      const std::string index = word.substr(0, word.find('/'));
      long number = 0;
      const auto [end, failed] = std::from_chars(index.data(), index.data() + index.size(), number);
      if (failed != std::errc() || end != index.data() + index.size() || number == 0) {
        throw input_error("'{}': face {} has the corner '{}', which is no number of a vertex",
                          name_,
                          faces_,
                          word.substr(0, 40));
      }
      if (number < -corners_) refuse(number);
      if (number > most_) {
        most_ = number;
        of_most_ = faces_;
      }
    }
  }

  // called at the end of the file: faces may come before their corners
  void check() const {
    if (most_ > corners_) refuse(most_);
  }

 private:
  [[noreturn]] void refuse(long number) const {
    throw input_error("'{}': face {} names the vertex {}, but there are {}",
                      name_,
                      number > 0 ? of_most_ : faces_,
                      number,
                      corners_);
  }

  std::string name_;
  long corners_ = 0, faces_ = 0, most_ = 0, of_most_ = 0;
};

// The corners and faces of an OBJ file, with blanks between their numbers; lines, points, materials
// and the like are no part of a surface.
std::string surface_of_obj(const std::string& bytes, const std::string& name) {
  std::istringstream in(plain_lines(bytes));
  ObjCorners corners(name);
  std::string kept;
  for (std::string line; std::getline(in, line);) {
    std::replace(line.begin(), line.end(), '\t', ' ');
    line = line.substr(0, line.find('#'));
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos) continue;
    const std::string word = line.substr(first, line.find(' ', first) - first);
    if (word != "v" && word != "f") continue;
    // a file that ends within a line ends early
    const bool whole = !in.eof();
    if (word == "v") corners.add_corner(line);
    if (word == "f" && whole) corners.add_face(line);
    kept += line;
    if (whole) kept += '\n';
  }
  corners.check();
  return kept;
}

// An STL file in words, as the standard writes them; a binary one, which has zeros, as it is.
std::string surface_of_stl(const std::string& bytes, const std::string& name) {
  if (bytes.find('\0') != std::string::npos) return bytes;
  std::string text = lower(plain_lines(bytes));
  std::istringstream in(text);
  long vertices = 0;
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream words(line);
    if (words >> word && word == "vertex") check_vertex(words, name, ++vertices);
  }
  return text;
}

// the points and faces as they stand in the file
void read_soup(const std::string& bytes,
               const std::string& name,
               std::vector<Point>& points,
               Faces& faces) {
  const std::string ending = lower(std::filesystem::path(name).extension().string());
  bool good = false;
  if (ending == ".obj") {
    std::istringstream in(surface_of_obj(bytes, name));
    good = CGAL::IO::read_OBJ(in, points, faces);
  } else if (ending == ".stl") {
    std::istringstream in(surface_of_stl(bytes, name));
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

// twice the area of a face, along its normal (Newell)
Vec3 area_vector(const TriangleMesh& mesh, const std::vector<int>& face) {
  const Vec3& first = corner(mesh, face, 0);
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
    area += (corner(mesh, face, i) - first).cross(corner(mesh, face, i + 1) - first);
  return area;
}

bool is_convex(const TriangleMesh& mesh, const std::vector<int>& face) {
  const Vec3 area = area_vector(mesh, face);
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec3& middle = corner(mesh, face, i + 1);
    const Vec3 before = middle - corner(mesh, face, i), after = corner(mesh, face, i + 2) - middle;
    if (!(before.cross(after).dot(area) > 1e-9 * before.norm() * after.norm() * area.norm()))
      return false;
  }
  return true;
}

// A face of any outline that does not cross itself, seen along its normal, as the triangles of a
// constrained Delaunay triangulation; no triangles if it does.
std::vector<Triangle> cut_face(const TriangleMesh& mesh, const std::vector<int>& face) {
  using Plane = CGAL::Projection_traits_3<Kernel>;
  using Corner = CGAL::Triangulation_vertex_base_with_info_2<int, Plane>;
  using Cell =
      CGAL::Triangulation_face_base_with_info_2<bool,  // whether it is outside
                                                Plane,
                                                CGAL::Constrained_triangulation_face_base_2<Plane>>;
  using Cut = CGAL::Constrained_Delaunay_triangulation_2<
      Plane,
      CGAL::Triangulation_data_structure_2<Corner, Cell>>;
  constexpr std::size_t kCornersBetweenLooks = 1 << 8;
  const Vec3 area = area_vector(mesh, face);
  if (!(area.norm() > 0.0)) return {};
  Cut cut(Plane({area.x(), area.y(), area.z()}));
  std::vector<Cut::Vertex_handle> corners(face.size());
  // one after another along the outline would take longer
  std::vector<std::size_t> order(face.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::minstd_rand(1));
  try {
    for (const std::size_t i : order) {
      if (i % kCornersBetweenLooks == 0) stop_if_interrupted();
      corners[i] = cut.insert(cgal(mesh.points[static_cast<std::size_t>(face[i])]));
      corners[i]->info() = face[i];
    }
    if (cut.number_of_vertices() != face.size()) return {};
    for (const std::size_t i : order) {
      if (i % kCornersBetweenLooks == 0) stop_if_interrupted();
      cut.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
    }
  } catch (const Cut::Intersection_of_constraints_exception&) {
    return {};
  }
  for (const Cut::Face_handle cell : cut.all_face_handles())
    cell->info() = false;
  std::vector<Cut::Face_handle> outside = {cut.infinite_face()};
  outside.front()->info() = true;
  while (!outside.empty()) {
    const Cut::Face_handle cell = outside.back();
    outside.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Cut::Face_handle next = cell->neighbor(i);
      if (next->info() || cut.is_constrained({cell, i})) continue;
      next->info() = true;
      outside.push_back(next);
    }
  }
  std::vector<Triangle> triangles;
  for (const Cut::Face_handle cell : cut.finite_face_handles()) {
    if (cell->info()) continue;
    Triangle triangle{cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info()};
    const Vec3& a = corner(mesh, triangle, 0);
    const Vec3 across = (corner(mesh, triangle, 1) - a).cross(corner(mesh, triangle, 2) - a);
    if (across.dot(area) < 0.0) std::swap(triangle[1], triangle[2]);
    triangles.push_back(triangle);
  }
  return triangles;
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

  // convex faces become fans of triangles
  constexpr std::size_t kLongestFan = 16;
  constexpr double kMostWork = 4e8;  // some four seconds
  double work = 0.0;
  constexpr std::size_t kFacesBetweenLooks = 1 << 12;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (f % kFacesBetweenLooks == 0) stop_if_interrupted();
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
    std::vector<int> face;
    for (const std::size_t i : faces[f])
      face.push_back(merged[i]);
    if (face.size() == 3 || (face.size() <= kLongestFan && is_convex(mesh, face))) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i)
        mesh.triangles.push_back({face[0], face[i], face[i + 1]});
      continue;
    }
    // the time to cut a face grows with the square of its corners
    work += static_cast<double>(face.size()) * static_cast<double>(face.size());
    if (work > kMostWork) {
      throw input_error(
          "'{}': up to face {}, which has {} corners, there are too many large faces to cut; cut "
          "them into triangles",
          name,
          f + 1,
          face.size());
    }
    const std::vector<Triangle> triangles = cut_face(mesh, face);
    if (triangles.empty()) {
      throw input_error(
          "'{}': face {} crosses or touches itself, or has no area; cut it into triangles",
          name,
          f + 1);
    }
    mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
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
