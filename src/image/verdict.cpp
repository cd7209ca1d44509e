// SPDX-License-Identifier: MIT
#include "image/verdict.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "image/ssim.h"

namespace polhode {
namespace {

void check_range(double value, double low, double high, const char* option) {
  if (value >= low && value <= high) return;
  throw input_error("must be from {} to {}, got {}", low, high, value).at({{}, 0, option});
}

std::string reason_of(const Verdict& verdict, const Thresholds& t) {
  const Difference& d = verdict.values;
  if (d.largest > largest_allowed(t)) {
    return fmt::format(
        "a value differs by {} levels of 255 (limit {})", d.largest, largest_allowed(t));
  }
  if (d.fraction_over > t.fraction) {
    return fmt::format("{} of the pixels differ by more than {} levels of 255 (allowed {})",
                       percent(d.fraction_over),
                       t.max,
                       percent(t.fraction));
  }
  if (t.ssim && *verdict.ssim < *t.ssim) {
    return fmt::format("SSIM is {:.5f} (at least {} wanted)", *verdict.ssim, *t.ssim);
  }
  if (t.flip && verdict.flip->mean > *t.flip) {
    return fmt::format("mean FLIP is {:.5f} (at most {} allowed)", verdict.flip->mean, *t.flip);
  }
  return {};
}

}  // namespace

std::string percent(double share) {
  return fmt::format("{:.3g}%", 100.0 * share);
}

int largest_allowed(const Thresholds& thresholds) {
  return std::max(thresholds.limit, thresholds.max);
}

void check_thresholds(const Thresholds& thresholds) {
  check_range(thresholds.max, 0, 255, "--max");
  check_range(thresholds.fraction, 0.0, 1.0, "--fraction");
  check_range(thresholds.limit, 0, 255, "--limit");
  if (thresholds.ssim) check_range(*thresholds.ssim, -1.0, 1.0, "--ssim");
  if (thresholds.flip) check_range(*thresholds.flip, 0.0, 1.0, "--flip");
}

Verdict judge(const Image& a, const Image& b, const Thresholds& t, Measures also, int jobs) {
  Verdict verdict{compare(a, b, t.max), {}, {}, {}};
  if (also.ssim || t.ssim) verdict.ssim = ssim(a, b, jobs);
  if (also.flip || t.flip) verdict.flip = flip(a, b, kPixelsPerDegree, jobs);
  verdict.reason = reason_of(verdict, t);
  return verdict;
}

double badness(const Verdict& verdict, const Thresholds& t) {
  // of what is allowed, the part that is used; where nothing is allowed a small part stands for it
  const auto used = [](double value, double allowed, double least) {
    return value <= allowed ? value / std::max(allowed, least)
                            : 1.0 + (value - allowed) / std::max(allowed, least);
  };
  const Difference& d = verdict.values;
  double worst = used(d.fraction_over, t.fraction, 1e-6);
  worst = std::max(worst, used(d.largest, std::max(t.limit, t.max), 1.0));
  if (t.ssim) worst = std::max(worst, used(1.0 - *verdict.ssim, 1.0 - *t.ssim, 1e-6));
  if (t.flip) worst = std::max(worst, used(verdict.flip->mean, *t.flip, 1e-6));
  return worst;
}

}  // namespace polhode
