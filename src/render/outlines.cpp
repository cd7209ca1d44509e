// SPDX-License-Identifier: MIT
#include "render/outlines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

namespace polhode {
namespace {

constexpr float kSameShade = 0.98f;  // cosine between normals that shade as one surface

// one number for each corner, however often it is listed
class Corners {
 public:
  explicit Corners(float size) : grid_(1.0f / (1e-5f * std::max(size, 1e-30f))) {}
  std::uint32_t of(const glm::vec3& p, std::vector<glm::vec3>& points) {
    const auto whole = [&](float x) {
      return static_cast<std::uint64_t>(std::llround(x * grid_)) & 0x1fffff;
    };
    const std::uint64_t key = whole(p.x) | (whole(p.y) << 21) | (whole(p.z) << 42);
    const auto [found, added] = numbers_.try_emplace(key, points.size());
    if (added) points.push_back(p);
    return found->second;
  }

 private:
  float grid_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

// In place of its depth, a pixel that edges cross has its number among those pixels, below zero,
// until all are mixed: a map of its own would be out of the cache.
float mark_of(std::size_t number) {
  return -1.0f - static_cast<float>(number);
}
std::size_t number_of(float mark) {
  return static_cast<std::size_t>(-1.0f - mark);
}

}  // namespace

MeshEdges::MeshEdges(const Mesh& mesh) {
  for (const Vertex& v : mesh.vertices) {
    const glm::vec3 away = glm::abs(v.position);
    reach_ = std::max({reach_, away.x, away.y, away.z});
  }
  Corners corners(reach_);
  std::vector<std::uint32_t> corner_of(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    corner_of[i] = corners.of(mesh.vertices[i].position, points_);

  struct Side {
    std::uint32_t face;
    std::array<glm::vec3, 2> normals;  // at the end with the smaller number, at the other
    int count = 1;
    Edge edge;
    bool sharp = false;
  };
  std::unordered_map<std::uint64_t, Side> sides;
  sides.reserve(mesh.indices.size() / 2);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::array<std::uint32_t, 3> v = {
        mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
    const std::array<glm::vec3, 3> p = {
        mesh.vertices[v[0]].position, mesh.vertices[v[1]].position, mesh.vertices[v[2]].position};
    const glm::vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    if (corner_of[v[0]] == corner_of[v[1]] || corner_of[v[1]] == corner_of[v[2]] ||
        corner_of[v[2]] == corner_of[v[0]])
      continue;
    const auto face = static_cast<std::uint32_t>(planes_.size());
    planes_.emplace_back(normal, -glm::dot(normal, p[0]));
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t a = v[k], b = v[(k + 1) % 3];
      if (corner_of[a] > corner_of[b]) std::swap(a, b);
      const std::uint64_t key = (std::uint64_t{corner_of[a]} << 32) | corner_of[b];
      const std::array<glm::vec3, 2> normals = {mesh.vertices[a].normal, mesh.vertices[b].normal};
      const auto [found, added] = sides.try_emplace(
          key, Side{face, normals, 1, {{corner_of[a], corner_of[b]}, {face, face}, true}, false});
      if (added) continue;
      Side& side = found->second;
      ++side.count;
      side.edge.faces[1] = face;
      side.edge.border = side.count != 2;
      side.sharp = glm::dot(side.normals[0], normals[0]) < kSameShade ||
                   glm::dot(side.normals[1], normals[1]) < kSameShade;
    }
  }
  for (const auto& [key, side] : sides)
    (side.edge.border || side.sharp ? sharp_ : smooth_).push_back(side.edge);
  // neighbours in the mesh are neighbours in the picture, and in memory
  for (std::vector<Edge>* edges : {&sharp_, &smooth_}) {
    std::sort(
        edges->begin(), edges->end(), [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
  }
}

namespace {

// p or, if the near plane is before it, where that cuts the way from there to q; clip coordinates
glm::vec4 in_front(const glm::vec4& p, const glm::vec4& q) {
  const float behind = -(p.z + p.w);
  if (behind <= 0.0f) return p;
  return p + (q - p) * (behind / (behind + q.z + q.w));
}

}  // namespace

void OutlineSmoother::begin(const View& view, const PixelBox& place) {
  view_ = view;
  place_ = place;
  shells_.clear();
  pieces_.clear();
  const glm::vec4 z = glm::row(view.clip_from_world, 2);
  const glm::vec4 w = glm::row(view.clip_from_world, 3);
  const glm::vec3 forward(w);
  depth_scale_ = glm::dot(glm::vec3(z), forward) / glm::dot(forward, forward);
  depth_offset_ = z.w - depth_scale_ * w.w;
  const float focal = glm::length(glm::vec3(glm::row(view.clip_from_world, 1)));
  pixel_ = 2.0f / (focal * static_cast<float>(place.height));
}

void OutlineSmoother::add(const MeshEdges& edges, const DrawItem& item) {
  if (!item.material.opaque()) {
    // the far and the near side of a surface come one by one and have the same outlines
    const std::pair<const Mesh*, glm::mat4> shell{item.mesh.get(), item.world_from_mesh};
    if (std::find(shells_.begin(), shells_.end(), shell) != shells_.end()) return;
    shells_.push_back(shell);
  }
  const glm::vec3 eye(glm::inverse(item.world_from_mesh) * glm::vec4(view_.eye, 1.0f));
  const glm::mat4 clip_from_mesh = view_.clip_from_world * item.world_from_mesh;
  const glm::vec2 corner(place_.x, place_.y);
  const glm::vec2 size(place_.width, place_.height);
  const auto on_picture = [&](const glm::vec4& clip) {
    return corner + (0.5f + glm::vec2(0.5f, -0.5f) * glm::vec2(clip) / clip.w) * size;
  };
  // a surface just inside its outline is nearer than the outline: by what a ball somewhat larger
  // than the thing rises within a pixel
  const glm::mat3 linear(item.world_from_mesh);
  const float reach =
      edges.reach() *
      std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
  const float radius = 1.5f * std::min(reach, 1.0f);
  const auto depth = [&](float w) {
    const float nearer = std::max(0.5f * w, w - std::sqrt(2.0f * radius * pixel_ * w));
    return 0.5f + 0.5f * (depth_scale_ + depth_offset_ / nearer);
  };
  edges.each_seen(eye, [&](const glm::vec3& a, const glm::vec3& b) {
    const glm::vec4 begins = clip_from_mesh * glm::vec4(a, 1.0f);
    const glm::vec4 ends = clip_from_mesh * glm::vec4(b, 1.0f);
    // what is behind the near plane, as part of a large floor may be, is cut off
    if (begins.z + begins.w <= 0.0f && ends.z + ends.w <= 0.0f) return;
    const glm::vec4 from = in_front(begins, ends), to = in_front(ends, begins);
    pieces_.push_back({on_picture(from), on_picture(to), depth(from.w), depth(to.w)});
  });
}

std::vector<PixelBox> OutlineSmoother::covered() const {
  constexpr int kRows = 32;      // of a band, counted from the top of the picture
  constexpr float kRoom = 2.0f;  // pixels on each side
  const int first = place_.y / kRows;
  const int last = (place_.bottom() - 1) / kRows;
  struct Span {
    float low = std::numeric_limits<float>::infinity();
    float high = -std::numeric_limits<float>::infinity();
  };
  std::vector<Span> spans(static_cast<std::size_t>(std::max(0, last - first + 1)));
  const auto band_of = [&](float y) {
    const float band = std::floor(y / static_cast<float>(kRows));
    return static_cast<int>(std::clamp(band, static_cast<float>(first), static_cast<float>(last)));
  };
  for (const EdgePart& piece : pieces_) {
    const bool down = piece.from.y <= piece.to.y;
    const glm::vec2& high = down ? piece.from : piece.to;
    const glm::vec2& low = down ? piece.to : piece.from;
    const float height = std::max(low.y - high.y, 1e-3f);
    const int end = band_of(low.y + kRoom);
    for (int band = band_of(high.y - kRoom); band <= end; ++band) {
      // the part of the piece that is near these rows
      const auto top = static_cast<float>(band * kRows);
      const auto way = [&](float y) {
        return std::clamp((y - high.y) / height, 0.0f, 1.0f);
      };
      const float begins = high.x + way(top - kRoom) * (low.x - high.x);
      const float ends = high.x + way(top + static_cast<float>(kRows) + kRoom) * (low.x - high.x);
      Span& span = spans[static_cast<std::size_t>(band - first)];
      span.low = std::min({span.low, begins, ends});
      span.high = std::max({span.high, begins, ends});
    }
  }
  std::vector<PixelBox> boxes;
  for (int band = first; band <= last; ++band) {
    const auto& [low, high] = spans[static_cast<std::size_t>(band - first)];
    if (low > high) continue;
    const auto within = [&](float x) {
      return std::clamp(x, static_cast<float>(place_.x), static_cast<float>(place_.right()));
    };
    const int left = static_cast<int>(std::floor(within(low - kRoom)));
    const int right = static_cast<int>(std::ceil(within(high + kRoom)));
    const PixelBox box = common(place_, {left, band * kRows, right - left, kRows});
    if (!box.empty()) boxes.push_back(box);
  }
  return boxes;
}

void OutlineSmoother::collect(const EdgePart& piece, std::vector<float>& depth) {
  // along its longer side, from one column (or row) of pixels to the next
  const glm::vec2 sides = glm::abs(piece.to - piece.from);
  const int along = sides.x >= sides.y ? 0 : 1;
  const int across = 1 - along;
  const bool forward = piece.from[along] < piece.to[along];
  const glm::vec2 corner(box_.x, box_.y);
  const glm::vec2 first = (forward ? piece.from : piece.to) - corner;
  const glm::vec2 last = (forward ? piece.to : piece.from) - corner;
  const float depth_first = forward ? piece.depth_from : piece.depth_to;
  const float depth_last = forward ? piece.depth_to : piece.depth_from;
  const float length = last[along] - first[along];
  if (!(length > 0.0f)) return;
  const float slope = (last[across] - first[across]) / length;
  const float steep = std::abs(slope);
  const float reach = 0.5f + 0.5f * steep;  // of the edge, in pixels across

  const int long_side = along == 0 ? box_.width : box_.height;
  const int short_side = along == 0 ? box_.height : box_.width;
  const auto pixel_after = [](float x) {
    return static_cast<int>(std::ceil(x - 0.5f));
  };
  const int begin = pixel_after(std::max(first[along], 0.0f));
  const int end = pixel_after(std::min(last[along], static_cast<float>(long_side)));
  for (int i = begin; i < end; ++i) {
    const float way = (static_cast<float>(i) + 0.5f - first[along]) / length;
    const float edge = first[across] + way * (last[across] - first[across]);
    const float z = depth_first + way * (depth_last - depth_first);
    const int low = pixel_after(std::max(edge - reach, 1.0f));
    const int high = pixel_after(std::min(edge + reach, static_cast<float>(short_side - 1)));
    for (int j = low; j < high; ++j) {
      const int x = along == 0 ? i : j;
      const int y = along == 0 ? j : i;
      float& here = depth[index_of(x, y)];
      const bool known = here < 0.0f;
      const float seen = known ? crossed_[number_of(here)].depth : here;
      if (seen < z) continue;  // hidden
      // the part of the pixel beyond the edge: a trapezium, or a triangle at a corner
      const float off = edge - (static_cast<float>(j) + 0.5f);
      const float middle = 0.5f - std::abs(off);
      const float most = middle + 0.5f * steep;
      const float share = middle >= 0.5f * steep ? middle : 0.5f * most * most / steep;
      // pieces that lie on each other count once; when the edge meets the middle of the pixel, the
      // rasteriser may have taken either side, so both neighbours count
      constexpr float kMiddle = 1.0f / 64.0f;  // pixels; it rounds to 1 / 256
      if (!known) {
        here = mark_of(crossed_.size());
        crossed_.push_back({x, y, seen, {}});
      }
      float* shares = &crossed_[number_of(here)].shares[2 * static_cast<std::size_t>(across)];
      if (off > -kMiddle) shares[0] = std::max(shares[0], share);
      if (off < kMiddle) shares[1] = std::max(shares[1], share);
    }
  }
}

std::size_t OutlineSmoother::index_of(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(box_.width) +
         static_cast<std::size_t>(x);
}

void OutlineSmoother::smooth(const PixelBox& box, std::vector<float>& depth, Image& image) {
  box_ = box;
  crossed_.clear();
  for (const EdgePart& piece : pieces_)
    collect(piece, depth);

  // all colours are those from before; shares in parts of 1024
  constexpr int kWhole = 1024;
  constexpr std::array<std::array<int, 2>, 4> kNeighbours = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  mixed_.clear();
  for (const Crossed& pixel : crossed_) {
    const std::uint8_t* own = image.at(box_.x + pixel.x, box_.y + pixel.y);
    std::array<int, 4> sum{};
    int shares = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const int share = static_cast<int>(pixel.shares[k] * kWhole);
      if (share == 0) continue;
      const auto [dx, dy] = kNeighbours[k];
      const std::uint8_t* other = image.at(box_.x + pixel.x + dx, box_.y + pixel.y + dy);
      shares += share;
      for (std::size_t c = 0; c < 4; ++c)
        sum[c] += share * other[c];
    }
    const int rest = std::max(0, kWhole - shares);
    std::array<std::uint8_t, 4> value{};
    for (std::size_t c = 0; c < 4; ++c) {
      const int mixed = sum[c] + rest * own[c];
      // a constant divides faster
      value[c] = static_cast<std::uint8_t>(rest > 0 ? (mixed + kWhole / 2) / kWhole
                                                    : (mixed + shares / 2) / shares);
    }
    mixed_.push_back(value);
  }
  for (std::size_t i = 0; i < crossed_.size(); ++i) {
    const Crossed& pixel = crossed_[i];
    depth[index_of(pixel.x, pixel.y)] = pixel.depth;
    std::copy(mixed_[i].begin(), mixed_[i].end(), image.at(box_.x + pixel.x, box_.y + pixel.y));
  }
}

}  // namespace polhode
