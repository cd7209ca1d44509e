// SPDX-License-Identifier: MIT
// Longer than most: one published metric, in the order of its paper.
// Section and equation numbers are those of the paper named in the header.
#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/color.h"
#include "base/error.h"
#include "base/system/interrupt.h"
#include "base/system/parallel.h"
#include "base/system/wide_registers.h"
#include "image/compare.h"

namespace polhode {
namespace {

constexpr float kColorExponent = 0.7F;   // qc
constexpr float kKnee = 0.4F;            // pc: this share of the largest error ...
constexpr float kKneeValue = 0.95F;      // pt: ... takes this share of the range
constexpr double kFeatureWidth = 0.082;  // w, degrees; the exponent qf = 0.5 is a square root
constexpr double kPi2 = 9.8696044010893586;

// linear BT.709 to XYZ, and its rows' sums: white, D65 as (0.3127, 0.3290)
constexpr float kToXyz[3][3] = {
    {10135552.0F / 24577794.0F, 8788810.0F / 24577794.0F, 4435075.0F / 24577794.0F},
    {2613072.0F / 12288897.0F, 8788810.0F / 12288897.0F, 887015.0F / 12288897.0F},
    {1425312.0F / 73733382.0F, 8788810.0F / 73733382.0F, 70074185.0F / 73733382.0F}};
constexpr float kWhite[3] = {kToXyz[0][0] + kToXyz[0][1] + kToXyz[0][2],
                             kToXyz[1][0] + kToXyz[1][1] + kToXyz[1][2],
                             kToXyz[2][0] + kToXyz[2][1] + kToXyz[2][2]};

struct Color {
  float x = 0.0F, y = 0.0F, z = 0.0F;
};

// XYZ as a share of white
Color relative_xyz(const Color& rgb) {
  const auto row = [&](int i) {
    return (kToXyz[i][0] * rgb.x + kToXyz[i][1] * rgb.y + kToXyz[i][2] * rgb.z) / kWhite[i];
  };
  return {row(0), row(1), row(2)};
}

// the inverse of kToXyz, found once
std::array<std::array<float, 3>, 3> from_xyz() {
  std::array<std::array<float, 3>, 3> inverse{};
  const auto m = [](std::size_t r, std::size_t c) {
    return static_cast<double>(kToXyz[r % 3][c % 3]);
  };
  const auto minor = [&](std::size_t r, std::size_t c) {
    return m(r + 1, c + 1) * m(r + 2, c + 2) - m(r + 1, c + 2) * m(r + 2, c + 1);
  };
  const double determinant = m(0, 0) * minor(0, 0) + m(0, 1) * minor(0, 1) + m(0, 2) * minor(0, 2);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c)
      inverse[r][c] = static_cast<float>(minor(c, r) / determinant);
  }
  return inverse;
}

// CIE L*a*b* with colourfulness that falls with lightness (Hunt effect), section 4.1.3
Color hunt_lab(const Color& rgb) {
  const auto f = [](float t) {
    constexpr float kDelta = 6.0F / 29.0F;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t)
                                        : t / (3.0F * kDelta * kDelta) + 4.0F / 29.0F;
  };
  const Color xyz = relative_xyz(rgb);
  const float fx = f(xyz.x), fy = f(xyz.y), fz = f(xyz.z);
  const float lightness = 116.0F * fy - 16.0F;
  return {
      lightness, 0.01F * lightness * 500.0F * (fx - fy), 0.01F * lightness * 200.0F * (fy - fz)};
}

float hyab(const Color& a, const Color& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// The weights of a filter from its middle to one side; odd ones change their sign on the other.
using Weights = std::vector<float>;

// Everything that does not depend on the pixels.
struct Constants {
  int radius = 0;  // pixels: of the widest filter
  // contrast sensitivity: achromatic, red-green, and the two terms of blue-yellow
  Weights achromatic, red_green, blue_yellow_1, blue_yellow_2;
  Weights bell, edge, point;  // a Gaussian and its first two derivatives
  float most = 0.0F;          // the error of green against blue: cmax
  std::array<float, 256> linear{};
  std::array<std::array<float, 3>, 3> to_rgb = from_xyz();
};

// exp(-pi^2 x^2 / b), with both sides adding up to `sum`
Weights sensitivity(double b, int radius, double ppd, double sum) {
  Weights weights;
  double total = 0.0;
  std::vector<double> g;
  for (int i = 0; i <= radius; ++i) {
    const double x = i / ppd;
    g.push_back(std::exp(-kPi2 * x * x / b));
    total += i == 0 ? g.back() : 2.0 * g.back();
  }
  for (const double value : g)
    weights.push_back(static_cast<float>(value / total * sum));
  return weights;
}

// Blue-yellow has two Gaussians (eq. 3, table 1). Together they add up to 1 over the square; each
// is a product of two rows, of which the second adds up to 1.
void set_blue_yellow(Constants& c, double ppd) {
  struct Term {
    double a, b;
  };
  constexpr Term kTerms[] = {{34.1, 0.04}, {13.5, 0.025}};
  double sums[2] = {};
  for (int k = 0; k < 2; ++k) {
    const auto [a, b] = kTerms[k];
    double along = 0.0;
    for (int i = -c.radius; i <= c.radius; ++i)
      along += std::exp(-kPi2 * (i / ppd) * (i / ppd) / b);
    sums[k] = a * std::sqrt(std::sqrt(kPi2) / b) * along * along;
  }
  const double share = sums[0] / (sums[0] + sums[1]);
  c.blue_yellow_1 = sensitivity(kTerms[0].b, c.radius, ppd, std::sqrt(share));
  c.blue_yellow_2 = sensitivity(kTerms[1].b, c.radius, ppd, std::sqrt(1.0 - share));
}

// section 4.2: derivatives of a Gaussian, positive weights adding up to 1 and negative to -1
void set_features(Constants& c, double ppd) {
  const double sigma = 0.5 * kFeatureWidth * ppd;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  double bell = 0.0, edge = 0.0, up = 0.0, down = 0.0;
  std::vector<double> g;
  const auto curvature = [&](int i) {
    return (i * i / (sigma * sigma) - 1.0) * g[static_cast<std::size_t>(i)];
  };
  for (int i = 0; i <= radius; ++i) {
    const double sides = i == 0 ? 1.0 : 2.0;
    g.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
    bell += sides * g.back();
    edge += i * g.back();
    (curvature(i) > 0.0 ? up : down) += sides * std::abs(curvature(i));
  }
  for (int i = 0; i <= radius; ++i) {
    const double value = g[static_cast<std::size_t>(i)];
    c.bell.push_back(static_cast<float>(value / bell));
    c.edge.push_back(static_cast<float>(i * value / edge));
    c.point.push_back(static_cast<float>(curvature(i) / (curvature(i) > 0.0 ? up : down)));
  }
  c.radius = std::max(c.radius, radius);
}

Constants make_constants(double ppd) {
  Constants c;
  constexpr double kWidest = 0.04;  // the largest b of table 1
  c.radius = static_cast<int>(std::ceil(3.0 * std::sqrt(kWidest / (2.0 * kPi2)) * ppd));
  c.achromatic = sensitivity(0.0047, c.radius, ppd, 1.0);
  c.red_green = sensitivity(0.0053, c.radius, ppd, 1.0);
  set_blue_yellow(c, ppd);
  set_features(c, ppd);
  c.most =
      std::pow(hyab(hunt_lab({0.0F, 1.0F, 0.0F}), hunt_lab({0.0F, 0.0F, 1.0F})), kColorExponent);
  for (std::size_t i = 0; i < 256; ++i) {
    c.linear[i] = static_cast<float>(linear_of_srgb(static_cast<double>(i) / 255.0));
  }
  return c;
}

// Rows of one quantity.
class Plane {
 public:
  Plane(int width, int rows)
      : width_(static_cast<std::size_t>(width)), values_(width_ * static_cast<std::size_t>(rows)) {}
  float* row(int y) { return values_.data() + static_cast<std::size_t>(y) * width_; }

 private:
  std::size_t width_;
  std::vector<float> values_;
};

// out = sum of w[i] (right[i] +- left[i]); rows or shifted copies of one row alike
POLHODE_WIDE_REGISTERS
void begin_sum(const float* middle, float w, std::size_t count, float* out) {
  for (std::size_t x = 0; x < count; ++x)
    out[x] = w * middle[x];
}
POLHODE_WIDE_REGISTERS
void add_even(const float* left, const float* right, float w, std::size_t count, float* out) {
  for (std::size_t x = 0; x < count; ++x)
    out[x] += w * (left[x] + right[x]);
}
POLHODE_WIDE_REGISTERS
void add_odd(const float* left, const float* right, float w, std::size_t count, float* out) {
  for (std::size_t x = 0; x < count; ++x)
    out[x] += w * (right[x] - left[x]);
}

enum class Parity { even, odd };

// `at(i)` is where the values begin that lie i steps away
template <class At>
void filter(const At& at, const Weights& w, Parity parity, std::size_t count, float* out) {
  begin_sum(at(0), w[0], count, out);
  for (int i = 1; i < static_cast<int>(w.size()); ++i) {
    const float weight = w[static_cast<std::size_t>(i)];
    // what is far too small for a float's digits is left out
    if (std::abs(weight) < 1e-9F) continue;
    (parity == Parity::even ? add_even : add_odd)(at(-i), at(i), weight, count, out);
  }
}

// One picture's part of a band of rows, through both pipelines.
class BandOfPicture {
 public:
  BandOfPicture(const Image& image, const Constants& constants, int begin, int end)
      : image_(image),
        c_(constants),
        begin_(begin),
        high_(end - begin + 2 * constants.radius),
        width_(static_cast<std::size_t>(image.width)),
        y_(image.width, high_),
        rg_(image.width, high_),
        by_1_(image.width, high_),
        by_2_(image.width, high_),
        bell_(image.width, high_),
        edge_(image.width, high_),
        point_(image.width, high_) {
    filter_along();
  }

  // The colours of row y as an eye resolves them, L*a*b* with Hunt's adjustment.
  void colors(int y, std::vector<Color>& out) {
    out.resize(width_);
    std::vector<float> a(width_), rg(width_), by(width_), by_2(width_);
    across(y_, y, c_.achromatic, Parity::even, a);
    across(rg_, y, c_.red_green, Parity::even, rg);
    across(by_1_, y, c_.blue_yellow_1, Parity::even, by);
    across(by_2_, y, c_.blue_yellow_2, Parity::even, by_2);
    for (std::size_t x = 0; x < width_; ++x)
      out[x] = {a[x], rg[x], by[x] + by_2[x]};
  }

  Color lab(const Color& opponent) const {
    const float y = (opponent.x + 16.0F) / 116.0F;
    const float xyz[3] = {kWhite[0] * (y + opponent.y / 500.0F),
                          kWhite[1] * y,
                          kWhite[2] * (y - opponent.z / 200.0F)};
    const auto channel = [&](std::size_t i) {
      const float v =
          c_.to_rgb[i][0] * xyz[0] + c_.to_rgb[i][1] * xyz[1] + c_.to_rgb[i][2] * xyz[2];
      return std::clamp(v, 0.0F, 1.0F);
    };
    return hunt_lab({channel(0), channel(1), channel(2)});
  }

  // How strong edges and points are in row y.
  void features(int y, std::vector<float>& edges, std::vector<float>& points) {
    std::vector<float> along(width_), across_(width_);
    edges.resize(width_);
    points.resize(width_);
    const auto lengths = [&](std::vector<float>& out) {
      for (std::size_t x = 0; x < width_; ++x)
        out[x] = std::sqrt(along[x] * along[x] + across_[x] * across_[x]);
    };
    across(edge_, y, c_.bell, Parity::even, along);
    across(bell_, y, c_.edge, Parity::odd, across_);
    lengths(edges);
    across(point_, y, c_.bell, Parity::even, along);
    across(bell_, y, c_.point, Parity::even, across_);
    lengths(points);
  }

 private:
  // every filter of this picture along the rows of the band and of its margins
  void filter_along() {
    const auto pad = static_cast<std::size_t>(c_.radius);
    std::vector<float> y(width_ + 2 * pad), cx(y.size()), cz(y.size());
    for (int r = 0; r < high_; ++r) {
      // beyond its borders a picture is continued by its last pixels
      const int from = std::clamp(begin_ - c_.radius + r, 0, image_.height - 1);
      const std::uint8_t* pixel = image_.at(0, from);
      for (std::size_t x = pad; x < pad + width_; ++x, pixel += 4) {
        const Color t =
            relative_xyz({c_.linear[pixel[0]], c_.linear[pixel[1]], c_.linear[pixel[2]]});
        y[x] = 116.0F * t.y - 16.0F;
        cx[x] = 500.0F * (t.x - t.y);
        cz[x] = 200.0F * (t.y - t.z);
      }
      for (std::vector<float>* row : {&y, &cx, &cz}) {
        std::fill_n(row->begin(), pad, (*row)[pad]);
        std::fill_n(row->end() - static_cast<long>(pad), pad, (*row)[pad + width_ - 1]);
      }
      const auto along = [&](const std::vector<float>& in, const Weights& w, Parity p, Plane& out) {
        const float* middle = in.data() + pad;
        filter([&](int i) { return middle + i; }, w, p, width_, out.row(r));
      };
      along(y, c_.achromatic, Parity::even, y_);
      along(cx, c_.red_green, Parity::even, rg_);
      along(cz, c_.blue_yellow_1, Parity::even, by_1_);
      along(cz, c_.blue_yellow_2, Parity::even, by_2_);
      // features are those of lightness from 0 to 1
      for (float& value : y)
        value = (value + 16.0F) / 116.0F;
      along(y, c_.bell, Parity::even, bell_);
      along(y, c_.edge, Parity::odd, edge_);
      along(y, c_.point, Parity::even, point_);
    }
  }

  void across(Plane& plane, int y, const Weights& w, Parity parity, std::vector<float>& out) const {
    const int r = y - begin_ + c_.radius;
    filter([&](int i) { return plane.row(r + i); }, w, parity, width_, out.data());
  }

  const Image& image_;
  const Constants& c_;
  int begin_, high_;
  std::size_t width_;
  Plane y_, rg_, by_1_, by_2_, bell_, edge_, point_;
};

// section 4.1.4: most of the range is for the lower errors, which are the common ones
float redistributed(float error, float most) {
  const float knee = kKnee * most;
  if (error < knee) return kKneeValue / knee * error;
  return kKneeValue + (error - knee) / (most - knee) * (1.0F - kKneeValue);
}

// are all rows equal that the band depends on?
bool same_rows(const Image& a, const Image& b, int begin, int end) {
  const int first = std::max(0, begin), last = std::min(a.height, end);
  return std::memcmp(
             a.at(0, first),
             b.at(0, first),
             4 * static_cast<std::size_t>(a.width) * static_cast<std::size_t>(last - first)) == 0;
}

// errors of rows [begin, end) into the map; returns their sum
double fill_band(const Image& reference,
                 const Image& test,
                 const Constants& c,
                 int begin,
                 int end,
                 FlipMap& map) {
  const auto width = static_cast<std::size_t>(map.width);
  float* out = map.errors.data() + static_cast<std::size_t>(begin) * width;
  if (same_rows(reference, test, begin - c.radius, end + c.radius)) return 0.0;
  BandOfPicture one(reference, c, begin, end), other(test, c, begin, end);
  std::vector<Color> colors_1, colors_2;
  std::vector<float> edges_1, edges_2, points_1, points_2;
  double sum = 0.0;
  for (int y = begin; y < end; ++y, out += width) {
    one.colors(y, colors_1);
    other.colors(y, colors_2);
    one.features(y, edges_1, points_1);
    other.features(y, edges_2, points_2);
    for (std::size_t x = 0; x < width; ++x) {
      const Color& p = colors_1[x];
      const Color& q = colors_2[x];
      if (p.x == q.x && p.y == q.y && p.z == q.z) continue;
      const float apart = std::pow(hyab(one.lab(p), other.lab(q)), kColorExponent);
      const float feature =
          std::max(std::abs(edges_1[x] - edges_2[x]), std::abs(points_1[x] - points_2[x]));
      // eq. 10: the exponent qf is one half
      const float raised = 1.0F - std::sqrt(std::sqrt(0.5F) * feature);
      out[x] = std::pow(redistributed(apart, c.most), raised);
      sum += static_cast<double>(out[x]);
    }
  }
  return sum;
}

FlipMap flip_of_opaque(const Image& reference, const Image& test, const Constants& c, int jobs) {
  constexpr int kBand = 48;  // rows: a fixed number, so that sums do not depend on threads
  FlipMap map{reference.width, reference.height, {}, 0.0};
  map.errors.resize(reference.pixels.size() / 4);
  std::vector<double> sums(static_cast<std::size_t>((map.height + kBand - 1) / kBand));
  parallel_for(static_cast<long>(sums.size()), jobs, [&](long band) {
    stop_if_interrupted();
    const int begin = static_cast<int>(band) * kBand;
    sums[static_cast<std::size_t>(band)] =
        fill_band(reference, test, c, begin, std::min(map.height, begin + kBand), map);
  });
  for (const double sum : sums)
    map.mean += sum;
  map.mean /= std::max(1.0, static_cast<double>(map.errors.size()));
  return map;
}

constexpr std::uint8_t kMagma[256][3] = {
#include "image/magma.inc"
};

}  // namespace

FlipMap flip(const Image& reference, const Image& test, double pixels_per_degree, int jobs) {
  if (reference.width != test.width || reference.height != test.height) {
    throw input_error("the pictures have different sizes: {}x{} and {}x{}",
                      reference.width,
                      reference.height,
                      test.width,
                      test.height);
  }
  const Constants c = make_constants(pixels_per_degree);
  if (is_opaque(reference) && is_opaque(test)) return flip_of_opaque(reference, test, c, jobs);
  FlipMap black = flip_of_opaque(laid_on(reference, 0), laid_on(test, 0), c, jobs);
  FlipMap white = flip_of_opaque(laid_on(reference, 255), laid_on(test, 255), c, jobs);
  return black.mean >= white.mean ? black : white;
}

Image heat_picture(const FlipMap& map) {
  Image out(map.width, map.height);
  for (std::size_t i = 0; i < map.errors.size(); ++i) {
    const float level = 255.0F * std::clamp(map.errors[i], 0.0F, 1.0F) + 0.5F;
    std::copy_n(kMagma[static_cast<std::size_t>(level)], 3, out.pixels.data() + 4 * i);
    out.pixels[4 * i + 3] = 255;
  }
  return out;
}

}  // namespace polhode
