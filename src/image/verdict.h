// SPDX-License-Identifier: MIT
// Are two pictures the same? Three numbers say so, and two more where they are asked.
#pragma once

#include <optional>
#include <string>

#include "base/fields.h"
#include "image/compare.h"
#include "image/flip.h"

namespace polhode {

// The rule. Drawing is the same everywhere but for low bits of square roots and interpolation on
// other processors and versions of Mesa: up to 3 levels, and edge samples that fall to the other
// side: a quarter of an edge pixel's contrast with four samples a pixel.
struct Thresholds {
  int max = 3;                      // levels of 255 by which any value may differ
  double fraction = 0.0005;         // share of pixels that may differ by more ...
  int limit = 70;                   // ... but no value by more than this
  std::optional<double> ssim = {};  // least SSIM; absent: not asked
  std::optional<double> flip = {};  // greatest mean FLIP; absent: not asked
};

template <class Visitor>
void fields(Visitor& v, Thresholds& s) {
  v.field("max",
          s.max,
          Doc{"levels of 255 by which any value may differ", Unit::none, Range{0.0, 255.0}});
  v.field("fraction",
          s.fraction,
          Doc{"share of pixels that may differ by more than max", Unit::none, Range{0.0, 1.0}});
  v.field("limit",
          s.limit,
          Doc{"levels that no value may differ by more", Unit::none, Range{0.0, 255.0}});
  v.field("ssim", s.ssim, Doc{"least SSIM; not asked when absent", Unit::none, Range{-1.0, 1.0}});
  v.field("flip",
          s.flip,
          Doc{"greatest mean FLIP; not asked when absent", Unit::none, Range{0.0, 1.0}});
}

// Throws Error (input), naming the option (--max, --fraction, --limit, --ssim, --flip), for a
// number out of its range: levels 0 to 255, shares and FLIP 0 to 1, SSIM -1 to 1.
void check_thresholds(const Thresholds& thresholds);

// What is measured beyond the values that a verdict needs.
struct Measures {
  bool ssim = false;
  bool flip = false;
};

struct Verdict {
  Difference values;                // over thresholds.max
  std::optional<double> ssim = {};  // where it was measured
  std::optional<FlipMap> flip = {};
  std::string reason;  // why the pictures are different, "" when they are the same

  bool same() const { return reason.empty(); }
};

// `b` against the reference `a`. SSIM and FLIP are measured where `also` or a threshold asks.
// `jobs` threads, 0: one per processor. Throws Error (input) for pictures of different sizes.
Verdict judge(
    const Image& a, const Image& b, const Thresholds& thresholds, Measures also = {}, int jobs = 0);

// How far over its thresholds a verdict is: at most 1 for the same, larger for worse. For choosing
// the worst frame and the best reference.
double badness(const Verdict& verdict, const Thresholds& thresholds);

// 0.0123 as "1.23%", with three digits.
std::string percent(double share);

}  // namespace polhode
