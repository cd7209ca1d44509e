// SPDX-License-Identifier: MIT
#include "image/ssim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "base/error.h"
#include "base/system/parallel.h"
#include "base/system/wide_registers.h"
#include "image/compare.h"

namespace polhode {
namespace {

constexpr int kRadius = 5;  // pixels; a window is 11x11
constexpr int kWindow = 2 * kRadius + 1;
constexpr double kSigma = 1.5;                                      // pixels
constexpr float kC1 = static_cast<float>(0.01 * 255 * 0.01 * 255);  // (K1 L)^2
constexpr float kC2 = static_cast<float>(0.03 * 255 * 0.03 * 255);  // (K2 L)^2
constexpr float kMiddle = 128.0F;  // taken off luma: variances do not mind, digits are saved

using Bell = std::array<float, kRadius + 1>;  // of the middle and to one side

Bell gaussian() {
  std::array<double, kRadius + 1> g{};
  double sum = 0.0;
  for (std::size_t i = 0; i <= kRadius; ++i) {
    g[i] = std::exp(-0.5 * static_cast<double>(i * i) / (kSigma * kSigma));
    sum += i == 0 ? g[i] : 2.0 * g[i];
  }
  Bell weights{};
  for (std::size_t i = 0; i <= kRadius; ++i)
    weights[i] = static_cast<float>(g[i] / sum);
  return weights;
}

using Row = std::vector<float>;

// Sum s and difference d of the lumas of two rows, and their squares: means, variances and the
// covariance of the two follow from these four.
struct Quantities {
  Row s, d, ss, dd;

  explicit Quantities(std::size_t size) : s(size), d(size), ss(size), dd(size) {}
};

inline float luma(const std::uint8_t* pixel) {
  return 0.2126F * static_cast<float>(pixel[0]) + 0.7152F * static_cast<float>(pixel[1]) +
         0.0722F * static_cast<float>(pixel[2]) - kMiddle;
}

POLHODE_WIDE_REGISTERS
void take_lumas(const std::uint8_t* a, const std::uint8_t* b, std::size_t width, Quantities& q) {
  for (std::size_t x = 0; x < width; ++x, a += 4, b += 4) {
    const float one = luma(a), other = luma(b);
    q.s[x] = one + other;
    q.d[x] = one - other;
    q.ss[x] = q.s[x] * q.s[x];
    q.dd[x] = q.d[x] * q.d[x];
  }
}

// out[x] = weighted sum of in[x] .. in[x + 10]
POLHODE_WIDE_REGISTERS
void blur_along(const float* in, std::size_t count, const Bell& w, float* out) {
  for (std::size_t x = 0; x < count; ++x) {
    float sum = w[0] * in[x + 5];
    sum += w[1] * (in[x + 4] + in[x + 6]);
    sum += w[2] * (in[x + 3] + in[x + 7]);
    sum += w[3] * (in[x + 2] + in[x + 8]);
    sum += w[4] * (in[x + 1] + in[x + 9]);
    sum += w[5] * (in[x] + in[x + 10]);
    out[x] = sum;
  }
}

// the same over eleven rows
POLHODE_WIDE_REGISTERS
void blur_across(const std::array<const float*, kWindow>& rows,
                 std::size_t count,
                 const Bell& w,
                 float* out) {
  for (std::size_t x = 0; x < count; ++x) {
    float sum = w[0] * rows[5][x];
    sum += w[1] * (rows[4][x] + rows[6][x]);
    sum += w[2] * (rows[3][x] + rows[7][x]);
    sum += w[3] * (rows[2][x] + rows[8][x]);
    sum += w[4] * (rows[1][x] + rows[9][x]);
    sum += w[5] * (rows[0][x] + rows[10][x]);
    out[x] = sum;
  }
}

// eq. 13 of every window of a row, from the means of s, d, ss and dd; into out
POLHODE_WIDE_REGISTERS
void indices(const Quantities& mean, std::size_t count, float* out) {
  for (std::size_t x = 0; x < count; ++x) {
    const float a = 0.5F * (mean.s[x] + mean.d[x]) + kMiddle;
    const float b = 0.5F * (mean.s[x] - mean.d[x]) + kMiddle;
    const float ss = mean.ss[x] - mean.s[x] * mean.s[x];  // variance of the sum
    const float dd = mean.dd[x] - mean.d[x] * mean.d[x];  // and of the difference
    const float covariance_twice = 0.5F * (ss - dd);
    const float variances = 0.5F * (ss + dd);
    out[x] = (2.0F * a * b + kC1) * (covariance_twice + kC2) /
             ((a * a + b * b + kC1) * (variances + kC2));
  }
}

// the picture, at least as large as a window
Image continued(const Image& image) {
  if (image.width >= kWindow && image.height >= kWindow) return image;
  Image out(std::max(image.width, kWindow), std::max(image.height, kWindow));
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      std::copy_n(
          image.at(std::min(x, image.width - 1), std::min(y, image.height - 1)), 4, out.at(x, y));
    }
  }
  return out;
}

// Blurs rows of both pictures one after another and adds up the indices of their windows.
class Band {
 public:
  Band(const Image& a, const Image& b, const Bell& weights)
      : a_(a),
        b_(b),
        weights_(weights),
        width_(static_cast<std::size_t>(a.width)),
        windows_(width_ - kWindow + 1),
        row_(width_),
        mean_(windows_),
        blurred_(kWindow, Quantities(windows_)),
        index_(windows_) {}

  // the sum over windows whose first rows are [begin, end)
  double sum(int begin, int end) {
    double total = 0.0;
    int blurred_to = begin;  // rows before this are blurred
    int last_different = begin - kWindow;
    const auto look_at = [&](int y) {
      if (std::memcmp(a_.at(0, y), b_.at(0, y), 4 * width_) != 0) last_different = y;
    };
    for (int y = begin; y < begin + kWindow - 1; ++y)
      look_at(y);
    for (int y = begin; y < end; ++y) {
      const int newest = y + kWindow - 1;
      look_at(newest);
      // windows on equal rows
      if (last_different < y) {
        total += static_cast<double>(windows_);
        continue;
      }
      for (int r = std::max(blurred_to, y); r <= newest; ++r)
        blur(r);
      blurred_to = newest + 1;
      total += sum_of_row(y);
    }
    return total;
  }

 private:
  Quantities& kept(int y) { return blurred_[static_cast<std::size_t>(y % kWindow)]; }

  void blur(int y) {
    take_lumas(a_.at(0, y), b_.at(0, y), width_, row_);
    Quantities& into = kept(y);
    for (const auto which : kAll)
      blur_along((row_.*which).data(), windows_, weights_, (into.*which).data());
  }

  double sum_of_row(int y) {
    for (const auto which : kAll) {
      std::array<const float*, kWindow> rows{};
      for (int i = 0; i < kWindow; ++i)
        rows[static_cast<std::size_t>(i)] = (kept(y + i).*which).data();
      blur_across(rows, windows_, weights_, (mean_.*which).data());
    }
    indices(mean_, windows_, index_.data());
    // in single precision for a while, then in double
    double total = 0.0;
    for (std::size_t x = 0; x < windows_; x += 64) {
      float part = 0.0F;
      for (std::size_t i = x; i < std::min(windows_, x + 64); ++i)
        part += index_[i];
      total += static_cast<double>(part);
    }
    return total;
  }

  static constexpr Row Quantities::*kAll[] = {
      &Quantities::s, &Quantities::d, &Quantities::ss, &Quantities::dd};

  const Image& a_;
  const Image& b_;
  const Bell& weights_;
  std::size_t width_, windows_;
  Quantities row_, mean_;
  std::vector<Quantities> blurred_;  // row y in y % 11
  Row index_;
};

double ssim_of_opaque(const Image& a, const Image& b, int jobs) {
  if (a.width < kWindow || a.height < kWindow)
    return ssim_of_opaque(continued(a), continued(b), jobs);
  constexpr int kBand = 64;  // rows: a fixed number, so that sums do not depend on threads
  const int rows = a.height - kWindow + 1;
  const Bell weights = gaussian();
  std::vector<double> sums(static_cast<std::size_t>((rows + kBand - 1) / kBand));
  parallel_for(static_cast<long>(sums.size()), jobs, [&](long band) {
    const int begin = static_cast<int>(band) * kBand;
    sums[static_cast<std::size_t>(band)] =
        Band(a, b, weights).sum(begin, std::min(rows, begin + kBand));
  });
  double total = 0.0;
  for (const double sum : sums)
    total += sum;
  return total / (static_cast<double>(rows) * (a.width - kWindow + 1));
}

}  // namespace

double ssim(const Image& a, const Image& b, int jobs) {
  if (a.width != b.width || a.height != b.height) {
    throw input_error(
        "the pictures have different sizes: {}x{} and {}x{}", a.width, a.height, b.width, b.height);
  }
  if (a.pixels == b.pixels) return 1.0;
  if (is_opaque(a) && is_opaque(b)) return ssim_of_opaque(a, b, jobs);
  return std::min(ssim_of_opaque(laid_on(a, 0), laid_on(b, 0), jobs),
                  ssim_of_opaque(laid_on(a, 255), laid_on(b, 255), jobs));
}

}  // namespace polhode
